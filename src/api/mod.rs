//! The operations of the API, each in a room of its own: what a client may write and what becomes of it (`request`), what is
//! computed (`found`), how that stands on the wire (`reply`), and the handler with an example for the contract (`mod`).
//!
//! A new endpoint is a room here, a row in [`crate::router`] and a test.

pub(crate) mod batch;
pub(crate) mod catalogue;
pub(crate) mod compare;
pub(crate) mod coupled;
pub(crate) mod curves;
mod either;
pub(crate) mod forces;
pub(crate) mod health;
pub(crate) mod identify;
pub(crate) mod limits;
pub(crate) mod model;
pub(crate) mod operations;
pub(crate) mod optimum;
pub(crate) mod problems;
pub(crate) mod resistances;
pub(crate) mod responses;
pub(crate) mod room;
pub(crate) mod slip_sweep;
pub(crate) mod stress_profile;
pub(crate) mod sweep;
pub(crate) mod towed;
pub(crate) mod track;
pub(crate) mod uncertainty;
pub(crate) mod validation;
pub(crate) mod vehicle;
