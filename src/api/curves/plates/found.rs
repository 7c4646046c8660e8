//! Bekker's parameters through the curves of plates.

use terramechanics_identification::{PlateCurve, PlatesFit, fit_plates_while};

use super::request::{PlatesCase, plates_fault};
use crate::api::curves::open;
use crate::compute::Pace;
use crate::problem::Problem;
use crate::warning::{Finding, Warning, implausible};

/// Bekker's law through the curves of plates.
pub(crate) struct FoundPlates {
    pub(crate) curves: Vec<PlateCurve>,
    pub(crate) fitted: PlatesFit,
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
