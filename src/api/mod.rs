//! The operations of the API: each takes a checked request and returns an answer or a problem.

pub(crate) mod catalogue;
pub(crate) mod compare;
pub(crate) mod coupled;
pub(crate) mod forces;
pub(crate) mod health;
pub(crate) mod identify;
pub(crate) mod limits;
pub(crate) mod model;
pub(crate) mod resistances;
pub(crate) mod responses;
pub(crate) mod slip_sweep;
pub(crate) mod stress_profile;
pub(crate) mod towed;
pub(crate) mod track;
pub(crate) mod validation;
