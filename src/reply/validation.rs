//! The answer of `/v1/validation`.

use std::borrow::Cow;

use serde::Serialize;
use serde_json::Value;
use utoipa::ToSchema;

use super::warning::rows_in_words;
use super::{Column, Reply, Warning};
use crate::request::{ContactDto, SoilDto, WheelDto};
use crate::validation::{METHODS, MeasurementGrade, Prediction, Record, root_mean_square};

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
    #[schema(value_type = WheelDto)]
    wheel: &'static Value,
    /// The soil, ready for a request.
    #[schema(value_type = SoilDto)]
    soil: &'static Value,
    /// The contact, ready for a request; else what the catalogue measured with the soil, else midpoint.
    #[serde(skip_serializing_if = "Option::is_none")]
    #[schema(value_type = Option<ContactDto>)]
    contact: Option<&'static Value>,
    /// Which parameters were fitted to these very measurements; absent where none were, and the results are predictions.
    #[serde(skip_serializing_if = "Option::is_none")]
    fitted_to: Option<&'static str>,
    /// Number of points.
    points: usize,
    /// The errors by method.
    results: Vec<ValidationResult>,
    columns: ValidationColumns,
    warnings: Vec<Warning>,
}

/// How far one method is from the measurements: roots of the mean squares over the points that were measured and have a
/// solution; null where there are none.
#[derive(Debug, Serialize, ToSchema)]
struct ValidationResult {
    method: &'static str,
    /// Whether parameters were fitted to these very measurements: then it is no prediction.
    fitted: bool,
    /// Error of the drawbar pull, at each point over its load (–).
    drawbar_rmse_over_load: Option<f64>,
    /// Error of the sinkage (m).
    sinkage_rmse_m: Option<f64>,
    /// Error of the torque (N·m).
    torque_rmse_n_m: Option<f64>,
    /// Points without a solution, which no error counts.
    unsolved: usize,
}

/// Columns of one length, measured and predicted.
#[derive(Debug, Serialize, ToSchema)]
struct ValidationColumns {
    /// Slip ratio s (–).
    #[schema(value_type = Vec<f64>)]
    slip: Column,
    /// Vertical load W (N).
    #[schema(value_type = Vec<f64>)]
    normal_load_n: Column,
    measured: ForceColumns,
    predicted: PredictedColumns,
}

/// By method: the sinkage is solved for the load.
#[derive(Debug, Serialize, ToSchema)]
struct PredictedColumns {
    quadrature: ForceColumns,
    linearised: ForceColumns,
    explicit: ForceColumns,
}

/// Null where a quantity was not measured or a point has no solution.
#[derive(Debug, Serialize, ToSchema)]
#[schema(as = ValidationForces)]
struct ForceColumns {
    /// Drawbar pull F_x (N).
    #[schema(value_type = Vec<Option<f64>>)]
    longitudinal_force_n: Column,
    /// Sinkage z (m).
    #[schema(value_type = Vec<Option<f64>>)]
    sinkage_m: Column,
    /// Torque T about the axle (N·m).
    #[schema(value_type = Vec<Option<f64>>)]
    torque_n_m: Column,
    /// F_x/W (–).
    #[schema(value_type = Vec<Option<f64>>)]
    drawbar_coefficient: Column,
}

impl ForceColumns {
    fn of(longitudinal_force: Vec<f64>, sinkage: Vec<f64>, torque: Vec<f64>, load: &[f64]) -> Self {
        let coefficient = longitudinal_force.iter().zip(load).map(|(force, load)| force / load).collect();
        Self {
            longitudinal_force_n: Column(longitudinal_force),
            sinkage_m: Column(sinkage),
            torque_n_m: Column(torque),
            drawbar_coefficient: Column(coefficient),
        }
    }

    fn named(&self) -> [(&'static str, &[f64]); 4] {
        [
            ("longitudinal_force_n", &self.longitudinal_force_n.0),
            ("sinkage_m", &self.sinkage_m.0),
            ("torque_n_m", &self.torque_n_m.0),
            ("drawbar_coefficient", &self.drawbar_coefficient.0),
        ]
    }
}

impl From<&'static Record> for ValidationSet {
    fn from(record: &'static Record) -> Self {
        let points = record.points();
        let load = points.load();
        let measured = ForceColumns::of(points.longitudinal_force(), points.sinkage(), points.torque(), &load);
        let mut results = Vec::with_capacity(METHODS.len());
        let mut warnings = Vec::new();
        let mut by = |method: &'static str| {
            let prediction = Prediction::of(record, method);
            warn(&mut warnings, method, &prediction);
            let unsolved = prediction.gaps.len();
            let predicted = ForceColumns::of(prediction.longitudinal_force, prediction.sinkage, prediction.torque, &load);
            let error = |Column(predicted): &Column, Column(measured): &Column| {
                root_mean_square(predicted.iter().zip(measured).map(|(predicted, measured)| predicted - measured))
            };
            results.push(ValidationResult {
                method,
                fitted: record.fitted_to.is_some(),
                drawbar_rmse_over_load: error(&predicted.drawbar_coefficient, &measured.drawbar_coefficient),
                sinkage_rmse_m: error(&predicted.sinkage_m, &measured.sinkage_m),
                torque_rmse_n_m: error(&predicted.torque_n_m, &measured.torque_n_m),
                unsolved,
            });
            predicted
        };
        let [quadrature, linearised, explicit] = METHODS.map(&mut by);
        Self {
            id: &record.id,
            title: &record.title,
            source: &record.source,
            grade: record.grade,
            note: record.note.as_deref(),
            wheel: &record.wheel,
            soil: &record.soil,
            contact: record.contact.as_ref(),
            fitted_to: record.fitted_to.as_deref(),
            points: points.slip.len(),
            results,
            columns: ValidationColumns {
                slip: Column(points.slip.clone()),
                normal_load_n: Column(load),
                measured,
                predicted: PredictedColumns { quadrature, linearised, explicit },
            },
            warnings,
        }
    }
}

/// What is to be said of a method's prediction.
fn warn(warnings: &mut Vec<Warning>, method: &str, prediction: &Prediction) {
    if let Some((_, reason)) = prediction.gaps.first() {
        let rows: Vec<usize> = prediction.gaps.iter().map(|(row, _)| *row).collect();
        let detail = format!("{method}: no solution at indices {}; the first: {reason}", rows_in_words(&rows));
        warnings.push(Warning::new("no_solution", detail));
    }
    let cautions = prediction.cautions.clone().into_warnings(prediction.sinkage.len());
    warnings.extend(cautions.map(|warning| Warning { detail: format!("{method}: {}", warning.detail), ..warning }));
}

impl Reply for ValidationSet {
    /// The slip, the load, then `measured.` and `predicted.method.` with the name of each column.
    fn columns(&self) -> Vec<(Cow<'static, str>, &[f64])> {
        let ValidationColumns { slip, normal_load_n, measured, predicted } = &self.columns;
        let mut columns = vec![(Cow::from("slip"), slip.0.as_slice()), (Cow::from("normal_load_n"), normal_load_n.0.as_slice())];
        columns.extend(measured.named().map(|(name, column)| (Cow::from(format!("measured.{name}")), column)));
        for (method, forces) in METHODS.iter().zip([&predicted.quadrature, &predicted.linearised, &predicted.explicit]) {
            columns.extend(forces.named().map(|(name, column)| (Cow::from(format!("predicted.{method}.{name}")), column)));
        }
        columns
    }

    fn warnings(&self) -> &[Warning] {
        &self.warnings
    }
}
