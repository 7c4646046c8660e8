//! One case by several methods and laws.

use std::collections::BTreeMap;

use terramechanics::{NormalStressFrom, Operation, Slip};

use super::difference::{Difference, Spread};
use super::request::{CompareCase, Variation};
use crate::api::slip_sweep::{FoundSweep, SweepCase, sweep};
use crate::compute::{Pace, Stop};
use crate::quantity::PointColumns;
use crate::reply::method_name;
use crate::request::circles::Counted;
use crate::request::unused::Unused;
use crate::warning::{Warning, gathered};

/// The request as it stands and its variants, each by several methods.
pub(super) struct FoundComparison {
    pub(super) slips: Vec<Slip>,
    pub(super) series: Vec<FoundSeries>,
    /// By column: the highest of all series minus the lowest.
    pub(super) spread: BTreeMap<&'static str, Spread>,
    pub(super) warnings: Vec<Warning>,
}

/// What one method gives with the laws of one variant.
pub(super) struct FoundSeries {
    /// Name of the variant; none of the request as it stands.
    pub(super) variant: Option<String>,
    pub(super) method: &'static str,
    pub(super) circles: Counted,
    pub(super) normal_stress_from: NormalStressFrom,
    pub(super) columns: PointColumns,
    /// By column: the difference from the first series.
    pub(super) difference: BTreeMap<&'static str, Difference>,
    /// By column: the difference from the quadrature with the same laws, whether or not it was asked for.
    pub(super) gap_to_quadrature: BTreeMap<&'static str, Difference>,
}

/// Every method and every variant over the slips.
///
/// # Errors
/// [`Stop`], where the work is to end.
pub(super) fn compare(CompareCase { variations, slips, unused }: &CompareCase, pace: &Pace) -> Result<FoundComparison, Stop> {
    // Only the columns of a sweep are kept: they are smaller than its points.
    let columns_of = |operation: Operation| {
        let FoundSweep { operation, sweep, warnings } =
            sweep(&SweepCase { operation, slips: slips.clone(), unused: Unused::default() }, pace)?;
        Ok::<_, Stop>((PointColumns::of(&sweep, &operation, false), warnings))
    };
    let mut told: Vec<(String, Vec<Warning>)> = Vec::new();
    let mut series: Vec<FoundSeries> = Vec::new();
    for case @ Variation { variant, operations } in variations {
        let mut found = Vec::new();
        for &operation in operations {
            let (columns, warnings) = columns_of(operation)?;
            let method = method_name(&operation.model.method);
            told.push((variant.as_ref().map_or_else(|| method.to_owned(), |variant| format!("{variant}, {method}")), warnings));
            found.push((method, operation, columns));
        }
        let beside = case.quadrature_beside().map(columns_of).transpose()?.map(|(columns, _)| columns);
        let among = found.iter().find(|(method, ..)| *method == "quadrature").map(|(.., columns)| columns);
        let quadrature = among.or(beside.as_ref());
        let gap = |columns| quadrature.map(|quadrature| differences(columns, quadrature)).unwrap_or_default();
        let gaps: Vec<_> = found.iter().map(|(.., columns)| gap(columns)).collect();
        for ((method, operation, columns), gap_to_quadrature) in found.into_iter().zip(gaps) {
            let difference = differences(&columns, series.first().map_or(&columns, |first| &first.columns));
            series.push(FoundSeries {
                variant: variant.clone(),
                method,
                circles: Counted::by(&operation.model.method, operation.system.contact.circles()),
                normal_stress_from: operation.sinkage.normal_stress_from(),
                columns,
                difference,
                gap_to_quadrature,
            });
        }
    }
    let warnings = gathered(told).into_iter().chain(unused.warning()).collect();
    Ok(FoundComparison { slips: slips.clone(), spread: spread(&series), series, warnings })
}

/// The differences of columns from a reference, by name.
fn differences(columns: &PointColumns, reference: &PointColumns) -> BTreeMap<&'static str, Difference> {
    let pairs = columns.named().zip(reference.named()).skip(1); // the slip is the same
    pairs.map(|((name, column), (_, reference))| (name, Difference::between(column, reference))).collect()
}

fn spread(series: &[FoundSeries]) -> BTreeMap<&'static str, Spread> {
    let named: Vec<Vec<_>> = series.iter().map(|series| series.columns.named().collect()).collect();
    let Some(first) = named.first() else { return BTreeMap::new() };
    let of_all = |i: usize| named.iter().map(|columns| columns[i].1).collect::<Vec<_>>();
    first.iter().enumerate().skip(1).map(|(i, (name, _))| (*name, Spread::of(&of_all(i)))).collect()
}
