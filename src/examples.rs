//! Examples for the contract: requests as a user would send them, and what the service answers.
//!
//! Numbers of replies are rounded, so that the document does not depend on the last bit of a machine's library.

use serde_json::{Value, json};
use utoipa::openapi::path::ParameterBuilder;
use utoipa::openapi::{OpenApi, RefOr};

use crate::catalogue;
use crate::reply::{
    CompareReply, CoupledReply, ForcesReply, ProfileReply, Reply, ResistancesReply, SweepReply, TowedReply, ValidationSet, csv,
};
use crate::request::{CompareDto, CoupledDto, ForcesDto, ProfileDto, Request, ResistancesDto, SweepDto, TowedDto, checked};
use crate::validation;
use crate::wire::read;

/// Digits kept of a number in an example.
const DIGITS: i32 = 6;

const JSON: &str = "application/json";

/// Puts an example of request and reply at every operation that has a body, and of the reply at those that need none.
pub(crate) fn attach(document: &mut OpenApi) {
    for (path, example, answer) in bodies() {
        let Some(operation) = document.paths.paths.get_mut(path).and_then(|item| item.post.as_mut()) else { continue };
        if let Some(RefOr::T(body)) = operation.request_body.as_mut()
            && let Some(RefOr::T(content)) = body.content.get_mut(JSON)
        {
            content.example = Some(example.clone());
        }
        for (media_type, example) in &answer {
            set_reply(operation, media_type, example.clone());
        }
        if let Some(twin) = document.paths.paths.get_mut(path).and_then(|item| item.get.as_mut()) {
            set_parameters(twin, &example);
            for (media_type, example) in answer {
                set_reply(twin, media_type, example);
            }
        }
    }
    for (path, media_type, example) in replies_without_a_body() {
        if let Some(operation) = document.paths.paths.get_mut(path).and_then(|item| item.get.as_mut()) {
            set_reply(operation, media_type, example);
        }
    }
}

fn set_reply(operation: &mut utoipa::openapi::path::Operation, media_type: &str, example: Value) {
    if let Some(RefOr::T(response)) = operation.responses.responses.get_mut("200")
        && let Some(RefOr::T(content)) = response.content.get_mut(media_type)
    {
        content.example = Some(example);
    }
}

/// Puts what the example of a body has at the parameters of its twin.
fn set_parameters(operation: &mut utoipa::openapi::path::Operation, body: &Value) {
    for parameter in operation.parameters.iter_mut().flatten() {
        let RefOr::T(parameter) = parameter else { continue };
        let pointer = format!("/{}", parameter.name.replace('.', "/"));
        if let Some(value) = body.pointer(&pointer) {
            *parameter = ParameterBuilder::from(parameter.clone()).example(Some(value.clone())).build();
        }
    }
}

