//! What the model gives at the points of a set: each is the request that a client would send to `/v1/forces`.

use serde_json::json;
use terramechanics::{Caution, OperatingPoint, Outcome, cautions};

use super::Record;
use crate::reply::RowCautions;
use crate::request::{ForcesDto, ForcesQuery, checked};
use crate::wire::read;

/// The methods that every set is run by.
pub(crate) const METHODS: [&str; 3] = ["quadrature", "linearised", "explicit"];

/// What one method gives at the measured slips and loads, NaN where it has no solution.
#[derive(Debug)]
pub(crate) struct Prediction {
    pub(crate) longitudinal_force: Vec<f64>,
    pub(crate) sinkage: Vec<f64>,
    pub(crate) torque: Vec<f64>,
    /// Points without a solution, and why.
    pub(crate) gaps: Vec<(usize, String)>,
    /// What to take with care, with its points.
    pub(crate) cautions: RowCautions,
}

impl Prediction {
    /// The points of `record` by `method`.
    pub(crate) fn of(record: &Record, method: &str) -> Self {
        let points = record.points();
        let mut prediction = Self {
            longitudinal_force: Vec::new(),
            sinkage: Vec::new(),
            torque: Vec::new(),
            gaps: Vec::new(),
            cautions: RowCautions::default(),
        };
        for (row, (&slip, load)) in points.slip.iter().zip(points.load()).enumerate() {
            match point(record, method, slip, load) {
                Ok((point, cautions)) => {
                    let forces = &point.forces;
                    prediction.push([forces.longitudinal, point.sinkage, forces.torque]);
                    prediction.cautions.add(row, cautions.into_iter());
                }
                Err(reason) => {
                    prediction.push([f64::NAN; 3]);
                    prediction.gaps.push((row, reason));
                }
            }
        }
        prediction
    }

    fn push(&mut self, [longitudinal_force, sinkage, torque]: [f64; 3]) {
        self.longitudinal_force.push(longitudinal_force);
        self.sinkage.push(sinkage);
        self.torque.push(torque);
    }
}

/// The operating point at one slip under one load, or why there is none.
fn point(record: &Record, method: &str, slip: f64, load: f64) -> Result<(OperatingPoint, Vec<Caution>), String> {
    let query = query(record, method, slip, load)?;
    let point = query.operation.at(query.motion.slip).map_err(|error| error.to_string())?;
    let cautions = cautions(&query.operation, &Outcome::from(&point)).collect();
    Ok((point, cautions))
}

/// The request for one point.
fn query(record: &Record, method: &str, slip: f64, load: f64) -> Result<ForcesQuery, String> {
    let mut body = json!({
        "wheel": record.wheel, "soil": record.soil, "slip": slip, "normal_load_n": load, "method": method
    });
    if let Some(contact) = &record.contact {
        body["contact"] = contact.clone();
    }
    let field = read::<ForcesDto>(body.to_string().as_bytes()).map_err(|error| error.to_string())?;
    checked(&field).map_err(|faults| format!("{faults:?}"))
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
            for (slip, load) in record.points().slip.iter().zip(record.points().load()) {
                for method in METHODS {
                    assert_eq!(query(record, method, *slip, load).err(), None, "{}", record.id);
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
