//! The answer of the linear estimator, in the same form.

use std::collections::BTreeMap;

use terramechanics::SoilParams;
use terramechanics_identification::{
    Column, FittedColumn, Quantity, RollingSample, StrengthBound, StrengthEstimate, StressPoint, linear_strength, quantile_95,
};

use super::columns::IdentifyColumns;
use super::words::number;
use super::{EstimateReply, IdentifyReply};
use crate::reply::Warning;
use crate::reply::soil::{ContactBody, SoilBody};
use crate::reply::warning::system_warnings;
use crate::request::{LinearQuery, refusal_pointer};
use crate::wire::FieldFault;

/// Half widths of cohesion (Pa) and of tan φ beyond which an estimate is of no use; a cohesion may be off by itself.
const USEFUL: (f64, f64) = (500.0, 0.25);

impl IdentifyReply {
    pub(super) fn of_line(query: &LinearQuery) -> Result<Self, FieldFault> {
        let LinearQuery { setup, shear_modulus, observations } = query;
        let refused = |(row, error): (usize, terramechanics::Error)| FieldFault {
            pointer: refusal_pointer(row, &error, &setup.sinkage),
            detail: error.to_string(),
        };
        let samples = samples(query);
        let (line, used) = linear_strength(setup.wheel, *shear_modulus, samples.iter().copied()).map_err(refused)?;
        let mut warnings = Vec::new();
        if used < samples.len() {
            let detail = format!(
                "{} of {} samples mobilise too little of the strength to show it and were left out",
                samples.len() - used,
                samples.len()
            );
            warnings.push(Warning::new("samples_left_out", detail));
        }
        let Some(line) = line else {
            let detail =
                "the normal stress under the wheel is the same in all samples: two different loads, sinkages or slips at \
                          least are needed to tell cohesion from friction"
                    .to_owned();
            return Err(FieldFault { pointer: "/data".to_owned(), detail });
        };
        let estimates = estimates(&line);
        let identifiable = estimates.iter().all(|(_, determined)| *determined);
        if !identifiable {
            let detail = "the data do not determine both parameters; see each one's `identifiability`".to_owned();
            warnings.push(Warning::new("not_identifiable", detail));
        }
        if let Some(bound) = line.bound {
            let name = if bound == StrengthBound::NoCohesion { "cohesion_pa" } else { "friction_angle_rad" };
            warnings.push(Warning::new("at_bound", format!("{name} lies at its lower bound 0")));
        }
        let predicted: Result<Vec<f64>, _> = samples
            .iter()
            .enumerate()
            .map(|(row, sample)| {
                let torque = StressPoint::torque(&setup.wheel, *shear_modulus, sample, line.cohesion, line.tan_friction);
                torque.map_err(|error| refused((row, error)))
            })
            .collect();
        let torque = FittedColumn::new(Quantity::Torque, samples.iter().map(|sample| sample.torque).collect(), predicted?);
        let soil = SoilParams { cohesion: line.cohesion, friction_angle: line.tan_friction.atan(), ..setup.soil };
        warnings.extend(system_warnings(&setup.wheel, &soil));
        let coefficient = line.covariance / (line.cohesion_variance * line.tan_friction_variance).sqrt();
        let coefficient = coefficient.is_finite().then(|| coefficient.clamp(-1.0, 1.0));
        Ok(Self {
            estimator: "linear",
            method: "linearised",
            converged: true,
            identifiable,
            stop_reason: "linear",
            iterations: 1,
            evaluations: samples.len() as u64,
            estimates: estimates.into_iter().map(|(estimate, _)| estimate).collect(),
            correlation: vec![vec![Some(1.0), coefficient], vec![coefficient, Some(1.0)]],
            condition_number: Some(line.condition_number).filter(|number| number.is_finite()),
            dead_directions: Vec::new(),
            degrees_of_freedom: line.freedom,
            reduced_chi_square: None,
            rmse: BTreeMap::from([("torque_n_m", torque.rmse)]),
            columns: IdentifyColumns::of(observations, samples.iter().map(|sample| sample.sinkage).collect(), &[torque]),
            soil: SoilBody::from(&soil),
            contact: ContactBody::from(&setup.contact),
            warnings,
        })
    }
}

fn samples(query: &LinearQuery) -> Vec<RollingSample> {
    let values = |quantity: Quantity| query.observations.column(quantity).map_or(&[][..], |column: &Column| &column.values);
    let columns = values(Quantity::Sinkage).iter().zip(values(Quantity::Normal)).zip(values(Quantity::Torque));
    let slips = query.observations.slip.iter();
    slips.zip(columns).map(|(&slip, ((&sinkage, &load), &torque))| RollingSample { slip, sinkage, load, torque }).collect()
}

/// Both estimates, each with whether it is determined.
fn estimates(line: &StrengthEstimate) -> [(EstimateReply, bool); 2] {
    let factor = quantile_95(line.freedom);
    let has_freedom = line.freedom >= 1.0;
    let of = |parameter, value: f64, error: f64, useful: f64, at_bound: bool| {
        let error = (has_freedom && error.is_finite()).then_some(error);
        let half = error.map(|error| factor * error);
        let determined = half.is_some_and(|half| half <= useful);
        let identifiability = match (half, determined, at_bound) {
            (_, true, true) => "at its lower bound: the bound decides the value, the data may ask for one beyond".to_owned(),
            (Some(half), true, false) => format!("determined to ± {} (95 %)", number(half)),
            (Some(half), false, _) => format!("not determined: ± {} (95 %) is too wide to be of use", number(half)),
            (None, ..) => "not determined: no error can be stated, there are too few data".to_owned(),
        };
        let interval_95 = half.map(|half| [value - half, value + half]);
        (EstimateReply { parameter, value, standard_error: error, interval_95, at_bound, identifiability }, determined)
    };
    let angle_per_tangent = 1.0 / (1.0 + line.tan_friction * line.tan_friction); // dφ/d tan φ
    [
        of(
            "cohesion_pa",
            line.cohesion,
            line.cohesion_variance.sqrt(),
            line.cohesion.max(USEFUL.0),
            line.bound == Some(StrengthBound::NoCohesion),
        ),
        of(
            "friction_angle_rad",
            line.tan_friction.atan(),
            line.tan_friction_variance.sqrt() * angle_per_tangent,
            USEFUL.1 * angle_per_tangent,
            line.bound == Some(StrengthBound::NoFriction),
        ),
    ]
}
