//! The answer of `/v1/validation`.

mod columns;

use std::borrow::Cow;
use std::collections::BTreeMap;

use serde::Serialize;
use serde_json::Value;
use utoipa::ToSchema;

use self::columns::{ForceColumns, PredictedColumns, ValidationColumns};
use super::warning::{rows_in_words, shared_warnings};
use super::{Column, Reply, RowCautions, Warning};
use crate::request::{ContactObject, SoilObject, WheelObject};
use crate::validation::{MeasurementGrade, Prediction, Record, Run, root_mean_square};

/// A set of published measurements, with what each method gives for it.
#[derive(Debug, Serialize, ToSchema)]
#[schema(as = ValidationSet)]
pub(crate) struct ValidationSet {
    /// Its name in a path.
    #[schema(example = "ding-2011-smooth")]
    pub(crate) id: &'static str,
    title: &'static str,
    /// Where the measurements were published.
    source: &'static str,
    grade: MeasurementGrade,
    /// What a user should know of it, above all where it is a hard case.
    #[serde(skip_serializing_if = "Option::is_none")]
    note: Option<&'static str>,
    /// The wheel, ready for a request.
    #[schema(value_type = WheelObject)]
    wheel: &'static Value,
    /// The soil, ready for a request.
    #[schema(value_type = SoilObject)]
    soil: &'static Value,
    /// The contact, ready for a request; else that of the columns where they have one, what the catalogue measured with the
    /// soil, or midpoint.
    #[serde(skip_serializing_if = "Option::is_none")]
    #[schema(value_type = Option<ContactObject>)]
    contact: Option<&'static Value>,
    /// Slip angle β (rad), ready for a request; absent where the wheel went straight ahead.
    #[serde(skip_serializing_if = "Option::is_none")]
    #[schema(nullable = false)]
    slip_angle_rad: Option<f64>,
    /// Which parameters were fitted to these very measurements; absent where none were, and the results are predictions.
    #[serde(skip_serializing_if = "Option::is_none")]
    fitted_to: Option<&'static str>,
    /// Number of points.
    points: usize,
    /// The errors by method, and by what departs from the defaults of a request.
    results: Vec<ValidationResult>,
    columns: ValidationColumns,
    warnings: Vec<Warning>,
}

/// How far one prediction is from the measurements: roots of the mean squares over the points that were measured and have a
/// solution; null where there are none. Of two predictions that solve different points, the columns tell which.
#[derive(Debug, Serialize, ToSchema)]
struct ValidationResult {
    /// Name of its columns under `columns.predicted`.
    #[schema(example = "quadrature")]
    series: &'static str,
    method: &'static str,
    /// Law of braking, `one_zone` or `two_zone`; it matters at slips below 0 only.
    #[schema(example = "one_zone")]
    braking: &'static str,
    /// How the shear stresses along and across the wheel go together, `independent` or `coupled`; of sets at a slip angle.
    #[serde(skip_serializing_if = "Option::is_none")]
    #[schema(nullable = false)]
    shear_coupling: Option<&'static str>,
    /// Pressure on the side wall, `full` or `mobilised`; of sets at a slip angle.
    #[serde(skip_serializing_if = "Option::is_none")]
    #[schema(nullable = false)]
    bulldozing: Option<&'static str>,
    /// Whether parameters were fitted to these very measurements: then it is no prediction.
    fitted: bool,
    /// Error of the drawbar pull, at each point over its load (–).
    drawbar_rmse_over_load: Option<f64>,
    /// Error of the sinkage (m).
    sinkage_rmse_m: Option<f64>,
    /// Error of the torque (N·m).
    torque_rmse_n_m: Option<f64>,
    /// Error of the lateral force, at each point over its load (–).
    lateral_rmse_over_load: Option<f64>,
    /// Points with a solution.
    solved: usize,
    /// Points without a solution, which no error counts.
    unsolved: usize,
}

