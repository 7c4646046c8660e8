//! The posterior of an identification: what a fit tells of its parameters, as uncertain fields.

use terramechanics_identification::{Home, Unknown};
use terramechanics_reading::{
    Field, Flag, Kind, Label, Node, Number, Numbers, Object, Objects, Path, Reader, Scope, Text, unknown_word,
};
use terramechanics_uncertainty::{Bounds, Correlation, Distribution, Marginal, has_size};
use utoipa::openapi::schema::{AdditionalProperties, ObjectBuilder, Type};
use utoipa::openapi::{RefOr, Schema};

use super::matrix::Matrix;
use crate::varied::varied_field;

/// Most estimates.
const MOST: usize = 8;

const PARAMETER: Field<Label> = Field::required("parameter", "The parameter, as in `fit` of /v1/identify.", Label);
const VALUE: Field<Number> = Field::required("value", "Its estimate.", Number::any(""));
const STANDARD_ERROR: Field<Number> =
    Field::new("standard_error", "Its standard error, which it must have: the data have to determine it.", Number::any(""));
const INTERVAL: Field<Numbers> = Field::new(
    "interval_95",
    "Its 95 % interval, which tells on which scale it was fitted: where the estimate is the geometric mean of the ends, the distribution is lognormal with the estimate as its median; else it is normal.",
    Numbers::new(Number::any(""), 2, 2),
);

/// What else an estimate of /v1/identify has, and what is not needed here.
const FOUND: Field<Label> = Field::new("found", "Left out.", Label);
const AT_BOUND: Field<Flag> = Field::new("at_bound", "Left out.", Flag);
const MODEL_BIAS: Field<Number> = Field::new("model_bias", "Left out.", Number::any(""));
const IDENTIFIABILITY: Field<Text> = Field::new("identifiability", "Left out.", Text { longest: 1000 });
const KNOWN: Field<LeftOut> = Field::new("known", "Left out.", LeftOut);

const ESTIMATE: Object = Object {
    name: "PosteriorEstimate",
    doc: "An estimate, as /v1/identify gives it.",
    groups: &[&[&PARAMETER, &VALUE, &STANDARD_ERROR, &INTERVAL, &FOUND, &AT_BOUND, &MODEL_BIAS, &IDENTIFIABILITY, &KNOWN]],
};
const ESTIMATES: Field<Objects> = Field {
    required: true,
    ..Field::new("estimates", "`estimates` of the answer.", Objects { object: &ESTIMATE, fewest: 1, most: MOST })
};
const CORRELATION: Field<Matrix> =
    Field { required: true, ..Field::new("correlation", "`correlation` of the answer.", Matrix { most: MOST }) };

const OBJECT: Object = Object {
    name: "Posterior",
    doc: "What /v1/identify answers: its estimates, their standard errors and their correlation. Near the estimates the posterior is normal on the scale of the fit.",
    groups: &[&[&ESTIMATES, &CORRELATION]],
};
pub(super) const POSTERIOR: Field<&Object> = Field::new(
    "posterior",
    "`estimates` and `correlation` of an answer of /v1/identify: each parameter is then an uncertain field of the request, where it belongs, correlated with the others. `request` takes the `soil` and `contact` of that answer.",
    &OBJECT,
);

/// How far a matrix may be from being symmetric, by the rounding of a fit.
const ROUNDING: f64 = 1e-9;

/// What is only said of an estimate.
#[derive(Debug, Clone, Copy)]
struct LeftOut;

impl Kind for LeftOut {
    type Value<'a> = ();

    fn read<'a>(&self, _: &'a Node<'a>, _: Scope<'a>) -> Option<()> {
        Some(())
    }

    fn schema(&self, meaning: &str) -> RefOr<Schema> {
        let object = ObjectBuilder::new().schema_type(Type::Object).description(Some(meaning));
        object.additional_properties(Some(AdditionalProperties::FreeForm(true))).into()
    }

    fn what(&self) -> &'static str {
        "an object"
    }
}

/// The parameters of a fit, in their order.
pub(super) struct Posterior {
    pub(super) parameters: Vec<(Path, Marginal)>,
    pub(super) correlation: Vec<Vec<f64>>,
}

/// The posterior of a request like `request`, if one was sent.
pub(super) fn read(object: &Reader<'_>, request: &'static Object) -> Option<Option<Posterior>> {
    let Some(posterior) = object.optional(&POSTERIOR)? else { return Some(None) };
    let estimates = posterior.required(&ESTIMATES);
    let parameters = estimates.and_then(|estimates| estimates.each(|estimate, _| parameter(estimate, request)));
    let matrix = posterior.required(&CORRELATION);
    let (parameters, matrix) = (parameters?, matrix?);
    let place = posterior.place_of(&CORRELATION);
    let correlation = symmetric(matrix);
    has_size(&correlation, parameters.len()).map_err(|error| place.fault(error)).ok()?;
    Correlation::new(correlation.clone()).map_err(|error| place.fault(error)).ok()?;
    Some(Some(Posterior { parameters, correlation }))
}

