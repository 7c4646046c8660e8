//! Why a search ended, on the wire.

use serde::Serialize;
use terramechanics_optimum::StopReason;
use utoipa::ToSchema;

/// Why a search ended.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, ToSchema)]
#[serde(rename_all = "snake_case")]
#[schema(as = OptimumStop)]
pub(super) enum StopReply {
    /// Its steps became a hundred-millionth of the bounds, and another search from there found nothing better.
    SmallStep,
    /// The evaluations were spent.
    Evaluations,
    /// Rounding keeps it from a better point.
    Rounding,
}

impl StopReply {
    pub(super) fn name(self) -> &'static str {
        match self {
            Self::SmallStep => "small_step",
            Self::Evaluations => "evaluations",
            Self::Rounding => "rounding",
        }
    }
}

impl From<StopReason> for StopReply {
    fn from(stop: StopReason) -> Self {
        match stop {
            StopReason::SmallStep => Self::SmallStep,
            StopReason::Evaluations => Self::Evaluations,
            StopReason::Rounding => Self::Rounding,
        }
    }
}
