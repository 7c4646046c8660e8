//! How firm is the soil under a small wheel? Meirion-Griffith & Spenko (2011): p = k z^n D^m.

use super::{PlateConditions, SinkageExponent};

/// The law with the wheel's diameter: K_s = k (2r)^m. Meant for wheels below about 0.5 m in diameter.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Diameter {
    /// Coefficient k (N/m^(n+m+2)).
    pub k: f64,
    /// Exponent m of the diameter (–).
    pub m: f64,
    /// Sinkage exponent.
    pub exponent: SinkageExponent,
}

impl Diameter {
    pub(super) fn sinkage_modulus(&self, conditions: &PlateConditions) -> f64 {
        self.k * conditions.diameter.powf(self.m)
    }
}
