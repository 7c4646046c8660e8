//! Stresses along the rim.

use terramechanics::{
    Circles, Error, NormalStressFrom, OperatingPoint, Outcome, PressureCurve, SoilLaw, StressField, StressProfile, Stresses,
    cautions,
};

use super::request::ProfileCase;
use crate::problem::Problem;
use crate::warning::{Finding, Warning, of_point};

/// The stresses along the rim, and at their peak.
pub(crate) struct FoundProfile {
    pub(crate) circles: Circles,
    pub(crate) point: OperatingPoint,
    pub(crate) peak: Stresses,
    pub(crate) profile: StressProfile,
    /// Pressure over depth: the soil's, or what the load shows.
    pub(crate) curve: PressureCurve,
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
    let point = operation.at(motion.slip)?;
    let curve = point.curve.ok_or(Error::MissingLaw(SoilLaw::PressureSinkage))?;
    let rolling = match point.normal_stress_from {
        NormalStressFrom::Soil => operation.system.rolling(motion.slip)?,
        NormalStressFrom::Load => operation.system.rolling_under_load(motion.slip)?,
    };
    let patch = rolling.contact(point.sinkage)?;
    let stresses = StressField { patch: &patch, curve: &curve };
    let profile = StressProfile::of(&stresses, *points, *peak_depth);
    let parted = patch.has_two_zones();
    if !is_finite(&profile, !parted) {
        return Err(Error::NotFinite);
    }
    let outcome = Outcome { standstill_normal: operation.standstill_normal(), ..Outcome::from(&point) };
    let mut warnings = of_point(cautions(operation, &outcome), &operation.system, motion.heading);
    if parted {
        warnings.push(Finding::NoLinearStresses {}.into());
    }
    if *points < StressProfile::FEWEST_POINTS {
        warnings.push(Finding::PointsRaised { points: profile.theta.len() }.into());
    }
    let peak = stresses.at(patch.angles.peak);
    Ok(FoundProfile { circles: operation.system.contact.circles(), point, peak, profile, curve, warnings })
}

/// Whether the stresses are finite; the linear ones only where there are any.
fn is_finite(profile: &StressProfile, has_linear: bool) -> bool {
    let StressProfile { depth, normal, shear, normal_linear, shear_linear, .. } = profile;
    let linear = [normal_linear, shear_linear].into_iter().filter(|_| has_linear);
    [depth, normal, shear].into_iter().chain(linear).flatten().all(|value| value.is_finite())
}
