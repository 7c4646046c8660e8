//! What forces follow if both stresses are linear on either side of the peak? (Shibly et al. 2005, source 16; letter, Eqs. 7,
//! 11, 12)
//!
//! | equation | here |
//! |---|---|
//! | (11) F_x = A Y − B X, F_z = A X + B Y, T = r_s H Y, with X = r_n b σm and Y = r_s b τm | [`closed_form`] |
//! | (12) A, B and H | [`ShapeIntegrals`] |
//!
//! Units: SI, forces in N, the torque in N·m. Validity: contacts of one zone on which both stresses rise and fall about
//! linearly. The power law of the pressure bulges above a triangle, so with the peak at the midpoint linear stresses carry less
//! than the quadrature. Departures: X carries r, not r_s (erratum 3), unless asked otherwise; T carries r_s, not r (erratum 6).

use super::{Components, ForceModel, Forces, PeakDepth, ShapeIntegrals, peak_stresses};
use crate::stress::StressField;

pub(super) fn forces(model: &ForceModel, stresses: &StressField<'_>, peak_depth: PeakDepth) -> Forces {
    closed_form(model, stresses, peak_depth, &ShapeIntegrals::of(&stresses.patch.angles))
}

/// Eq. (11) from the stresses at the peak and the shape integrals.
pub(super) fn closed_form(
    model: &ForceModel,
    stresses: &StressField<'_>,
    peak_depth: PeakDepth,
    shape: &ShapeIntegrals,
) -> Forces {
    let wheel = &stresses.patch.rolling.system.wheel;
    let peak = peak_stresses(stresses, peak_depth);
    let x = model.normal_stress_radius(wheel) * wheel.width() * peak.normal;
    let y = wheel.shearing_radius() * wheel.width() * peak.shear;
    let ShapeIntegrals { a, b, h } = *shape;
    let components = Components { traction: a * y, resistance: b * x, normal_support: a * x, shear_support: b * y };
    Forces::new(components, wheel.shearing_radius() * h * y, 0.0) // Eq. (11c) with r_s (erratum 6)
}
