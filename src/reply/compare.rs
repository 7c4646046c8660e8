//! The answer of `/v1/compare`.

use std::borrow::Cow;
use std::collections::BTreeMap;

use serde::Serialize;
use terramechanics::Operation;
use utoipa::ToSchema;

use super::difference::{Difference, Spread};
use super::slip_sweep::SweepColumns;
use super::{Column, Reply, SweepReply, Warning};
use crate::compute::{Pace, Stop};
use crate::request::{CompareCase, SweepCase, Variation};

/// Forces over slip by several methods and laws, how far each is from the first and from the integral, and the spread of all.
#[derive(Debug, Serialize, ToSchema)]
#[schema(as = Comparison)]
pub(crate) struct CompareReply {
    /// Slip ratio s (–).
    #[schema(value_type = Vec<f64>)]
    slip: Column,
    /// One per method in the order asked for, of the request as it stands and then of each variant.
    series: Vec<Series>,
    /// By column: the highest of all series minus the lowest, in the column's unit.
    spread: BTreeMap<&'static str, Spread>,
    /// The warnings: those of all series once, the others with variant and method of their series.
    warnings: Vec<Warning>,
}

/// What one method gives.
#[derive(Debug, Serialize, ToSchema)]
struct Series {
    /// Name of the variant; null of the request as it stands.
    variant: Option<String>,
    method: &'static str,
    columns: SweepColumns,
    /// By column: the difference from the first series, in the column's unit.
    difference: BTreeMap<&'static str, Difference>,
    /// By column: the difference from the quadrature with the same laws, whether or not it was asked for.
    gap_to_quadrature: BTreeMap<&'static str, Difference>,
}

/// The differences of columns from a reference, by name.
fn differences(columns: &SweepColumns, reference: &SweepColumns) -> BTreeMap<&'static str, Difference> {
    let pairs = columns.named().into_iter().zip(reference.named()).skip(1); // the slip is the same
    pairs.map(|((name, column), (_, reference))| (name, Difference::between(column, reference))).collect()
}

impl CompareReply {
    /// Every series, with its differences.
    ///
    /// # Errors
    /// [`Stop`], where the work is to end.
    pub(crate) fn of(query: &CompareCase, pace: &Pace) -> Result<Self, Stop> {
        let CompareCase { variations, slips } = query;
        let mut told: Vec<(String, Vec<Warning>)> = Vec::new();
        let mut series: Vec<Series> = Vec::new();
        for variation @ Variation { variant, operations } in variations {
            let sweep = |operation: Operation| SweepReply::of(&SweepCase { operation, slips: slips.clone() }, pace);
            let sweeps = operations.iter().map(|&operation| sweep(operation)).collect::<Result<Vec<_>, _>>()?;
            let quadrature = variation.quadrature_beside().map(sweep).transpose()?;
            let found = sweeps.iter().chain(&quadrature).find(|sweep| sweep.method == "quadrature");
            let gaps: Vec<_> = sweeps
                .iter()
                .map(|sweep| found.map(|quadrature| differences(&sweep.columns, &quadrature.columns)).unwrap_or_default())
                .collect();
            for (SweepReply { method, columns, warnings }, gap_to_quadrature) in sweeps.into_iter().zip(gaps) {
                let name = variant.as_ref().map_or_else(|| method.to_owned(), |variant| format!("{variant}, {method}"));
                told.push((name, warnings));
                let difference = differences(&columns, series.first().map_or(&columns, |first| &first.columns));
                series.push(Series { variant: variant.clone(), method, columns, difference, gap_to_quadrature });
            }
        }
        let spread = spread(&series);
        let slip = Column(slips.iter().map(|slip| slip.ratio()).collect());
        Ok(Self { slip, series, spread, warnings: gathered(&told) })
    }
}

/// What is said of every series, once; then what is said of some, with the name of each.
fn gathered(told: &[(String, Vec<Warning>)]) -> Vec<Warning> {
    let is_of_all = |warning: &Warning| told.iter().all(|(_, warnings)| warnings.contains(warning));
    let of_all = told.first().into_iter().flat_map(|(_, warnings)| warnings).filter(|warning| is_of_all(warning)).cloned();
    let of_some = told.iter().flat_map(|(name, warnings)| {
        let of_some = warnings.iter().filter(|warning| !is_of_all(warning));
        of_some.map(move |warning| Warning { detail: format!("{name}: {}", warning.detail), ..warning.clone() })
    });
    of_all.chain(of_some).collect()
}

fn spread(series: &[Series]) -> BTreeMap<&'static str, Spread> {
    let named: Vec<_> = series.iter().map(|series| series.columns.named()).collect();
    let Some(first) = named.first() else { return BTreeMap::new() };
    let of_all = |i: usize| named.iter().map(|columns| columns[i].1).collect::<Vec<_>>();
    first.iter().enumerate().skip(1).map(|(i, (name, _))| (*name, Spread::of(&of_all(i)))).collect()
}

impl Reply for CompareReply {
    /// The slip, then every column of every series as `method.column`, after its variant and a dot where it has one.
    fn columns(&self) -> Vec<(Cow<'static, str>, &[f64])> {
        let mut columns = vec![(Cow::from("slip"), self.slip.0.as_slice())];
        for Series { variant, method, columns: of_series, .. } in &self.series {
            let around = variant.as_ref().map_or_else(String::new, |variant| format!("{variant}."));
            let named = of_series.named().into_iter().skip(1);
            columns.extend(named.map(|(name, column)| (Cow::from(format!("{around}{method}.{name}")), column)));
        }
        columns
    }

    fn warnings(&self) -> &[Warning] {
        &self.warnings
    }
}
