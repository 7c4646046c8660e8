//! Stresses along the rim.

use terramechanics::{Angles, Error, Method, Outcome, Slip, StressProfile, Stresses, cautions};

use super::request::ProfileCase;
use crate::problem::Problem;
use crate::warning::{Finding, Warning, of_point};

/// The stresses along the rim, and at their peak.
pub(crate) struct FoundProfile {
    pub(crate) slip: Slip,
    pub(crate) sinkage: f64,
    pub(crate) angles: Angles,
    pub(crate) peak: Stresses,
    /// Granular stiffness (N/m³), by the method that has one.
    pub(crate) granular_stiffness: Option<f64>,
    pub(crate) profile: StressProfile,
    pub(crate) warnings: Vec<Warning>,
}

/// The stresses along the rim.
///
/// # Errors
/// What the model refuses.
pub(crate) fn profile(case: &ProfileCase) -> Result<FoundProfile, Problem> {
    solved(case).map_err(|error| Problem::refused(&error, &case.operation.sinkage))
}

fn solved(case: &ProfileCase) -> Result<FoundProfile, Error> {
    let ProfileCase { operation, motion, peak_depth, points } = case;
    let model = &operation.model;
    let rolling = model.rolling(&operation.system, motion.slip)?;
    let (sinkage, solved) = operation.sinkage_of(&rolling)?;
    let patch = model.contact(&rolling, sinkage)?;
    let profile = model.profile(&patch, *points, *peak_depth)?;
    let (parted, in_grains) = (patch.has_two_zones(), model.method == Method::ResistiveForce);
    if !is_finite(&profile, !parted && !in_grains) {
        return Err(Error::NotFinite);
    }
    let outcome = Outcome {
        slip: motion.slip,
        sinkage,
        normal: solved.map(|forces| forces.normal),
        integration_error: solved.map_or(0.0, |forces| forces.integration_error),
        mobilised_share: None,
        standstill_normal: None,
    };
    let mut warnings = of_point(cautions(operation, &outcome), &operation.system, motion.heading);
    if parted {
        warnings.push(Finding::NoLinearStresses {}.into());
    }
    if in_grains {
        warnings.push(Finding::NoLinearStressesInGrains {}.into());
    }
    if *points < StressProfile::FEWEST_POINTS {
        warnings.push(Finding::PointsRaised { points: profile.theta.len() }.into());
    }
    let peak = model.stresses_at(&patch, patch.angles.peak)?;
    let granular_stiffness = operation.system.soil.granular_stiffness().filter(|_| in_grains);
    Ok(FoundProfile { granular_stiffness, slip: motion.slip, sinkage, angles: patch.angles, peak, profile, warnings })
}

/// Whether the stresses are finite; the linear ones only where there are any.
fn is_finite(profile: &StressProfile, has_linear: bool) -> bool {
    let StressProfile { depth, normal, shear, normal_linear, shear_linear, .. } = profile;
    let linear = [normal_linear, shear_linear].into_iter().filter(|_| has_linear);
    [depth, normal, shear].into_iter().chain(linear).flatten().all(|value| value.is_finite())
}
