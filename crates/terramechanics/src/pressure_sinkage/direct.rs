//! How firm is the soil under this very wheel? A sinkage modulus measured as it is (letter, Eq. 1).

use super::SinkageExponent;

/// A sinkage modulus given directly.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Direct {
    /// Sinkage modulus K_s (Pa/m^N).
    pub k_s: f64,
    /// Sinkage exponent.
    pub exponent: SinkageExponent,
}

impl Direct {
    pub(super) fn sinkage_modulus(&self) -> f64 {
        self.k_s
    }
}
