//! One case by several methods and laws.

use terramechanics::{Operation, Slip};

use super::request::{CompareCase, Variation};
use crate::api::slip_sweep::{FoundSweep, SweepCase, sweep};
use crate::compute::{Pace, Stop};
use crate::quantity::PointColumns;
use crate::reply::method_name;
use crate::warning::{Warning, gathered};

/// The request as it stands and its variants, each by several methods.
pub(crate) struct FoundComparison {
    pub(crate) slips: Vec<Slip>,
    pub(crate) variants: Vec<FoundVariant>,
    pub(crate) warnings: Vec<Warning>,
}

/// Laws by several methods.
pub(crate) struct FoundVariant {
    /// The name; none of the request as it stands.
    pub(crate) name: Option<String>,
    /// Method and columns of each series.
    pub(crate) series: Vec<(&'static str, PointColumns)>,
    /// The quadrature with these laws, where it is not among the series.
    pub(crate) quadrature_beside: Option<PointColumns>,
}

/// Every method and every variant over the slips.
///
/// # Errors
/// [`Stop`], where the work is to end.
pub(crate) fn compare(CompareCase { variations, slips }: &CompareCase, pace: &Pace) -> Result<FoundComparison, Stop> {
    // Only the columns of a sweep are kept: they are smaller than its points.
    let columns_of = |operation: Operation| {
        let FoundSweep { operation, sweep, warnings } = sweep(&SweepCase { operation, slips: slips.clone() }, pace)?;
        Ok::<_, Stop>((PointColumns::of(&sweep, &operation.system.wheel, false), warnings))
    };
    let mut told: Vec<(String, Vec<Warning>)> = Vec::new();
    let mut variants = Vec::new();
    for case @ Variation { variant, operations } in variations {
        let mut series = Vec::new();
        for &operation in operations {
            let (columns, warnings) = columns_of(operation)?;
            let method = method_name(&operation.model.method);
            told.push((variant.as_ref().map_or_else(|| method.to_owned(), |variant| format!("{variant}, {method}")), warnings));
            series.push((method, columns));
        }
        let quadrature_beside = case.quadrature_beside().map(columns_of).transpose()?.map(|(columns, _)| columns);
        variants.push(FoundVariant { name: variant.clone(), series, quadrature_beside });
    }
    Ok(FoundComparison { slips: slips.clone(), variants, warnings: gathered(told) })
}
