//! How firm is the soil under a plate? Bekker (1956, 1969): p = (k_c/b + k_phi) z^n.

use super::{PlateConditions, SinkageExponent};

/// Bekker's law: K_s = k_c/b + k_phi.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Bekker {
    /// Cohesive modulus k_c (N/m^(n+1)); may be negative where a fit gave that, as long as K_s stays positive.
    pub k_c: f64,
    /// Frictional modulus k_phi (N/m^(n+2)).
    pub k_phi: f64,
    /// Sinkage exponent.
    pub exponent: SinkageExponent,
}

impl Bekker {
    pub(super) fn sinkage_modulus(&self, conditions: &PlateConditions) -> f64 {
        self.k_c / conditions.width + self.k_phi // letter, caption of Fig. 1
    }
}
