//! The service as its clients see it: files mirror `src/api`.

mod asking;
mod braking;
mod catalogue;
mod compare;
mod contract;
mod coupled;
mod curves;
mod documents;
mod forces;
mod identify;
mod page;
mod presets;
mod problems;
mod query;
mod readme;
mod resistances;
mod server;
mod side_force;
mod slip_sweep;
mod strength;
mod stress_profile;
mod towed;
mod track;
mod track_stream;
mod validation;
mod warnings;
