//! The strength of a soil through the curves of shear tests.

use terramechanics_identification::{ShearCurve, ShearFit, fit_shear_curves_while};

use super::request::{ShearTestsCase, shear_fault};
use crate::api::curves::open;
use crate::compute::Pace;
use crate::problem::Problem;
use crate::warning::{Warning, implausible};

/// The strength through the curves of shear tests.
pub(crate) struct FoundShear {
    pub(crate) curves: Vec<ShearCurve>,
    pub(crate) fitted: ShearFit,
    pub(crate) warnings: Vec<Warning>,
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
