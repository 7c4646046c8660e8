//! What stops a search on its way.

use terramechanics::{Error, InvalidInput};

use crate::consent::Stopped;

/// Why a point of the search has no residuals.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) enum Obstacle {
    /// The model refuses a row.
    Row { row: usize, error: Error },
    /// The values are not a valid soil or contact.
    Values,
    /// The evaluations or the time are spent, or the caller does not want to go on.
    Budget,
}

impl From<InvalidInput> for Obstacle {
    fn from(_: InvalidInput) -> Self {
        Self::Values
    }
}

/// A search treats a no like a spent budget.
impl From<Stopped> for Obstacle {
    fn from(_: Stopped) -> Self {
        Self::Budget
    }
}
