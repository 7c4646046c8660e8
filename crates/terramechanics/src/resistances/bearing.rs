//! How much pressure does soil bear before it fails in general shear? Bearing capacity factors (Terzaghi 1943).
//!
//! | equation | here |
//! |---|---|
//! | N_q = e^((3π/2 − φ) tan φ)/(2 cos²(π/4 + φ/2)) | [`BearingFactors::of`] |
//! | N_c = (N_q − 1)/tan φ | [`BearingFactors::c`] |
//! | N_γ = 2 (N_q + 1) tan φ/(1 + 0.4 sin 4φ) | [`BearingFactors::gamma_per_tan`] |
//!
//! Terzaghi (source 17) read N_γ off a chart; the formula for it is Coduto's fit (2001; source 3). Of the sets in
//! use this is the one behind the known example of bulldozing: at 33° it gives the N_q = 32.23, N_c = 48.09 and N_γ = 33.27
//! that are printed there (Akin, University of Maryland). Prandtl's N_c and Reissner's N_q, in use elsewhere, are
//! smaller. Local shear, for which Terzaghi reduces c and tan φ to two thirds, is not taken.
//!
//! Validity: the charts end at 50°; the factors grow without bound towards 90°.

use std::f64::consts::PI;

/// Bearing capacity factors of a soil.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct BearingFactors {
    /// N_c, of the cohesion (–).
    pub(super) c: f64,
    /// N_γ/tan φ, of the unit weight (–): N_γ vanishes with tan φ, the ratio does not.
    pub(super) gamma_per_tan: f64,
}

impl BearingFactors {
    /// The factors at a friction angle φ (rad).
    pub(super) fn of(friction_angle: f64) -> Self {
        let (sin, tan) = (friction_angle.sin(), friction_angle.tan());
        let growth = (1.5 * PI - friction_angle) * tan;
        let q = growth.exp() / (1.0 - sin); // 2 cos²(π/4 + φ/2) = 1 − sin φ
        let q_minus_one = (growth.exp_m1() + sin) / (1.0 - sin); // keeps its digits for small φ
        let c = if tan > 0.0 { q_minus_one / tan } else { 1.5 * PI + 1.0 };
        Self { c, gamma_per_tan: 2.0 * (q + 1.0) / (1.0 + 0.4 * (4.0 * friction_angle).sin()) }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Terzaghi's table as textbooks print it: φ (°), N_c, N_q.
    const TABLE: [(f64, f64, f64); 5] =
        [(0.0, 5.71, 1.0), (10.0, 9.61, 2.69), (20.0, 17.69, 7.44), (30.0, 37.16, 22.46), (40.0, 95.66, 81.27)];

    fn q(friction_angle: f64) -> f64 {
        1.0 + BearingFactors::of(friction_angle).c * friction_angle.tan()
    }

    #[test]
    fn the_factors_are_those_of_terzaghis_table() {
        // Printed to the hundredth, and not always rounded the right way.
        for (degrees, c, n_q) in TABLE {
            let angle = degrees.to_radians();
            assert!((BearingFactors::of(angle).c - c).abs() <= 0.0101, "{degrees}: {}", BearingFactors::of(angle).c);
            assert!((q(angle) - n_q).abs() <= 0.0101, "{degrees}: {}", q(angle));
        }
    }

    /// The factors printed with the lunar rover's example (Akin), whose soil has 33°.
    #[test]
    fn the_factors_of_the_lunar_example_are_the_printed_ones() {
        let angle = 33_f64.to_radians();
        let factors = BearingFactors::of(angle);
        assert!((q(angle) - 32.23).abs() < 5e-3 && (factors.c - 48.09).abs() < 5e-3);
        assert!((factors.gamma_per_tan * angle.tan() - 33.27).abs() < 5e-3);
    }

    #[test]
    fn the_factors_are_continuous_at_no_friction() {
        let (none, little) = (BearingFactors::of(0.0), BearingFactors::of(1e-9));
        assert!((little.c / none.c - 1.0).abs() < 1e-8 && (little.gamma_per_tan / none.gamma_per_tan - 1.0).abs() < 1e-8);
        assert_eq!(none.gamma_per_tan, 4.0);
    }
}
