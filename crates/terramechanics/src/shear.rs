//! How much of its shear strength has the soil mobilised? Janosi & Hanamoto (1961); letter, Eqs. (5), (6).
//!
//! Departure: Eq. (6) as printed divides r by an undefined V and, braking, would grow without bound; here r/K and a signed E
//! (errata 2 and 11).

/// Janosi–Hanamoto's law with its one parameter.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct JanosiHanamoto {
    /// 1/K (1/m), the reciprocal of the shear deformation modulus.
    pub(crate) per_modulus: f64,
}

impl JanosiHanamoto {
    /// E = sgn(j) (1 − exp(−|j|/K)) from the shear displacement j (m): in [0, 1] for j ≥ 0, odd in j. Eq. (6).
    #[inline]
    pub(crate) fn mobilisation(self, displacement: f64) -> f64 {
        let x = (displacement * self.per_modulus).abs();
        // The subtraction costs one digit at 0.1 and all of them at 0; exp_m1 does not, but takes three times as long.
        let share = if x > 0.1 { 1.0 - (-x).exp() } else { -(-x).exp_m1() };
        share.copysign(displacement)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn mobilisation_is_odd_continuous_and_saturates() {
        let law = JanosiHanamoto { per_modulus: 100.0 };
        assert_eq!(law.mobilisation(0.0), 0.0);
        assert_eq!(law.mobilisation(10.0), 1.0);
        for j in [1e-12, 1e-3, 0.02] {
            assert_eq!(law.mobilisation(-j), -law.mobilisation(j));
        }
        assert!((law.mobilisation(1e-12) / 1e-10 - 1.0).abs() < 1e-9); // E → j/K
        assert!((law.mobilisation(0.01) - 0.632_120_558_828_557_7).abs() < 1e-15); // 1 − 1/e at j = K
        let joint = 0.001;
        let step = law.mobilisation(joint * (1.0 + 1e-15)) - law.mobilisation(joint * (1.0 - 1e-15));
        assert!(step.abs() < 1e-15);
    }
}
