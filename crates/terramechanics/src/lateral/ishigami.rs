//! How does a wheel push sideways? Lateral shear under it, and soil bulldozed by its side wall.
//!
//! Ishigami, Miwa, Nagatani & Yoshida 2005 (JSME Robomech 1A1-S-055, Eqs. 10–12) and 2007 (J. Field Robotics 24):
//!
//! | equation | here |
//! |---|---|
//! | j_y = r (1 − s)(θ1 − θ) tan β | [`displacement`] |
//! | E_y of τ_y = (c + σ tan φ)(1 − exp(−j_y/K_y)) | [`lateral_share`] |
//! | R_b = D1 (c h + D2 γ h²/2) | [`SideWall::resistance`] |
//! | F_y = ∫ {r b τ_y + R_b (r − h cos θ)} dθ | `forces/side` |
//!
//! Units: SI; γ is a unit weight (N/m³), R_b a force per length of rim (N/m).
//!
//! The factor 1/2. The 2005 paper prints R_b = D1 (c h + D2 γ h²) with D2 = 2.55 at φ = 37.2°; the 2007 paper has 1/2 in the
//! weight term. D2 = cot X_c + cot² X_c / cot φ is 5.095 at that angle. So the 2005 value includes the 1/2, and the two papers
//! have the same formula.
//!
//! A check against Rankine. With X_c = π/4 − φ/2, cot X_c = tan(X_c + φ) = √K_p, the root of Rankine's passive coefficient. So
//! D1 = 2 √K_p is exactly Rankine's cohesion term. D1 D2/2 = K_p (1 + √K_p tan φ) is 2 (1 + √K_p tan φ) times his weight term
//! K_p/2, because soil heaped up in front of the wall adds to the wedge.
//!
//! Departures: the shear law is that of the soil, Janosi–Hanamoto's is the published one; a braking wheel has κ = 1/(1 + s)
//! in place of 1 − s; on a wheel with lugs τ_y acts at the shearing radius, as τ does, and j_y is counted from where the circle of
//! j enters the soil (`circles.rs`).

use super::SlipAngle;
use crate::patch::ContactPatch;
use crate::rim::RimPoint;
use crate::soil::Soil;

/// |j_y| (m) at a rim point of a turning wheel.
#[inline]
pub(super) fn displacement(patch: &ContactPatch<'_>, point: &RimPoint, angle: SlipAngle) -> f64 {
    let rolling = patch.rolling;
    rolling.kinematics.radius * rolling.kinematics.ratio * patch.sheared_arc(point) * angle.steepness()
}

/// E_y (–) at a rim point, without sign. A locked wheel has an infinite displacement and so the residual share.
#[inline]
pub(super) fn lateral_share(patch: &ContactPatch<'_>, point: &RimPoint, angle: SlipAngle) -> f64 {
    let shear = patch.rolling.shear();
    if patch.rolling.slip.is_locked() {
        if angle.steepness() > 0.0 { shear.residual() } else { 0.0 }
    } else {
        shear.mobilisation(displacement(patch, point, angle) * patch.rolling.per_lateral_modulus())
    }
}

/// Arc (rad) behind the entry over which E_y builds up; infinite where it is constant.
pub(super) fn layer(patch: &ContactPatch<'_>, angle: SlipAngle) -> f64 {
    let rolling = patch.rolling;
    let growth = rolling.kinematics.radius * rolling.kinematics.ratio * angle.steepness();
    if rolling.slip.is_locked() || growth == 0.0 { f64::INFINITY } else { 1.0 / (growth * rolling.per_lateral_modulus()) }
}

/// The resistance of the soil to a side wall that is pushed into it.
#[derive(Debug, Clone, Copy)]
pub(crate) struct SideWall {
    /// D1 c (N/m²).
    cohesive: f64,
    /// D1 D2 γ/2 (N/m³).
    weighty: f64,
}

impl SideWall {
    /// The side wall in this soil; none where the unit weight of the soil is not known.
    pub(crate) fn of(soil: &Soil) -> Option<Self> {
        let unit_weight = soil.unit_weight()?;
        let Factors { d1, d2 } = Factors::of(soil.tan_friction());
        Some(Self { cohesive: d1 * soil.cohesion(), weighty: 0.5 * d1 * d2 * unit_weight })
    }

    /// R_b (N/m): force per length of a wall that reaches down to `depth` h (m).
    #[inline]
    pub(crate) fn resistance(&self, depth: f64) -> f64 {
        depth * (self.cohesive + self.weighty * depth)
    }
}

/// D1 and D2 (–).
struct Factors {
    d1: f64,
    d2: f64,
}

impl Factors {
    /// At tan φ: with X_c = π/4 − φ/2, cot X_c = tan(X_c + φ) = tan φ + 1/cos φ.
    fn of(tan_friction: f64) -> Self {
        let cot_x = tan_friction + tan_friction.hypot(1.0);
        Self { d1: 2.0 * cot_x, d2: cot_x + cot_x * cot_x * tan_friction }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Digits printed.
    const PRINTED: f64 = 5e-4;

    #[test]
    fn the_factors_are_those_of_the_paper() {
        // 37.2°: D1 = 4.03 and, with the factor 1/2 included, D2 = 2.55 (Ishigami et al. 2005); further digits re-derived.
        let Factors { d1, d2 } = Factors::of(37.2_f64.to_radians().tan());
        assert!((d1 - 4.029).abs() < PRINTED && (d2 - 5.095).abs() < PRINTED, "{d1}, {d2}");
        assert_eq!((format!("{d1:.2}"), format!("{:.2}", 0.5 * d2)), ("4.03".to_owned(), "2.55".to_owned()));
    }

    #[test]
    fn the_factors_are_the_printed_functions_of_the_friction_angle() {
        for phi in [1e-9_f64, 0.2, 0.65, 1.2] {
            let x = std::f64::consts::FRAC_PI_4 - 0.5 * phi;
            let cot = 1.0 / x.tan();
            let Factors { d1, d2 } = Factors::of(phi.tan());
            assert!((d1 / (cot + (x + phi).tan()) - 1.0).abs() < 1e-14);
            assert!((d2 / (cot + cot * cot * phi.tan()) - 1.0).abs() < 1e-14);
        }
    }

    #[test]
    fn without_friction_the_cohesion_resists_as_rankine_has_it() {
        let Factors { d1, d2 } = Factors::of(0.0);
        assert_eq!((d1, d2), (2.0, 1.0));
    }
}
