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
//! own; what the points miss of the layer weighs little. A layer thinner than counts is
//! taken for thicker, see [`LeadingEdge`].
//!
//! A wheel that sinks by dz has all of its edge deeper by as much, so that dF/dz is the same integral without the depth d: the same
//! points give both.
//!
//! But for its scale the integral depends on the slip and on z/r alone, so its error is known over all of both: [`ERROR`].

use super::panel::Integrals;
use super::{Components, Forces};
use crate::error::Error;
use crate::numerics::elementary::Number;
use crate::numerics::gauss_legendre::{COARSE, FINE, LaneNodes};
use crate::numerics::level::level;
use crate::patch::ContactPatch;
use crate::resistive_force::LeadingEdge;
use crate::rolling::Rolling;
use fearless_simd::prelude::*;
use fearless_simd::{Simd, dispatch, f64x8};

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

/// The contact of a wheel at `sinkage` z (m), and the forces there unless they are `known`.
///
/// # Errors
/// The same.
#[inline]
pub(crate) fn contact_in_grains<'a>(
    rolling: &'a Rolling<'a>,
    sinkage: f64,
    known: Option<Forces>,
) -> Result<(ContactPatch<'a>, Forces), Error> {
    let edge = LeadingEdge::of_unit_stiffness(rolling, sinkage)?; // θm does not depend on the stiffness
    let patch = rolling.leading_contact(sinkage, edge.peak())?;
    let forces = match known {
        Some(forces) => forces,
        None => forces(&edge.in_soil_of(rolling.system)?),
    };
    if forces.is_finite() { Ok((patch, forces)) } else { Err(Error::NotFinite) }
}

/// The same forces over the granular stiffness: forces in m³, a torque in m⁴.
///
/// # Errors
/// What [`LeadingEdge::of_unit_stiffness`] refuses.
pub(crate) fn forces_per_stiffness(rolling: &Rolling<'_>, sinkage: f64) -> Result<Forces, Error> {
    Ok(forces(&LeadingEdge::of_unit_stiffness(rolling, sinkage)?))
}

/// The forces of a wheel at `sinkage` z (m), and their changes over ln z (N), for a search of the sinkage: by few nodes for a `coarse`
/// look. None where there are no forces.
pub(crate) fn forces_and_slopes_in_grains(rolling: &Rolling<'_>, sinkage: f64, coarse: bool) -> Option<(Forces, Forces)> {
    let edge = &LeadingEdge::of(rolling, sinkage).ok()?;
    let range = edge.range;
    let ends = [0.0, (range - LONGEST).max(0.0), range];
    let [pressed, slopes] = if coarse {
        dispatch!(level(), simd => sums::<_, _, true>(simd, &COARSE, edge, edge.layer, &ends[1..]))
    } else {
        let ends = if range <= LONGEST { &ends[1..] } else { &ends };
        dispatch!(level(), simd => sums::<_, _, true>(simd, &FINE, edge, edge.layer, ends))
    };
    Some((of_edge(&pressed, edge), of_edge(&slopes, edge).scaled(sinkage)))
}

fn forces(edge: &LeadingEdge) -> Forces {
    let LeadingEdge { layer, range, .. } = *edge;
    if range <= LONGEST { forces_by(edge, layer, &[0.0, range]) } else { forces_by(edge, layer, &[0.0, range - LONGEST, range]) }
}

/// The forces by panels of u with those ends.
#[inline]
fn forces_by(edge: &LeadingEdge, scale: f64, ends: &[f64]) -> Forces {
    let [pressed, _] = dispatch!(level(), simd => sums::<_, _, false>(simd, &FINE, edge, scale, ends));
    of_edge(&pressed, edge)
}

/// The forces of integrals over the edge of the stresses over ξ.
fn of_edge(integrals: &Integrals, edge: &LeadingEdge) -> Forces {
    let pressing = edge.stiffness * edge.radius * edge.width;
    let components = Components {
        traction: pressing * integrals.shear_cos,
        resistance: pressing * integrals.normal_sin,
        normal_support: pressing * integrals.normal_cos,
        shear_support: pressing * integrals.shear_sin,
    };
    Forces::new(components, edge.radius * pressing * integrals.shear_plain, ERROR)
}

/// The integrals over panels of u with those ends, and if `CHANGING` their changes over the sinkage.
#[inline(always)]
fn sums<L: Simd, const N: usize, const CHANGING: bool>(
    simd: L,
    nodes: &[LaneNodes; N],
    edge: &LeadingEdge,
    scale: f64,
    ends: &[f64],
) -> [Integrals; 2] {
    let zero = f64x8::splat(simd, 0.0);
    let [mut pressed, mut changes] = [[zero; 5]; 2];
    for ends in ends.windows(2) {
        let (from, length) = (ends[0], ends[1] - ends[0]);
        for LaneNodes { place, weight, .. } in nodes {
            let growth = Number::exp(f64x8::simd_from(simd, *place) * length + from);
            let decay = f64x8::splat(simd, 1.0) / growth;
            let at = edge.at((growth - decay) * (0.5 * scale)); // w = e sinh u
            // dθ = dw / cos(θ/2)
            let arc = f64x8::simd_from(simd, *weight) * (growth + decay) * (0.5 * scale * length) / at.cos_half;
            add(&mut pressed, [arc * at.depth * at.normal, arc * at.depth * at.shear], [at.cos, at.sin]);
            if CHANGING {
                add(&mut changes, [arc * at.normal, arc * at.shear], [at.cos, at.sin]);
            }
        }
    }
    [Integrals::of(pressed), Integrals::of(changes)]
}

/// Adds what nodes have of σ dθ and τ dθ.
#[inline(always)]
fn add<L: Simd>(sums: &mut [f64x8<L>; 5], [normal, shear]: [f64x8<L>; 2], [cos, sin]: [f64x8<L>; 2]) {
    sums[0] += normal * cos;
    sums[1] += normal * sin;
    sums[2] += shear * cos;
    sums[3] += shear * sin;
    sums[4] += shear;
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
                let scale = edge.motion.layer().clamp(1e-14 * edge.reach, 4.0 * edge.reach);
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
