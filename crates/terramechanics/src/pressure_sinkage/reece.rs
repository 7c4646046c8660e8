//! How firm is the soil, in dimensionless moduli? Reece (1965): p = (c k_c' + γ b k_phi') (z/b)^n.

use super::{PlateConditions, SinkageExponent};

/// Reece's law: K_s = (c k_c' + γ b k_phi')/b^N.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Reece {
    /// Cohesive modulus k_c' (–).
    pub k_c: f64,
    /// Frictional modulus k_phi' (–).
    pub k_phi: f64,
    /// Unit weight γ (N/m³), not negative.
    pub unit_weight: f64,
    /// Sinkage exponent.
    pub exponent: SinkageExponent,
}

impl Reece {
    pub(super) fn sinkage_modulus(&self, conditions: &PlateConditions) -> f64 {
        let PlateConditions { width, cohesion, exponent, .. } = *conditions;
        (cohesion * self.k_c + self.unit_weight * width * self.k_phi) / width.powf(exponent)
    }
}
