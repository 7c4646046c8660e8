//! Parameters from plate tests and from shear tests.

use terramechanics_identification::{
    Estimate, PlateCurve, PlatesFit, ShearCurve, ShearFit, fit_plates_while, fit_shear_curves_while,
};

use super::identify::implausible;
use crate::compute::Pace;
use crate::problem::Problem;
use crate::request::{PlatesCase, ShearTestsCase, plates_fault, shear_fault};
use crate::warning::{Finding, Warning};

/// Bekker's law through the curves of plates.
pub(crate) struct FoundPlates {
    pub(crate) curves: Vec<PlateCurve>,
    pub(crate) fitted: PlatesFit,
    pub(crate) warnings: Vec<Warning>,
}

/// The strength through the curves of shear tests.
pub(crate) struct FoundShear {
    pub(crate) curves: Vec<ShearCurve>,
    pub(crate) fitted: ShearFit,
    pub(crate) warnings: Vec<Warning>,
}

/// Bekker's parameters from plate tests.
///
/// # Errors
/// What the curves do not tell.
pub(crate) fn plates(PlatesCase { curves, left_out }: &PlatesCase, pace: &Pace) -> Result<FoundPlates, Problem> {
    let fitted = fit_plates_while(curves, &|| pace.goes_on()).map_err(|error| Problem::Invalid(vec![plates_fault(error)]))?;
    let mut warnings = open(&fitted.estimates);
    warnings.extend(implausible(&fitted.estimates, fitted.estimates[2].value));
    if let Some(least_width) = fitted.least_width() {
        let narrowest = curves.iter().map(|curve| curve.width).fold(f64::INFINITY, f64::min);
        warnings.push(Finding::FittedCohesiveModulusNegative { least_width, narrowest }.into());
    }
    if let Some([least, largest]) = fitted.exponents_apart() {
        warnings.push(Finding::ExponentsDiffer { least, largest }.into());
    }
    if *left_out > 0 {
        warnings.push(Finding::RowsWithoutSinkage { rows: *left_out }.into());
    }
    if !fitted.is_a_soil() {
        warnings.push(Finding::LawNotUsable {}.into());
    }
    Ok(FoundPlates { curves: curves.clone(), fitted, warnings })
}

/// Strength and shear modulus from shear tests.
///
/// # Errors
/// What the curves do not tell.
pub(crate) fn shear(ShearTestsCase(curves): &ShearTestsCase, pace: &Pace) -> Result<FoundShear, Problem> {
    let fitted =
        fit_shear_curves_while(curves, &|| pace.goes_on()).map_err(|error| Problem::Invalid(vec![shear_fault(error)]))?;
    let mut warnings = open(&fitted.estimates);
    warnings.extend(implausible(&fitted.estimates, f64::NAN));
    Ok(FoundShear { curves: curves.clone(), fitted, warnings })
}

/// Warns of parameters that the data leave open or that lie at a bound.
fn open(estimates: &[Estimate]) -> Vec<Warning> {
    let open = estimates.iter().filter(|estimate| !estimate.identifiability.is_determined());
    let parameters: Vec<&str> = open.map(|estimate| estimate.unknown.name()).collect();
    let open = (!parameters.is_empty()).then_some(Finding::NotIdentifiable { parameters });
    let at_bound = estimates.iter().filter(|estimate| estimate.at_bound.is_some());
    let at_bound = at_bound.map(|estimate| Finding::AtBound { parameter: estimate.unknown.name(), end: "lower", bound: 0.0 });
    open.into_iter().chain(at_bound).map(Warning::from).collect()
}
