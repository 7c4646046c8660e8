//! Why a sample has no result: its status, and the value at fault.

use super::{Channel, Status};
use crate::error::Error;

/// Why a sample has no result.
pub(super) struct Refused {
    pub(super) status: Status,
    pub(super) error: Option<Error>,
    /// The value at fault, where it is a single one.
    pub(super) culprit: Option<(Channel, f64)>,
}

impl Refused {
    pub(super) fn missing(channel: Channel) -> Self {
        Self { status: Status::MissingValue, error: None, culprit: Some((channel, f64::NAN)) }
    }

    pub(super) fn unsolved(error: Error) -> Self {
        Self { status: Status::NoSolution, error: Some(error), culprit: None }
    }

    pub(super) fn out_of_range(channel: Channel, value: f64) -> Self {
        Self { status: Status::OutOfRange, error: None, culprit: Some((channel, value)) }
    }
}

/// Refuses a value that is missing or infinite.
pub(super) fn present(channel: Channel, value: f64) -> Result<(), Refused> {
    if value.is_nan() {
        Err(Refused::missing(channel))
    } else if value.is_infinite() {
        Err(Refused::out_of_range(channel, value))
    } else {
        Ok(())
    }
}

/// Refuses a value that is missing, infinite or not greater than 0.
pub(super) fn positive(channel: Channel, value: f64) -> Result<(), Refused> {
    present(channel, value)?;
    if value > 0.0 { Ok(()) } else { Err(Refused::out_of_range(channel, value)) }
}