impl ValidationResult {
    fn of(record: &Record, run: &Run, measured: &ForceColumns, predicted: &ForceColumns, unsolved: usize) -> Self {
        let error = |Column(predicted): &Column, Column(measured): &Column| {
            root_mean_square(predicted.iter().zip(measured).map(|(predicted, measured)| predicted - measured))
        };
        let across = predicted.lateral_coefficient.as_ref().zip(measured.lateral_coefficient.as_ref());
        Self {
            series: run.series,
            method: run.method,
            braking: run.braking,
            shear_coupling: run.side.map(|laws| laws.shear_coupling),
            bulldozing: run.side.map(|laws| laws.bulldozing),
            fitted: record.fitted_to.is_some(),
            drawbar_rmse_over_load: error(&predicted.drawbar_coefficient, &measured.drawbar_coefficient),
            sinkage_rmse_m: error(&predicted.sinkage_m, &measured.sinkage_m),
            torque_rmse_n_m: error(&predicted.torque_n_m, &measured.torque_n_m),
            lateral_rmse_over_load: across.and_then(|(predicted, measured)| error(predicted, measured)),
            solved: record.points().slip.len() - unsolved,
            unsolved,
        }
    }
}

impl From<&'static Record> for ValidationSet {
    fn from(record: &'static Record) -> Self {
        let points = record.points();
        let load = points.load();
        let is_sideways = record.side_slip.is_some();
        let measured = ForceColumns::of(points.measured(), &load, is_sideways);
        let mut results = Vec::new();
        let mut by_series = BTreeMap::new();
        let mut gaps = Vec::new();
        let mut cautions = Vec::new();
        for run in record.runs() {
            let prediction = Prediction::of(record, run);
            let predicted = ForceColumns::of(prediction.quantities, &load, is_sideways);
            results.push(ValidationResult::of(record, run, &measured, &predicted, prediction.gaps.len()));
            by_series.insert(run.series, predicted);
            gaps.push((run.series, prediction.gaps));
            cautions.push((run.series, prediction.cautions));
        }
        Self {
            id: &record.id,
            title: &record.title,
            source: &record.source,
            grade: record.grade,
            note: record.note.as_deref(),
            wheel: &record.wheel,
            soil: &record.soil,
            contact: record.contact.as_ref(),
            slip_angle_rad: record.side_slip.map(|side| side.angle()),
            fitted_to: record.fitted_to.as_deref(),
            points: load.len(),
            results,
            columns: ValidationColumns::of(record, measured, PredictedColumns::of(by_series)),
            warnings: warnings(&gaps, cautions, load.len()),
        }
    }
}

/// Rows without a solution, each with the reason.
type Gaps = Vec<(usize, String)>;

/// What is to be said of the predictions, each thing once.
fn warnings(gaps: &[(&'static str, Gaps)], cautions: Vec<(&'static str, RowCautions)>, count: usize) -> Vec<Warning> {
    let mut by_gaps: Vec<(&Gaps, Vec<&str>)> = Vec::new();
    for (series, gaps) in gaps.iter().filter(|(_, gaps)| !gaps.is_empty()) {
        match by_gaps.iter_mut().find(|(known, _)| *known == gaps) {
            Some((_, names)) => names.push(series),
            None => by_gaps.push((gaps, vec![series])),
        }
    }
    let of_gaps = by_gaps.into_iter().map(|(gaps, names)| {
        let rows: Vec<usize> = gaps.iter().map(|(row, _)| *row).collect();
        let reason = gaps.first().map_or("", |(_, reason)| reason);
        let detail = format!("{}: no solution at indices {}; the first: {reason}", names.join(", "), rows_in_words(&rows));
        Warning::new("no_solution", detail)
    });
    of_gaps.chain(shared_warnings(cautions, count)).collect()
}

impl Reply for ValidationSet {
    fn columns(&self) -> Vec<(Cow<'static, str>, &[f64])> {
        self.columns.named()
    }

    fn warnings(&self) -> &[Warning] {
        &self.warnings
    }
}
