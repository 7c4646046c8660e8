//! Forces of stresses that are linear on both sides of the peak (Shibly et al. 2005; letter, Eqs. 7, 11, 12).
//!
//! At θm = θ1/2 they carry about 12 % less F_z than the quadrature.

use super::{Components, ForceModel, Forces, PeakDepth, ShapeIntegrals, peak_stresses};
use crate::stress::ContactPatch;

pub(super) fn forces(model: &ForceModel, patch: &ContactPatch<'_>, peak_depth: PeakDepth) -> Forces {
    closed_form(model, patch, peak_depth, &ShapeIntegrals::of(&patch.angles))
}

/// Eq. (11) from the stresses at the peak and the shape integrals.
pub(super) fn closed_form(model: &ForceModel, patch: &ContactPatch<'_>, peak_depth: PeakDepth, shape: &ShapeIntegrals) -> Forces {
    let wheel = &patch.rolling.system.wheel;
    let peak = peak_stresses(patch, peak_depth);
    let x = model.normal_stress_radius(wheel) * wheel.width() * peak.normal;
    let y = wheel.shearing_radius() * wheel.width() * peak.shear;
    let ShapeIntegrals { a, b, h } = *shape;
    let components = Components { traction: a * y, resistance: b * x, normal_support: a * x, shear_support: b * y };
    Forces::new(components, wheel.shearing_radius() * h * y, 0.0) // Eq. (11c) with r_s (erratum 6)
}
