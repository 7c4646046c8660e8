//! Forces of the stresses of the resistive force method (`resistive_force/`), by numerical integration.
//!
//! | equation | here |
//! |---|---|
//! | F_x = b r ξ ∫ α_x d dθ, F_z = b r ξ ∫ α_z d dθ, T = b r² ξ ∫ (α_x cos θ + α_z sin θ) d dθ | [`forces`] |
//!
//! Both stresses act at the rim, whatever the wheel's lugs.
//!
//! The rule. The integrand is smooth in the chord w but for the layer at the lowest point where γ swings, of width e: there are
//! branch points at ±i e. With w = e sinh u they go to ±i π/2, far from the range of u, and the points crowd in the layer. A layer
//! much thinner than the contact makes the range of u long. Then the last part of it, where all but the layer lies, is a panel of its
//! own; what the points miss of the layer weighs little. A layer thinner than [`THINNEST`] of the contact counts as that thick.
//!
//! But for its scale the integral depends on the slip and on z/r alone, so its error is known over all of both: [`ERROR`].

use super::{Components, Forces};
use crate::error::Error;
use crate::numerics::gauss_legendre::{NODES, Node};
use crate::resistive_force::LeadingEdge;
use crate::rolling::Rolling;

/// Width of a layer over the contact below which it does not count: its share of the forces is about that.
const THINNEST: f64 = 1e-12;

/// Width of a layer over the contact above which the chord itself is as good a variable.
const WIDEST: f64 = 4.0;

/// Range of u that one panel resolves.
const LONGEST: f64 = 4.5;

/// Largest relative error of the integrals at any slip and sinkage, on the scale of the parts; a test holds it to that.
const ERROR: f64 = 1e-11;

/// The forces of a wheel at `sinkage` z (m).
///
/// # Errors
/// What [`LeadingEdge::of`] refuses; [`Error::NotFinite`] where a result overflows.
pub(crate) fn forces_in_grains(rolling: &Rolling<'_>, sinkage: f64) -> Result<Forces, Error> {
    let forces = forces(&LeadingEdge::of(rolling, sinkage)?);
    if forces.is_finite() { Ok(forces) } else { Err(Error::NotFinite) }
}

/// The same over the granular stiffness: forces in m³, a torque in m⁴.
///
/// # Errors
/// What [`LeadingEdge::of_unit_stiffness`] refuses.
pub(crate) fn forces_per_stiffness(rolling: &Rolling<'_>, sinkage: f64) -> Result<Forces, Error> {
    Ok(forces(&LeadingEdge::of_unit_stiffness(rolling, sinkage)?))
}

fn forces(edge: &LeadingEdge) -> Forces {
    let scale = edge.motion.layer().clamp(THINNEST * edge.reach, WIDEST * edge.reach);
    let range = (edge.reach / scale).asinh();
    if range <= LONGEST { forces_by(edge, scale, &[0.0, range]) } else { forces_by(edge, scale, &[0.0, range - LONGEST, range]) }
}

/// The forces by panels of u with those ends.
#[inline]
fn forces_by(edge: &LeadingEdge, scale: f64, ends: &[f64]) -> Forces {
    let mut sums = Sums::default();
    for ends in ends.windows(2) {
        sums.add(edge, scale, ends[0], ends[1]);
    }
    let area = edge.radius * edge.width;
    let components = Components {
        traction: area * sums.shear_cos,
        resistance: area * sums.normal_sin,
        normal_support: area * sums.normal_cos,
        shear_support: area * sums.shear_sin,
    };
    Forces::new(components, edge.radius * area * sums.shear_plain, ERROR)
}

/// Integrals over the leading edge.
#[derive(Default)]
struct Sums {
    /// ∫ σ cos θ dθ and ∫ σ sin θ dθ.
    normal_cos: f64,
    normal_sin: f64,
    /// ∫ τ cos θ dθ, ∫ τ sin θ dθ and ∫ τ dθ.
    shear_cos: f64,
    shear_sin: f64,
    shear_plain: f64,
}

impl Sums {
    /// Adds the panel of u between two ends.
    #[inline]
    fn add(&mut self, edge: &LeadingEdge, scale: f64, from: f64, to: f64) {
        let length = to - from;
        for Node { place, weight, .. } in &NODES {
            let growth = (from + length * place).exp();
            let decay = 1.0 / growth;
            let at = edge.at(0.5 * scale * (growth - decay)); // w = e sinh u
            let arc = length * weight * 0.5 * scale * (growth + decay) / at.cos_half; // dθ = dw / cos(θ/2)
            let (normal, shear) = (arc * at.stresses.normal, arc * at.stresses.shear);
            self.normal_cos += normal * at.cos;
            self.normal_sin += normal * at.sin;
            self.shear_cos += shear * at.cos;
            self.shear_sin += shear * at.sin;
            self.shear_plain += shear;
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::contact::Contact;
    use crate::rolling::WheelOnSoil;
    use crate::slip::Slip;
    use crate::soil::{Soil, SoilParams};
    use crate::wheel::{Wheel, WheelParams};

    /// Against panels a tenth as long, with a layer a hundred times thinner, over all slips and sinkages.
    #[test]
    fn the_error_is_no_larger_than_is_said_at_any_slip_and_sinkage() {
        let wheel = WheelParams { radius: 1.0, width: 1.0, lug_height: 0.0, lug_coefficient: 0.5 };
        let system = WheelOnSoil {
            wheel: Wheel::new(wheel).expect("a wheel"),
            soil: Soil::new(SoilParams::BARE).expect("a soil"),
            contact: Contact::MIDPOINT,
        };
        let sizes = (0..=64).map(|i| 10f64.powf(-0.25 * f64::from(i))).chain((1..50).map(|i| 0.02 * f64::from(i)));
        let slips: Vec<f64> = sizes.flat_map(|size| [size, -size, 1.0 - 0.01 * size, 0.01 * size - 1.0]).chain([0.0]).collect();
        for share in [1e-6, 1e-3, 0.03, 0.2, 0.5, 0.9, 1.0] {
            for &slip in &slips {
                let rolling = system.rolling_in_grains(Slip::new(slip).expect("a slip"));
                let edge = LeadingEdge::of_unit_stiffness(&rolling, share).expect("an edge");
                let found = forces(&edge);
                let scale = edge.motion.layer().clamp(1e-2 * THINNEST * edge.reach, WIDEST * edge.reach);
                let range = (edge.reach / scale).asinh();
                let ends: Vec<f64> = (0..=10).map(|i| range * f64::from(i) / 10.0).collect();
                let fine = forces_by(&edge, scale, &ends);
                let size = fine.normal_scale();
                for (value, exact, size) in [
                    (found.longitudinal, fine.longitudinal, size.max(fine.longitudinal_scale())),
                    (found.components.normal_support, fine.components.normal_support, size),
                    (found.components.shear_support, fine.components.shear_support, size),
                    (found.torque, fine.torque, size),
                ] {
                    let off = (value - exact).abs() / size;
                    assert!(off <= ERROR, "slip {slip}, z/r {share}: off by {off:e}");
                }
            }
        }
    }
}
