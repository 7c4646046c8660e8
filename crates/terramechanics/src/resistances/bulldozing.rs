//! What does it take to push the soil ahead of a wheel? Bulldozing resistance of a leading wheel (Bekker 1960, after Terzaghi's
//! earth pressure; as in Patel, Scott & Ellery 2004).
//!
//! | equation | here |
//! |---|---|
//! | R_b = b sin(α + φ)/(2 sin α cos φ) (2 z c K_c + γ z² K_γ) + l0³ γ/3 (π/2 − φ) + c l0² [1 + tan(π/4 + φ/2)] | [`resistance`] |
//! | K_c = (N_c − tan φ) cos² φ, K_γ = (2 N_γ/tan φ + 1) cos² φ | [`resistance`] |
//! | α = arccos(1 − 2z/D), l0 = z tan²(π/4 − φ/2) | [`resistance`] |
//!
//! α is the angle of approach, which is the entry angle; l0 the length of soil ruptured ahead.
//!
//! Validity: wheels that run in undisturbed soil; those behind in their ruts push none. The formulas were read in course
//! material (Akin, University of Maryland), not in Bekker's book. Checked against their example, the lunar rover: 90.4 N at the
//! 17.3 mm of its 259 N, 94 N at the 18.1 mm that belong to the α and l0 printed there, where 95 N are printed.

use std::f64::consts::{FRAC_PI_2, FRAC_PI_4};

use super::Lacking;
use super::bearing::BearingFactors;
use crate::soil::Soil;
use crate::wheel::Wheel;

/// Bulldozing resistance R_b (N) at a sinkage z (m) with its entry angle α (rad).
pub(super) fn resistance(wheel: &Wheel, soil: &Soil, sinkage: f64, entry: f64) -> Result<f64, Lacking> {
    let unit_weight = soil.unit_weight().ok_or(Lacking::UnitWeight)?;
    let (cohesion, friction_angle) = (soil.cohesion(), soil.friction_angle());
    let factors = BearingFactors::of(friction_angle);
    let cos = friction_angle.cos();
    let k_c = (factors.c - soil.tan_friction()) * cos * cos;
    let k_gamma = (2.0 * factors.gamma_per_tan + 1.0) * cos * cos;
    let wedge = wheel.width() * (entry + friction_angle).sin() / (2.0 * entry.sin() * cos)
        * (2.0 * sinkage * cohesion * k_c + unit_weight * sinkage * sinkage * k_gamma);
    let ruptured = sinkage * (FRAC_PI_4 - 0.5 * friction_angle).tan().powi(2); // l0
    let sides = ruptured.powi(3) * unit_weight / 3.0 * (FRAC_PI_2 - friction_angle)
        + cohesion * ruptured * ruptured * (1.0 + (FRAC_PI_4 + 0.5 * friction_angle).tan());
    Ok(wedge + sides)
}
