//! A set of measurements by every method.

use crate::validation::{AtModulus, Prediction, Record, of_shear_modulus};
use crate::warning::{Finding, Reason, RowCautions, Rows, Warning, shared_warnings};

/// A set of measurements with the predictions for it.
pub(crate) struct FoundSet {
    pub(crate) record: &'static Record,
    pub(crate) predictions: Vec<Prediction>,
    /// What hangs on the shear modulus.
    pub(crate) sensitivity: Vec<AtModulus>,
    pub(crate) warnings: Vec<Warning>,
}

/// The predictions for a set.
pub(crate) fn validation(record: &'static Record) -> FoundSet {
    let predictions: Vec<Prediction> = record.runs().iter().map(|run| Prediction::of(record, run)).collect();
    let cautions: Vec<(&'static str, RowCautions)> =
        predictions.iter().map(|prediction| (prediction.run.series, prediction.cautions.clone())).collect();
    let mut warnings = of_gaps(&predictions);
    warnings.extend(shared_warnings(cautions, record.points().slip.len()));
    FoundSet { record, predictions, sensitivity: of_shear_modulus(record), warnings }
}

/// Rows without a solution, each with the reason.
type Gaps = Vec<(usize, Reason)>;

/// The gaps of all predictions, those that several share once.
fn of_gaps(predictions: &[Prediction]) -> Vec<Warning> {
    let mut by_gaps: Vec<(Gaps, Vec<String>)> = Vec::new();
    for prediction in predictions {
        let (gaps, name) = (prediction.gaps(), prediction.run.series.to_owned());
        match by_gaps.iter_mut().find(|(known, _)| *known == gaps) {
            Some((_, names)) => names.push(name),
            None => by_gaps.push((gaps, vec![name])),
        }
    }
    let warning = |(gaps, names): (Gaps, Vec<String>)| {
        let (_, reason) = gaps.first()?;
        let rows: Vec<usize> = gaps.iter().map(|(row, _)| *row).collect();
        let finding = Finding::NoSolution { reason: reason.clone(), pointer: "" };
        let warning = Warning::from(finding).at(Rows::of(&rows));
        Some(if names.len() == predictions.len() { warning } else { warning.of_series(names) })
    };
    by_gaps.into_iter().filter_map(warning).collect()
}
