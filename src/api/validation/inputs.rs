//! What is known of the inputs of a set, and what hangs on the shear modulus.

use serde::Serialize;
use serde_json::{Value, json};
use terramechanics::WheelParams;
use utoipa::ToSchema;

use crate::reply::{or_null, soil};
use crate::validation::{AtModulus, Origin, Record, system};

/// An input of a set.
#[derive(Debug, Serialize, ToSchema)]
#[schema(as = ValidationInput)]
pub(super) struct InputReply {
    /// The field of a request, with a dot between an object and its field.
    #[schema(example = "soil.shear_modulus_m")]
    name: &'static str,
    /// Its value; null where it is no single number.
    value: Option<f64>,
    origin: Origin,
    /// Where it comes from.
    source: &'static str,
}

/// A column that counts in no error.
#[derive(Debug, Serialize, ToSchema)]
#[schema(as = ValidationColumnNotScored)]
pub(super) struct NotScoredReply {
    /// Its name.
    #[schema(example = "torque_n_m")]
    column: &'static str,
    /// Why it is not trusted.
    reason: &'static str,
}

/// The error of the pull by the quadrature at one shear modulus.
#[derive(Debug, Serialize, ToSchema)]
#[schema(as = ValidationSensitivity)]
pub(super) struct SensitivityReply {
    /// Shear modulus K (m): half, one and two times that of the set.
    shear_modulus_m: f64,
    /// Error of the drawbar pull, at each point over its load (–).
    #[serde(serialize_with = "or_null")]
    #[schema(value_type = Option<f64>)]
    drawbar_rmse_over_load: f64,
    /// Points with a solution.
    solved: usize,
}

impl From<AtModulus> for SensitivityReply {
    fn from(AtModulus { shear_modulus, drawbar_error, solved }: AtModulus) -> Self {
        Self { shear_modulus_m: shear_modulus, drawbar_rmse_over_load: drawbar_error.unwrap_or(f64::NAN), solved }
    }
}

/// The inputs of a set, each with its value.
pub(super) fn inputs(record: &'static Record) -> Vec<InputReply> {
    let values = values(record);
    let value = |name: &str| values.pointer(&format!("/{}", name.replace('.', "/"))).and_then(Value::as_f64);
    let input = |name: &'static String, origin, source| InputReply { name, value: value(name), origin, source };
    let each = record.inputs.iter().flat_map(|of| of.names.iter().map(move |name| (name, of.origin, of.source.as_str())));
    each.map(|(name, origin, source)| input(name, origin, source)).collect()
}

/// The wheel and the soil of a set as a request would spell them out, and its slip where there is but one.
fn values(record: &Record) -> Value {
    let Some(system) = system(record) else { return Value::Null };
    let WheelParams { radius, width, lug_height, lug_coefficient } = *system.wheel.params();
    let wheel = json!({"radius_m": radius, "width_m": width, "lug_height_m": lug_height, "lug_coefficient": lug_coefficient});
    let soil = serde_json::to_value(soil::soil(system.soil.params())).unwrap_or_default();
    let slip = record.points().slip.first().filter(|_| record.points().slip.len() == 1);
    json!({"wheel": wheel, "soil": soil, "slip": slip})
}

/// The columns of a set that count in no error.
pub(super) fn not_scored(record: &'static Record) -> Vec<NotScoredReply> {
    record.not_scored.iter().map(|(column, reason)| NotScoredReply { column, reason }).collect()
}
