//! The answer of `/v1/compare`.

use std::borrow::Cow;
use std::collections::BTreeMap;

use serde::Serialize;
use utoipa::ToSchema;

use super::slip_sweep::SweepColumns;
use super::{Column, Reply, SweepReply, Warning};
use crate::request::{CompareQuery, SweepQuery};

/// Forces over slip by several methods, and how far each is from the first.
#[derive(Debug, Serialize, ToSchema)]
#[schema(as = Comparison)]
pub(crate) struct CompareReply {
    /// Slip ratio s (–).
    #[schema(value_type = Vec<f64>)]
    slip: Column,
    /// One per method, in the order asked for.
    series: Vec<Series>,
    /// The warnings of every series, with its method.
    warnings: Vec<Warning>,
}

/// What one method gives.
#[derive(Debug, Serialize, ToSchema)]
struct Series {
    method: &'static str,
    columns: SweepColumns,
    /// By column: the difference from the first method, in the column's unit.
    difference: BTreeMap<&'static str, Difference>,
}

/// The difference of two columns over the rows in which both have a value; null where there are none.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, ToSchema)]
struct Difference {
    /// Root of the mean square.
    rms: Option<f64>,
    /// Largest absolute value.
    max_abs: Option<f64>,
}

impl Difference {
    fn between(column: &[f64], reference: &[f64]) -> Self {
        let differences = || column.iter().zip(reference).map(|(a, b)| (a - b).abs()).filter(|difference| difference.is_finite());
        let count = differences().count();
        if count == 0 {
            return Self { rms: None, max_abs: None };
        }
        let largest = differences().fold(0.0, f64::max);
        // Scaled by the largest, so that the squares neither overflow nor vanish.
        let squares: f64 = differences().map(|difference| (difference / largest.max(f64::MIN_POSITIVE)).powi(2)).sum();
        Self { rms: Some(largest * (squares / count as f64).sqrt()), max_abs: Some(largest) }
    }
}

impl From<&CompareQuery> for CompareReply {
    fn from(query: &CompareQuery) -> Self {
        let CompareQuery { operations, slips } = query;
        let mut warnings = Vec::new();
        let mut series: Vec<Series> = Vec::with_capacity(operations.len());
        for &operation in operations {
            let sweep = SweepReply::from(&SweepQuery { operation, slips: slips.clone() });
            let of_method = |warning: Warning| Warning { detail: format!("{}: {}", sweep.method, warning.detail), ..warning };
            warnings.extend(sweep.warnings.into_iter().map(of_method));
            let reference = series.first().map_or(&sweep.columns, |first| &first.columns).named();
            let pairs = sweep.columns.named().into_iter().zip(reference).skip(1); // the slip is the same
            let difference =
                pairs.map(|((name, column), (_, reference))| (name, Difference::between(column, reference))).collect();
            series.push(Series { method: sweep.method, columns: sweep.columns, difference });
        }
        Self { slip: Column(slips.iter().map(|slip| slip.ratio()).collect()), series, warnings }
    }
}

impl Reply for CompareReply {
    /// The slip, then every column of every method as `method.column`.
    fn columns(&self) -> Vec<(Cow<'static, str>, &[f64])> {
        let mut columns = vec![(Cow::from("slip"), self.slip.0.as_slice())];
        for series in &self.series {
            let named = series.columns.named().into_iter().skip(1);
            columns.extend(named.map(|(name, column)| (Cow::from(format!("{}.{name}", series.method)), column)));
        }
        columns
    }

    fn warnings(&self) -> &[Warning] {
        &self.warnings
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn differences_are_taken_where_both_have_a_value() {
        let difference = Difference::between(&[1.0, 2.0, f64::NAN, 8.0], &[1.0, 5.0, 3.0, 4.0]);
        assert_eq!(difference.max_abs, Some(4.0));
        assert!((difference.rms.expect("a value") - (25.0_f64 / 3.0).sqrt()).abs() < 1e-15); // 0, 3 and 4
        assert_eq!(Difference::between(&[f64::NAN], &[1.0]), Difference { rms: None, max_abs: None });
        assert_eq!(Difference::between(&[2.0], &[2.0]), Difference { rms: Some(0.0), max_abs: Some(0.0) });
    }
}
