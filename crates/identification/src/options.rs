//! How a fit is made.

use std::time::Instant;

use crate::loss::Loss;

/// Starts that one fit tries at most.
pub const MOST_STARTS: u32 = 32;

/// How a fit is made.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct FitOptions {
    /// Starts that are tried, up to [`MOST_STARTS`]; more are taken as that many.
    pub starts: u32,
    /// What a residual costs.
    pub loss: Loss,
    /// Evaluations of the forces after which the fit ends and says so.
    pub evaluations: u64,
    /// When the search ends at the latest and says so; without one the result is the same on every machine.
    pub until: Option<Instant>,
}

impl Default for FitOptions {
    fn default() -> Self {
        Self { starts: 1, loss: Loss::LeastSquares, evaluations: 20_000_000, until: None }
    }
}
