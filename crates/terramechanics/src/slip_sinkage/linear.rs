//! How much deeper does a slipping wheel sink, where only a slope was measured? A linear gain (Lines 2021, thesis code).

use crate::slip::Slip;

/// A linear gain of sinkage with slip.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct LinearSlipSinkage {
    /// S in z = z0 (1 + S s) (–), not negative.
    pub gain: f64,
}

impl LinearSlipSinkage {
    /// z = z0 (1 + S s).
    pub(super) fn sinkage(&self, static_sinkage: f64, slip: Slip) -> f64 {
        static_sinkage * (1.0 + self.gain * slip.ratio())
    }
}