/// Reports a fault of the parameter of an estimate.
pub(super) fn fault_of_parameter(object: &Reader<'_>, estimate: usize, detail: &str) {
    object.place_of(&POSTERIOR).field(ESTIMATES.name).item(estimate).field(PARAMETER.name).fault(detail);
}

/// One parameter: its field and its distribution.
fn parameter(estimate: &Reader<'_>, request: &'static Object) -> Option<(Path, Marginal)> {
    let (name, value) = (estimate.required(&PARAMETER), estimate.required(&VALUE));
    let (error, interval) = (estimate.optional(&STANDARD_ERROR), estimate.optional(&INTERVAL));
    let place = estimate.place_of(&PARAMETER);
    let field = name.and_then(|name| varied_field(request, &pointer(name, &place)?, &place));
    let Some(error) = error? else {
        estimate.place_of(&STANDARD_ERROR).fault(
            "is needed: the data leave this parameter open. Hold it at a value and fit the others, or give it a distribution in `inputs`",
        );
        return None;
    };
    let ((path, number), value) = (field?, value?);
    let [lower, upper] = number.range();
    let distribution = distribution(value, error, interval?);
    let marginal = Marginal::new(distribution, Bounds { lower, upper });
    Some((path, marginal.map_err(|error| estimate.place_of(&STANDARD_ERROR).fault(error)).ok()?))
}

/// Where a request has the parameter of a fit.
fn pointer(name: &str, place: &Scope<'_>) -> Option<String> {
    let Some(unknown) = Unknown::ALL.into_iter().find(|unknown| unknown.name() == name) else {
        unknown_word(place, name, &Unknown::ALL.map(Unknown::name));
        return None;
    };
    Some(match unknown.home() {
        Home::Soil => format!("/soil/{name}"),
        Home::Shear if unknown == Unknown::SHEAR_MODULUS => format!("/soil/{name}"),
        Home::Shear => format!("/soil/shear/{name}"),
        Home::PressureSinkage => format!("/soil/pressure_sinkage/{name}"),
        Home::Rule => format!("/contact/{name}"),
        Home::Interface => format!("/contact/interface/{}", name.trim_start_matches("interface_")),
        Home::Method | Home::Sinkage => format!("/{name}"),
    })
}

/// Normal on the scale of the fit.
fn distribution(value: f64, error: f64, interval: Option<&[f64]>) -> Distribution {
    let is_logarithmic = |ends: &[f64]| {
        let &[low, high] = ends else { return false };
        low > 0.0 && value > 0.0 && (low / value * (high / value) - 1.0).abs() < 1e-6
    };
    if !interval.is_some_and(is_logarithmic) {
        return Distribution::Normal { mean: value, deviation: error };
    }
    let variance = (error / value).powi(2);
    let mean = value * (0.5 * variance).exp();
    Distribution::LogNormal { mean, deviation: mean * variance.exp_m1().sqrt() }
}

/// The matrix without the rounding by which a fit leaves it unsymmetric.
fn symmetric(matrix: Vec<Vec<f64>>) -> Vec<Vec<f64>> {
    let count = matrix.len();
    if matrix.iter().any(|row| row.len() != count) {
        return matrix;
    }
    let coefficient = |row: usize, column: usize| {
        let (here, there) = (matrix[row][column], matrix[column][row]);
        match (here - there).abs() <= ROUNDING {
            true if row == column && (here - 1.0).abs() <= ROUNDING => 1.0,
            true => 0.5 * (here + there),
            false => here,
        }
    };
    (0..count).map(|row| (0..count).map(|column| coefficient(row, column)).collect()).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    /// By hand: a median of 2 and a deviation of the logarithm of 0.1.
    #[test]
    fn the_interval_tells_the_scale() {
        let factor = 0.2f64.exp();
        let Distribution::LogNormal { mean, deviation } = distribution(2.0, 0.2, Some(&[2.0 / factor, 2.0 * factor])) else {
            panic!("not lognormal");
        };
        assert!((mean - 2.0 * 0.005f64.exp()).abs() < 1e-12);
        assert!((deviation / mean - 0.01f64.exp_m1().sqrt()).abs() < 1e-12);
        for interval in [None, Some(&[1.6, 2.4][..]), Some(&[-1.0, 5.0][..])] {
            assert_eq!(distribution(2.0, 0.2, interval), Distribution::Normal { mean: 2.0, deviation: 0.2 });
        }
    }
}
