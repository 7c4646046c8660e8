//! The service as its clients see it: files mirror `src/api`.

mod asking;
mod catalogue;
mod compare;
mod contract;
mod documents;
mod forces;
mod page;
mod problems;
mod readme;
mod server;
mod side_force;
mod slip_sweep;
mod stress_profile;
