//! What the model gives at the points of a set: each is the request that a client would send to `/v1/forces`.

use serde_json::{Map, Value};
use terramechanics::{Caution, OperatingPoint, Outcome, WheelOnSoil, cautions};
use terramechanics_reading::Node;

use super::compared::PULL_OVER_LOAD;
use super::{Record, Run};
use crate::api::forces::ForcesCase;
use crate::request::checked;
use crate::warning::{Reason, RowCautions};

/// What a request has in place of what its set has.
pub(super) struct Variation<'v> {
    /// Values of fields of the soil.
    pub(super) of_soil: &'v [(&'v str, f64)],
    /// Fields of the request.
    pub(super) fields: Option<&'v Map<String, Value>>,
}

impl Variation<'_> {
    const NONE: Self = Self { of_soil: &[], fields: None };
}

/// What one run gives at the measured slips and loads.
#[derive(Debug)]
pub(crate) struct Prediction {
    pub(crate) run: &'static Run,
    /// The points, or why there is none.
    points: Vec<Result<OperatingPoint, Reason>>,
    /// What to take with care, with its points.
    pub(crate) cautions: RowCautions,
}

impl Prediction {
    /// The points of `record` by `run`.
    pub(crate) fn of(record: &Record, run: &'static Run) -> Self {
        Self::with(record, run, &[])
    }

    /// The same with other values of these fields of the soil.
    pub(super) fn with(record: &Record, run: &'static Run, of_soil: &[(&str, f64)]) -> Self {
        Self::varied(record, run, &Variation { of_soil, ..Variation::NONE })
    }

    /// The same with what a variation has in place of the set's own.
    pub(super) fn varied(record: &Record, run: &'static Run, variation: &Variation<'_>) -> Self {
        let mut prediction = Self { run, points: Vec::new(), cautions: RowCautions::default() };
        for row in 0..record.points().slip.len() {
            let found = point(record, run, row, variation);
            prediction.points.push(found.map(|(point, cautions)| {
                prediction.cautions.add(row, cautions.into_iter());
                point
            }));
        }
        prediction
    }

    /// The points; none where there is no solution.
    pub(crate) fn points(&self) -> impl Iterator<Item = Option<&OperatingPoint>> {
        self.points.iter().map(|point| point.as_ref().ok())
    }

    /// Error of the pull over the load at each point; NaN where it was not measured or has no solution.
    pub(super) fn pull_errors(&self, record: &Record) -> Vec<f64> {
        let load = record.points().load();
        let (predicted, measured) =
            (PULL_OVER_LOAD.predicted(self.points(), &load), PULL_OVER_LOAD.measured(record.points(), &load));
        predicted.iter().zip(&measured).map(|(predicted, measured)| predicted - measured).collect()
    }

    /// Rows without a solution, and why.
    pub(crate) fn gaps(&self) -> Vec<(usize, Reason)> {
        let gaps = self.points.iter().enumerate();
        gaps.filter_map(|(row, point)| Some((row, point.as_ref().err()?.clone()))).collect()
    }
}

/// The operating point of a row, or why there is none.
fn point(record: &Record, run: &Run, row: usize, variation: &Variation<'_>) -> Result<(OperatingPoint, Vec<Caution>), Reason> {
    let case = case(record, run, row, variation).map_err(Reason::Request)?;
    let (_, point) = case.point().map_err(Reason::Model)?;
    let cautions = cautions(&case.operation, &Outcome::from(&point)).collect();
    Ok((point, cautions))
}

/// The wheel on its soil; none where the record is no request.
pub(crate) fn system(record: &Record) -> Option<WheelOnSoil> {
    case(record, record.runs().first()?, 0, &Variation::NONE).ok().map(|case| case.operation.system)
}

/// The request for a row, with what a variation has.
fn case(record: &Record, run: &Run, row: usize, variation: &Variation<'_>) -> Result<ForcesCase, String> {
    let points = record.points();
    let mut body = run.fields();
    body["wheel"] = record.wheel.clone();
    body["soil"] = record.soil.clone();
    body["slip_radius"] = record.slip_radius.as_str().into();
    body["slip"] = record.slip()[row].into();
    body["normal_load_n"] = points.load()[row].into();
    if let Some(contact) = record.contact_at(points.slip[row]) {
        body["contact"] = contact;
    }
    if let Some(side) = record.side_slip {
        body["slip_angle_rad"] = side.angle().into();
    }
    for (name, value) in variation.of_soil {
        body["soil"][*name] = (*value).into();
    }
    for (name, value) in variation.fields.into_iter().flatten() {
        body[name] = value.clone();
    }
    if let Some((name, value)) = run.sinkage(points, row) {
        body[name] = value.into();
    }
    checked(&Node::from(&body)).map_err(|faults| {
        let told: Vec<String> = faults.iter().map(|fault| format!("{} {}", fault.pointer, fault.detail)).collect();
        told.join("; ")
    })
}

/// The root of the mean square of the errors that are numbers; none where there is none.
pub(crate) fn root_mean_square(errors: impl Iterator<Item = f64>) -> Option<f64> {
    let squares: Vec<f64> = errors.filter(|error| error.is_finite()).map(|error| error * error).collect();
    (!squares.is_empty()).then(|| (squares.iter().sum::<f64>() / squares.len() as f64).sqrt())
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::validation::records;

    /// What the model then refuses is a result; what is no request is a slip of the record.
    #[test]
    fn every_point_is_a_request() {
        for record in records() {
            for run in record.runs() {
                for row in 0..record.points().slip.len() {
                    assert_eq!(case(record, run, row, &Variation::NONE).err(), None, "{} {}", record.id, run.series);
                }
            }
        }
    }

    #[test]
    fn an_error_without_a_number_counts_neither_way() {
        assert_eq!(root_mean_square([3.0, f64::NAN, -4.0].into_iter()), Some(12.5_f64.sqrt()));
        assert_eq!(root_mean_square([f64::NAN].into_iter()), None);
    }
}
