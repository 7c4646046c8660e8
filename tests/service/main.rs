//! The service as its clients see it: files mirror `src/api`.

mod asking;
mod catalogue;
mod compare;
mod contract;
mod curves;
mod documents;
mod forces;
mod identify;
mod page;
mod problems;
mod readme;
mod server;
mod slip_sweep;
mod stress_profile;
