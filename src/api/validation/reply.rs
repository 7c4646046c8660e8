//! The answer of `/v1/validation`.

use std::borrow::Cow;

use serde::Serialize;
use serde_json::Value;
use utoipa::ToSchema;

use super::columns::{ForceColumns, ValidationColumns};
use super::found::FoundSet;
use super::inputs::{InputReply, NotScoredReply, SensitivityReply, inputs, not_scored};
use crate::reply::Reply;
use crate::request::soil::SoilObject;
use crate::request::system::ContactObject;
use crate::request::wheel::WheelObject;
use crate::validation::{Known, MeasurementGrade, Prediction, Record, root_mean_square};
use crate::warning::Warning;

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
    /// Circle on which the slips were counted, `rim`, `shearing` or `lug_tip`, ready for a request.
    #[schema(example = "shearing")]
    slip_radius: &'static str,
    /// Whether the source says so; else the rim is assumed. Without lugs it does not matter.
    slip_radius_stated: bool,
    /// Which parameters were fitted to these very measurements; absent where none were, and the results are predictions.
    #[serde(skip_serializing_if = "Option::is_none")]
    fitted_to: Option<&'static str>,
    /// Where the inputs of the predictions come from.
    inputs: Vec<InputReply>,
    /// Measured columns that count in no error, and why.
    #[serde(skip_serializing_if = "Vec::is_empty")]
    #[schema(required = false)]
    not_scored: Vec<NotScoredReply>,
    /// How much of the pull's error hangs on the shear modulus; absent at a slip angle.
    #[serde(skip_serializing_if = "Vec::is_empty")]
    #[schema(required = false)]
    sensitivity: Vec<SensitivityReply>,
    /// Number of points.
    pub(super) points: usize,
    /// The errors by method, and by the options that differ from the defaults of a request.
    results: Vec<ValidationResult>,
    columns: ValidationColumns,
    warnings: Vec<Warning>,
}

/// How far one prediction is from the measurements: roots of the mean squares over the points that were measured and have a
/// solution; null where there are none. Two predictions may solve different points; the columns show which.
#[derive(Debug, Serialize, ToSchema)]
struct ValidationResult {
    /// Name of its columns under `columns.predicted`.
    #[schema(example = "quadrature")]
    series: &'static str,
    method: &'static str,
    /// Where the sinkage beside a known load comes from, `measured` at each point or `from_standstill` by (18) from the first;
    /// absent where it is solved for the load.
    #[serde(skip_serializing_if = "Option::is_none")]
    #[schema(nullable = false, example = "measured")]
    sinkage_known: Option<&'static str>,
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
    /// Error of the torque (N·m); null where the measured one is not trusted, see `not_scored`.
    torque_rmse_n_m: Option<f64>,
    /// Error of the lateral force, at each point over its load (–).
    lateral_rmse_over_load: Option<f64>,
    /// Points with a solution.
    solved: usize,
    /// Points without a solution, which no error counts.
    unsolved: usize,
}

impl ValidationResult {
    fn of(record: &Record, prediction: &Prediction, measured: &ForceColumns, predicted: &ForceColumns) -> Self {
        let error = |name: &str| {
            if record.not_scored.contains_key(name) {
                return None;
            }
            let (predicted, measured) = (predicted.get(name)?, measured.get(name)?);
            root_mean_square(predicted.iter().zip(measured).map(|(predicted, measured)| predicted - measured))
        };
        let run = prediction.run;
        let unsolved = prediction.points().filter(Option::is_none).count();
        Self {
            series: run.series,
            method: run.method,
            sinkage_known: run.known.map(Known::name),
            braking: run.braking,
            shear_coupling: run.side.map(|laws| laws.shear_coupling),
            bulldozing: run.side.map(|laws| laws.bulldozing),
            // No set was fitted by what grains take of a soil.
            fitted: record.fitted_to.is_some() && !run.is_by_grains(),
            drawbar_rmse_over_load: error("drawbar_coefficient"),
            // A measured sinkage predicts none.
            sinkage_rmse_m: if run.known == Some(Known::Measured) { None } else { error("sinkage_m") },
            torque_rmse_n_m: error("torque_n_m"),
            lateral_rmse_over_load: error("lateral_coefficient"),
            solved: record.points().slip.len() - unsolved,
            unsolved,
        }
    }
}

impl ValidationSet {
    /// The error of the pull by a series; none where a point has no solution.
    pub(super) fn drawbar_error(&self, series: &str) -> Option<f64> {
        let result = self.results.iter().find(|result| result.series == series && result.unsolved == 0)?;
        result.drawbar_rmse_over_load
    }
}

impl From<FoundSet> for ValidationSet {
    fn from(FoundSet { record, predictions, sensitivity, warnings }: FoundSet) -> Self {
        let columns = ValidationColumns::of(record, &predictions);
        let predicted = predictions.iter().zip(columns.predicted.each());
        let results =
            predicted.map(|(prediction, (_, of_run))| ValidationResult::of(record, prediction, &columns.measured, of_run));
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
            slip_radius: &record.slip_radius,
            slip_radius_stated: record.slip_radius_stated,
            fitted_to: record.fitted_to.as_deref(),
            inputs: inputs(record),
            not_scored: not_scored(record),
            sensitivity: sensitivity.into_iter().map(SensitivityReply::from).collect(),
            points: record.points().slip.len(),
            results: results.collect(),
            columns,
            warnings,
        }
    }
}

impl Reply for ValidationSet {
    fn columns(&self) -> Vec<(Cow<'static, str>, &[f64])> {
        self.columns.named()
    }

    fn warnings(&self) -> &[Warning] {
        &self.warnings
    }

    fn warn(&mut self, warning: Warning) {
        self.warnings.push(warning);
    }
}
