//! Stresses along the rim.

use terramechanics::{
    Error, Method, NormalStressFrom, OperatingPoint, Operation, Outcome, PressureCurve, Soil, SoilLaw, SoilParams, StressField,
    StressProfile, Stresses, WheelOnSoil, cautions,
};

use super::request::ProfileCase;
use crate::problem::Problem;
use crate::request::circles::Counted;
use crate::warning::{Finding, Warning, of_point};

/// The stresses along the rim, and at their peak.
pub(crate) struct FoundProfile {
    pub(crate) circles: Counted,
    pub(crate) point: OperatingPoint,
    pub(crate) peak: Stresses,
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
    let ProfileCase { operation, motion, points, unused, .. } = case;
    let point = operation.at(motion.slip)?;
    let in_grains = operation.model.method == Method::ResistiveForce;
    let (profile, peak, parted) = if in_grains { in_grain(case, &point) } else { by_laws(case, &point) }?;
    if !is_finite(&profile, !parted && !in_grains) {
        return Err(Error::NotFinite);
    }
    let outcome = Outcome { standstill_normal: operation.standstill_normal(), ..Outcome::from(&point) };
    let mut warnings = of_point(cautions(operation, &outcome), &operation.system, *motion);
    if parted {
        warnings.push(Finding::NoLinearStresses {}.into());
    }
    if in_grains {
        warnings.push(Finding::NoLinearStressesInGrains {}.into());
    }
    if *points < StressProfile::FEWEST_POINTS {
        warnings.push(Finding::PointsRaised { points: profile.theta.len() }.into());
    }
    warnings.extend(unused.warning());
    let circles = Counted::by(&operation.model.method, operation.system.contact.circles());
    Ok(FoundProfile { circles, point, peak, profile, warnings })
}

/// The stresses by the laws of the soil, those at their peak, and whether the contact has two zones.
fn by_laws(case: &ProfileCase, point: &OperatingPoint) -> Result<(StressProfile, Stresses, bool), Error> {
    let ProfileCase { operation: Operation { system, .. }, peak_depth, points, .. } = case;
    let curve: PressureCurve = point.curve.ok_or(Error::MissingLaw(SoilLaw::PressureSinkage))?;
    let rolling = match point.normal_stress_from {
        NormalStressFrom::Soil => system.rolling(point.slip)?,
        NormalStressFrom::Load => system.rolling_under_load(point.slip)?,
    };
    let patch = rolling.contact(point.sinkage)?;
    let stresses = StressField { patch: &patch, curve: &curve };
    let profile = StressProfile::of(&stresses, *points, *peak_depth);
    Ok((profile, stresses.at(patch.angles.peak), patch.has_two_zones()))
}

/// The same of dry grains, in the stiffness that the point has: the soil's, or what a known load shows.
fn in_grain(case: &ProfileCase, point: &OperatingPoint) -> Result<(StressProfile, Stresses, bool), Error> {
    let ProfileCase { operation: Operation { system, model, .. }, peak_depth, points, .. } = case;
    let soil = Soil::new(SoilParams { granular_stiffness: point.granular_stiffness, ..*system.soil.params() })
        .map_err(|_| Error::NotFinite)?;
    let system = WheelOnSoil { soil, ..*system };
    let rolling = model.rolling(&system, point.slip)?;
    let patch = model.contact(&rolling, point.sinkage)?;
    let profile = model.profile(&patch, *points, *peak_depth)?;
    Ok((profile, model.stresses_at(&patch, patch.angles.peak)?, false))
}

/// Whether the stresses are finite; the linear ones only where there are any.
fn is_finite(profile: &StressProfile, has_linear: bool) -> bool {
    let StressProfile { depth, normal, shear, normal_linear, shear_linear, .. } = profile;
    let linear = [normal_linear, shear_linear].into_iter().filter(|_| has_linear);
    [depth, normal, shear].into_iter().chain(linear).flatten().all(|value| value.is_finite())
}