type Answer = Vec<(&'static str, Value)>;

fn bodies() -> [(&'static str, Value, Answer); 7] {
    let forces = json!({
        "wheel": {"preset": "letter"}, "soil": {"preset": "letter-sand"}, "slip": 0.2, "sinkage_m": 0.02
    });
    let profile = json!({
        "wheel": {"radius_m": 0.2, "width_m": 0.1},
        "soil": {
            "cohesion_pa": 0, "friction_angle_rad": 0.478, "shear_modulus_m": 0.005,
            "pressure_sinkage": {"law": "bekker", "k_c": -660, "k_phi": 754_130, "n0": 0.91}
        },
        "contact": {"rule": "midpoint"}, "slip": 0.2, "sinkage_m": 0.02, "points": 5
    });
    let sweep = json!({
        "wheel": {"preset": "letter", "lug_height_m": 0.01}, "soil": {"preset": "letter-sand"},
        "slip": {"from": 0, "to": 1, "points": 6}, "normal_load_n": 80, "method": "linearised"
    });
    let compare = json!({
        "wheel": {"preset": "letter"}, "soil": {"preset": "letter-sand"}, "slip": [0.1, 0.3], "sinkage_m": 0.02,
        "methods": ["quadrature", "linearised", "explicit"]
    });
    let coupled = json!({
        "wheel": {"preset": "letter"}, "soil": {"preset": "letter-sand"}, "slip": 0.2, "sinkage_m": 0.02, "normal_load_n": 80
    });
    let coupled_reply = answer::<CoupledDto, _>(&coupled, |query| CoupledReply::try_from(query).ok());
    let resistances = json!({
        "wheel": {"radius_m": 0.4065, "width_m": 0.229},
        "soil": {"preset": "lunar-apollo-nominal", "friction_angle_rad": 0.576, "unit_weight_n_m3": 2472},
        "normal_load_n": 259, "slip": 0.05
    });
    let resistances_reply = answer::<ResistancesDto, _>(&resistances, |query| ResistancesReply::try_from(query).ok());
    let towed = json!({"wheel": {"preset": "letter"}, "soil": {"preset": "letter-sand"}, "normal_load_n": 80});
    let compare_reply = answer::<CompareDto, _>(&compare, |query| Some(CompareReply::from(query)));
    let forces_reply = answer::<ForcesDto, _>(&forces, |query| ForcesReply::try_from(query).ok());
    let profile_reply = answer::<ProfileDto, _>(&profile, |query| ProfileReply::try_from(query).ok());
    let sweep_reply = answer::<SweepDto, _>(&sweep, |query| Some(SweepReply::from(query)));
    let towed_reply = answer::<TowedDto, _>(&towed, |query| TowedReply::try_from(query).ok());
    [
        ("/v1/forces", forces, forces_reply),
        ("/v1/stress-profile", profile, profile_reply),
        ("/v1/slip-sweep", sweep, sweep_reply),
        ("/v1/compare", compare, compare_reply),
        ("/v1/coupled", coupled, coupled_reply),
        ("/v1/resistances", resistances, resistances_reply),
        ("/v1/towed", towed, towed_reply),
    ]
}

/// What the service answers, as JSON and as a table.
fn answer<R: Request, T: Reply>(request: &Value, reply: impl Fn(&R::Query) -> Option<T>) -> Answer {
    let text = request.to_string();
    let query = read::<R>(text.as_bytes()).ok().and_then(|field| checked(&field).ok());
    query.and_then(|query| reply(&query)).map_or_else(Vec::new, |reply| written(&reply))
}

/// A reply as JSON and as a table.
fn written<T: Reply>(reply: &T) -> Answer {
    let columns: Vec<(_, Vec<f64>)> =
        reply.columns().into_iter().map(|(name, column)| (name, column.iter().copied().map(rounded).collect())).collect();
    let table: Vec<_> = columns.iter().map(|(name, column)| (name.clone(), column.as_slice())).collect();
    let json = serde_json::to_value(reply).map(with_rounded_numbers).unwrap_or_default();
    vec![(JSON, json), ("text/csv", csv(&table).into())]
}

/// The entries of the catalogue and a set of measurements: path, media type, example.
fn replies_without_a_body() -> Vec<(&'static str, &'static str, Value)> {
    let wheel = catalogue::wheel("letter").and_then(|record| serde_json::to_value(record.view()).ok()).unwrap_or_default();
    let soil = catalogue::soil("letter-sand").and_then(|record| serde_json::to_value(record.view()).ok()).unwrap_or_default();
    let mut replies = vec![
        ("/v1/wheels", JSON, json!({"wheels": [wheel.clone()]})),
        ("/v1/soils", JSON, json!({"soils": [soil.clone()]})),
        ("/v1/wheels/{id}", JSON, wheel),
        ("/v1/soils/{id}", JSON, soil),
    ];
    for (media_type, set) in
        validation::record("ding-2011-smooth").map(|record| written(&ValidationSet::from(record))).unwrap_or_default()
    {
        if media_type == JSON {
            replies.push(("/v1/validation", JSON, json!({"sets": [set.clone()]})));
        }
        replies.push(("/v1/validation/{id}", media_type, set));
    }
    replies
}

fn rounded(value: f64) -> f64 {
    format!("{value:.*e}", DIGITS as usize - 1).parse().unwrap_or(value)
}

fn with_rounded_numbers(value: Value) -> Value {
    match value {
        Value::Number(number) if number.is_f64() => number.as_f64().map_or(Value::Null, |number| rounded(number).into()),
        Value::Array(items) => items.into_iter().map(with_rounded_numbers).collect(),
        Value::Object(fields) => fields.into_iter().map(|(name, value)| (name, with_rounded_numbers(value))).collect(),
        other => other,
    }
}
