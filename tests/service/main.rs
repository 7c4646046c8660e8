//! The service as its clients see it: files mirror `src/api`.

mod asking;
mod catalogue;
mod compare;
mod contract;
mod documents;
mod forces;
mod page;
mod problems;
mod query;
mod readme;
mod server;
mod slip_sweep;
mod stress_profile;
mod track;
