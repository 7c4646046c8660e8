//! The answer of `/v1/compare`.

use std::borrow::Cow;
use std::collections::BTreeMap;

use serde::Serialize;
use utoipa::ToSchema;

use super::difference::{Difference, Spread};
use super::found::{FoundComparison, FoundVariant};
use crate::quantity::{PointColumns, Values};
use crate::reply::Reply;
use crate::warning::Warning;

/// Forces over slip by several methods and laws, how far each is from the first and from the integral, and the spread of all.
#[derive(Debug, Serialize, ToSchema)]
#[schema(as = Comparison)]
pub(crate) struct CompareReply {
    /// Slip ratio s (–).
    #[schema(value_type = Vec<f64>)]
    slip: Values,
    /// One per method in the order asked for, of the request as it stands and then of each variant.
    series: Vec<Series>,
    /// By column: the highest of all series minus the lowest, in the column's unit.
    spread: BTreeMap<&'static str, Spread>,
    /// The warnings; those of some series alone have the names of these in `series`: the method, after its variant and a comma.
    warnings: Vec<Warning>,
}

/// The result of one method.
#[derive(Debug, Serialize, ToSchema)]
struct Series {
    /// Name of the variant; null for the request as it stands.
    variant: Option<String>,
    method: &'static str,
    columns: PointColumns,
    /// By column: the difference from the first series, in the column's unit.
    difference: BTreeMap<&'static str, Difference>,
    /// By column: the difference from the quadrature with the same laws, whether or not it was asked for.
    gap_to_quadrature: BTreeMap<&'static str, Difference>,
}

/// The differences of columns from a reference, by name.
fn differences(columns: &PointColumns, reference: &PointColumns) -> BTreeMap<&'static str, Difference> {
    let pairs = columns.named().zip(reference.named()).skip(1); // the slip is the same
    pairs.map(|((name, column), (_, reference))| (name, Difference::between(column, reference))).collect()
}

impl From<FoundComparison> for CompareReply {
    fn from(FoundComparison { slips, variants, warnings }: FoundComparison) -> Self {
        let mut series: Vec<Series> = Vec::new();
        for FoundVariant { name, series: found, quadrature_beside } in variants {
            let among = found.iter().find(|(method, _)| *method == "quadrature").map(|(_, columns)| columns);
            let quadrature = among.or(quadrature_beside.as_ref());
            let gap = |columns| quadrature.map(|quadrature| differences(columns, quadrature)).unwrap_or_default();
            let gaps: Vec<_> = found.iter().map(|(_, columns)| gap(columns)).collect();
            for ((method, columns), gap_to_quadrature) in found.into_iter().zip(gaps) {
                let difference = differences(&columns, series.first().map_or(&columns, |first| &first.columns));
                series.push(Series { variant: name.clone(), method, columns, difference, gap_to_quadrature });
            }
        }
        let slip = Values::Numbers(slips.iter().map(|slip| slip.ratio()).collect());
        Self { slip, spread: spread(&series), series, warnings }
    }
}

fn spread(series: &[Series]) -> BTreeMap<&'static str, Spread> {
    let named: Vec<Vec<_>> = series.iter().map(|series| series.columns.named().collect()).collect();
    let Some(first) = named.first() else { return BTreeMap::new() };
    let of_all = |i: usize| named.iter().map(|columns| columns[i].1).collect::<Vec<_>>();
    first.iter().enumerate().skip(1).map(|(i, (name, _))| (*name, Spread::of(&of_all(i)))).collect()
}

impl Reply for CompareReply {
    /// The slip, then every column of every series as `method.column`, after its variant and a dot where it has one.
    fn columns(&self) -> Vec<(Cow<'static, str>, &[f64])> {
        let mut columns = vec![(Cow::from("slip"), self.slip.numbers())];
        for Series { variant, method, columns: of_series, .. } in &self.series {
            let around = variant.as_ref().map_or_else(String::new, |variant| format!("{variant}."));
            let named = of_series.named().skip(1);
            columns.extend(named.map(|(name, column)| (Cow::from(format!("{around}{method}.{name}")), column)));
        }
        columns
    }

    fn warnings(&self) -> &[Warning] {
        &self.warnings
    }
}
