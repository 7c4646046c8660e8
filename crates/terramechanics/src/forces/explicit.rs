//! The letter's own explicit formulas (Eqs. 14–17): forces from slip and sinkage alone.
//!
//! With the published half sinkage at the peak and λ = 0 they carry 34–40 % less F_z than the quadrature on the letter's wheel
//! and sand where the peak is at the midpoint, because there the depth under the peak is about 0.75 z; with the half-sinkage
//! rule, 3–9 %.

use super::linearised::closed_form;
use super::{ForceModel, Forces, Lambda, PeakDepth, ShapeIntegrals};
use crate::stress::ContactPatch;

/// Options of the explicit method.
pub(super) struct Options {
    pub(super) peak_depth: PeakDepth,
    pub(super) lambda_a: Lambda,
    pub(super) lambda_b: Lambda,
}

pub(super) fn forces(model: &ForceModel, patch: &ContactPatch<'_>, options: &Options) -> Forces {
    closed_form(model, patch, options.peak_depth, &approximate_shape(patch, options))
}

/// A and B by Eq. (14); where λ is exact, that is what Eq. (12) gives.
fn approximate_shape(patch: &ContactPatch<'_>, options: &Options) -> ShapeIntegrals {
    let half_depth_ratio = 0.5 * patch.sinkage / patch.rolling.system.wheel.radius(); // z/(2r)
    let exact = || ShapeIntegrals::of(&patch.angles);
    ShapeIntegrals {
        a: match options.lambda_a {
            Lambda::Given(lambda) => (1.0 - lambda) * half_depth_ratio.sqrt(), // Eq. (14a)
            Lambda::Exact => exact().a,
        },
        b: match options.lambda_b {
            Lambda::Given(lambda) => (1.0 + lambda) * half_depth_ratio, // Eq. (14b), with r for π (erratum 8)
            Lambda::Exact => exact().b,
        },
        h: 0.5 * patch.angles.entry, // Eq. (17)
    }
}
