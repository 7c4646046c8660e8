//! The columns of the answer: a value for each of the axis, or one at a point.

use terramechanics_uncertainty::{Estimate, Probability, Sensitivity, Summary};

use super::found::PER_CENT;
use crate::quantity::{About, Columns, Field, Shape};
use crate::varied::RowStatus;

/// In the unit of the quantity, which its name tells.
const OWN: &str = About::OF_ANOTHER;

static BAND: [About; 15] = [
    About::new("answered", "", "1", "samples with a value; the others are in no band"),
    About::new("mean", "", OWN, "mean, in the unit of the quantity like all that follows"),
    About::new("mean_error", "", OWN, "its standard error"),
    About::new("standard_deviation", "", OWN, "standard deviation"),
    About::new("standard_deviation_error", "", OWN, "its standard error"),
    About::new("q05", "", OWN, "quantile at 5 %"),
    About::new("q05_error", "", OWN, "its standard error"),
    About::new("q25", "", OWN, "quantile at 25 %"),
    About::new("q25_error", "", OWN, "its standard error"),
    About::new("q50", "", OWN, "median"),
    About::new("q50_error", "", OWN, "its standard error"),
    About::new("q75", "", OWN, "quantile at 75 %"),
    About::new("q75_error", "", OWN, "its standard error"),
    About::new("q95", "", OWN, "quantile at 95 %"),
    About::new("q95_error", "", OWN, "its standard error"),
];

static PROBABILITY: [About; 5] = [
    About::new("probability", "", "1", "share of the samples with a value for which the condition holds"),
    About::new("probability_error", "", "1", "its standard error, never less than one sample"),
    About::new("answered", "", "1", "samples with a value"),
    About::new("least", "", "1", "share of all samples, if the condition held for none without a value"),
    About::new("most", "", "1", "share of all samples, if it held for every one without a value"),
];

static INDEX: [About; 5] = [
    About::new("first_order", "S_i", "1", "share of the variance that would go if these fields alone were known"),
    About::new("first_order_error", "", "1", "its standard error"),
    About::new("total", "S_Ti", "1", "share of the variance that would stay if all other inputs were known"),
    About::new("total_error", "", "1", "its standard error"),
    About::new("left_out", "", "1", "samples left out because one of the evaluations that they need has no value"),
];

/// The names are those of [`RowStatus`].
static STATUS: [About; RowStatus::ALL.len()] = [
    About::new(RowStatus::Ok.name(), "", "1", "samples with an answer"),
    About::new(RowStatus::Invalid.name(), "", "1", "samples whose values make no valid request"),
    About::new(RowStatus::NoSolution.name(), "", "1", "samples of which the model has no answer"),
    About::new(RowStatus::NotClimbed.name(), "", "1", "samples of a rover for which no slip gives the pull"),
];

/// Declares a shape of columns.
macro_rules! shapes {
    ($($shape:ident, $columns:ident, $table:ident, $name:literal, $field:ident, $doc:literal;)+) => {$(
        #[doc = $doc]
        #[derive(Debug, Clone)]
        pub(super) struct $shape;

        pub(super) type $columns = Columns<$shape>;

        impl Shape for $shape {
            const NAME: &'static str = $name;
            const DOC: &'static str = $doc;

            fn fields() -> Vec<Field> {
                $table.iter().map(Field::$field).collect()
            }
        }
    )+};
}

shapes! {
    OfBand, BandColumns, BAND, "UncertainBandColumns", or_null,
        "A value for each of the axis, or one; null where too few samples have a value.";
    OfProbability, ProbabilityColumns, PROBABILITY, "UncertainProbabilityColumns", or_null,
        "A value for each of the axis, or one; null where no sample has a value.";
    OfIndex, IndexColumns, INDEX, "UncertainSensitivityColumns", or_null,
        "A value for each of the axis, or one; null where the quantity does not vary or too few samples have a value.";
    OfStatus, StatusColumns, STATUS, "UncertainStatusColumns", always,
        "Numbers of samples, for each value of the axis, or one.";
}

/// A number and its error; NaN for both where there is none.
pub(super) fn pair(estimate: Option<Estimate>) -> [f64; 2] {
    estimate.map_or([f64::NAN; 2], |Estimate { value, error }| [value, error])
}

/// Columns from rows of numbers.
fn columns<S, const N: usize>(about: &'static [About; N], rows: impl Iterator<Item = [f64; N]>) -> Columns<S> {
    let mut lists = [(); N].map(|()| Vec::new());
    for row in rows {
        lists.iter_mut().zip(row).for_each(|(list, value)| list.push(value));
    }
    Columns::of_numbers(about, lists)
}

pub(super) fn band<'s>(summaries: impl Iterator<Item = Option<&'s Summary>>) -> BandColumns {
    let row = |summary: Option<&Summary>| {
        let mut row = [f64::NAN; BAND.len()];
        row[0] = summary.map_or(0.0, |summary| summary.answered as f64);
        let estimates = [summary.map(|summary| summary.mean), summary.map(|summary| summary.deviation)];
        let quantiles = (0..PER_CENT.len()).map(|i| summary.map(|summary| summary.quantiles[i]));
        for (cells, estimate) in row[1..].chunks_exact_mut(2).zip(estimates.into_iter().chain(quantiles)) {
            cells.copy_from_slice(&pair(estimate));
        }
        row
    };
    columns(&BAND, summaries.map(row))
}

pub(super) fn probability(probabilities: impl Iterator<Item = Probability>) -> ProbabilityColumns {
    let row = |of: Probability| {
        let [value, error] = pair(of.among_answered);
        [value, error, of.answered as f64, of.least, of.most]
    };
    columns(&PROBABILITY, probabilities.map(row))
}

pub(super) fn index<'s>(indices: impl Iterator<Item = Option<&'s Sensitivity>>) -> IndexColumns {
    let row = |of: Option<&Sensitivity>| {
        let [first, first_error] = pair(of.map(|of| of.first));
        let [total, total_error] = pair(of.map(|of| of.total));
        [first, first_error, total, total_error, of.map_or(f64::NAN, |of| of.left_out as f64)]
    };
    columns(&INDEX, indices.map(row))
}

pub(super) fn status(statuses: impl Iterator<Item = [u32; RowStatus::ALL.len()]>) -> StatusColumns {
    columns(&STATUS, statuses.map(|counts| counts.map(f64::from)))
}
