//! How a fit is made.

use std::time::Instant;

use crate::loss::Loss;

/// Starts that one fit tries at most.
pub const MOST_STARTS: u32 = 32;

/// How a fit is made.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct FitOptions {
    /// Number of starts to try; more than [`MOST_STARTS`] count as that many.
    pub starts: u32,
    /// What a residual costs.
    pub loss: Loss,
    /// Evaluations of the forces after which the fit ends and says so.
    pub evaluations: u64,
    /// Latest end of the search, which then says so. Without one the result is the same on every machine.
    pub until: Option<Instant>,
}

impl Default for FitOptions {
    fn default() -> Self {
        Self { starts: 1, loss: Loss::LeastSquares, evaluations: 20_000_000, until: None }
    }
}
