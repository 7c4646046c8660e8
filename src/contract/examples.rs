//! Examples for the contract: requests as a user would send them, and what the service answers.
//!
//! Numbers of replies are rounded, so that the document does not depend on the last bit of a machine's library.

use std::time::Duration;

use axum::body::Bytes;
use serde_json::{Value, json};
use terramechanics_reading::Node;
use utoipa::openapi::path::ParameterBuilder;
use utoipa::openapi::{OpenApi, RefOr};

use crate::catalogue;
use crate::compute::Pace;
use crate::extract::SeriesForm;
use crate::found;
use crate::quantity::csv;
use crate::reply::{
    CompareReply, CoupledReply, ForcesReply, IdentifyReply, PlatesReply, ProfileReply, Reply, ResistancesReply, ShearReply,
    SweepReply, TowedReply, ValidationSet,
};
use crate::request::{
    CompareCase, CoupledCase, ForcesCase, IdentifyCase, PlatesCase, ProfileCase, Request, ResistancesCase, ShearTestsCase,
    SweepCase, TowedCase, TrackCase, checked,
};
use crate::series::Run;
use crate::stream::{Progress, Work};
use crate::validation;

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

fn bodies() -> [(&'static str, Value, Answer); 11] {
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
        "methods": ["quadrature", "explicit"],
        "variants": [{"name": "half sinkage", "contact": {"rule": "half_sinkage"}}]
    });
    let track = json!({
        "wheel": {"preset": "letter"}, "soil": {"preset": "letter-sand"}, "normal_load_n": 80, "method": "explicit",
        "columns": {
            "time_s": [0, 1, 2, 3], "forward_velocity_m_s": [0, 0.16, null, 0.1], "angular_velocity_rad_s": [0, 1, 1, 1]
        }
    });
    let track_reply = track_answer(&track);
    let coupled = json!({
        "wheel": {"preset": "letter"}, "soil": {"preset": "letter-sand"}, "slip": 0.2, "sinkage_m": 0.02, "normal_load_n": 80
    });
    let coupled_reply = answer::<CoupledCase, _>(&coupled, |query| found::coupled(query).ok().map(CoupledReply::from));
    let resistances = json!({
        "wheel": {"radius_m": 0.4065, "width_m": 0.229},
        "soil": {"preset": "lunar-apollo-nominal", "friction_angle_rad": 0.576, "unit_weight_n_m3": 2472},
        "normal_load_n": 259, "slip": 0.05
    });
    let resistances_reply =
        answer::<ResistancesCase, _>(&resistances, |query| found::resistances(query).ok().map(ResistancesReply::from));
    let towed = json!({"wheel": {"preset": "letter"}, "soil": {"preset": "letter-sand"}, "normal_load_n": 80});
    // The integrals of the letter's example, computed independently with 401 000 points.
    let identify = json!({
        "wheel": {"preset": "letter"}, "soil": {"cohesion_pa": 0},
        "fit": ["friction_angle_rad", "shear_modulus_m", "k_s", "n0"],
        "data": {
            "slip": [0.05, 0.2, 0.5, 0.05, 0.2, 0.5],
            "sinkage_m": [0.01, 0.01, 0.01, 0.02, 0.02, 0.02],
            "longitudinal_force_n": [1.031, 6.546, 9.734, 5.911, 16.906, 21.748],
            "normal_force_n": [32.203, 33.025, 33.601, 87.205, 89.716, 91.117],
            "torque_n_m": [1.2247, 2.3421, 2.9912, 5.0744, 7.3396, 8.3513]
        },
        "bounds": {"shear_modulus_m": [0.001, 0.05]}
    });
    let identify_reply = answer::<IdentifyCase, _>(&identify, |query| {
        found::identify(query, Duration::from_secs(60), &Pace::at_once()).ok().map(IdentifyReply::from)
    });
    // Dry sand under two plates, every other point: Yoshida et al. 2003, Annual Conference of the Robotics Society of Japan, 3G12.
    let plates = json!({
        "plates": [
            {"width_m": 0.06, "columns": {"sinkage_m": [0.00071, 0.001116, 0.001829, 0.002538], "pressure_pa": [247, 438, 885, 1291]}},
            {"width_m": 0.116, "columns": {"sinkage_m": [0.000813, 0.001219, 0.00193, 0.002538], "pressure_pa": [469, 974, 1744, 2465]}}
        ]
    });
    // (500 Pa + 0.6 σ)(1 − exp(−j/10 mm)), to the nearest 10 Pa.
    let shear = json!({
        "curves": [
            {"normal_stress_pa": 2000, "columns": {"displacement_m": [0.005, 0.01, 0.02, 0.04], "shear_stress_pa": [670, 1070, 1470, 1670]}},
            {"normal_stress_pa": 8000, "columns": {"displacement_m": [0.005, 0.01, 0.02, 0.04], "shear_stress_pa": [2090, 3350, 4580, 5200]}}
        ]
    });
    let plates_reply =
        answer::<PlatesCase, _>(&plates, |query| found::plates(query, &Pace::at_once()).ok().map(PlatesReply::from));
    let shear_reply =
        answer::<ShearTestsCase, _>(&shear, |query| found::shear(query, &Pace::at_once()).ok().map(ShearReply::from));
    let compare_reply =
        answer::<CompareCase, _>(&compare, |query| found::compare(query, &Pace::at_once()).ok().map(CompareReply::from));
    let forces_reply = answer::<ForcesCase, _>(&forces, |query| found::forces(query).ok().map(ForcesReply::from));
    let profile_reply = answer::<ProfileCase, _>(&profile, |query| found::profile(query).ok().map(ProfileReply::from));
    let sweep_reply = answer::<SweepCase, _>(&sweep, |query| found::sweep(query, &Pace::at_once()).ok().map(SweepReply::from));
    let towed_reply = answer::<TowedCase, _>(&towed, |query| found::towed(query).ok().map(TowedReply::from));
    [
        ("/v1/forces", forces, forces_reply),
        ("/v1/stress-profile", profile, profile_reply),
        ("/v1/slip-sweep", sweep, sweep_reply),
        ("/v1/compare", compare, compare_reply),
        ("/v1/coupled", coupled, coupled_reply),
        ("/v1/resistances", resistances, resistances_reply),
        ("/v1/towed", towed, towed_reply),
        ("/v1/identify", identify, identify_reply),
        ("/v1/identify/plates", plates, plates_reply),
        ("/v1/identify/shear", shear, shear_reply),
        ("/v1/track", track, track_reply),
    ]
}

/// What a run over samples gives, in every form.
fn track_answer(request: &Value) -> Answer {
    let run = |form: SeriesForm| {
        let case = checked::<TrackCase>(&Node::from(request)).ok()?;
        let mut output = Vec::new();
        let mut run = Run::over_samples(case, form);
        while run.slice(&mut Bytes::new(), true, &mut output).ok()? != Progress::Complete {}
        String::from_utf8(output).ok()
    };
    let json: Option<Value> = run(SeriesForm::Json).and_then(|text| serde_json::from_str(&text).ok());
    let rounded_cell = |cell: &str| cell.parse().map_or_else(|_| cell.to_owned(), |value: f64| format!("{:?}", rounded(value)));
    let rounded_line = |line: &str| match line.strip_prefix('#') {
        Some(_) => line.to_owned(),
        None => line.split(',').map(rounded_cell).collect::<Vec<_>>().join(","),
    };
    let rounded_object = |line: &str| serde_json::from_str(line).map(with_rounded_numbers).unwrap_or_default().to_string();
    let lines = |text: Option<String>, rounded: &dyn Fn(&str) -> String| -> String {
        text.iter().flat_map(|text| text.lines()).map(|line| rounded(line) + "\n").collect()
    };
    vec![
        ("application/json", json.map(with_rounded_numbers).unwrap_or_default()),
        ("text/csv", lines(run(SeriesForm::Csv), &rounded_line).into()),
        ("application/x-ndjson", lines(run(SeriesForm::Ndjson), &rounded_object).into()),
    ]
}

/// What the service answers, as JSON and as a table.
fn answer<R: Request, T: Reply>(request: &Value, reply: impl Fn(&R) -> Option<T>) -> Answer {
    let case = checked::<R>(&Node::from(request)).ok();
    case.and_then(|case| reply(&case)).map_or_else(Vec::new, |reply| written(&reply))
}

/// A reply as JSON and as a table.
fn written<T: Reply>(reply: &T) -> Answer {
    let columns: Vec<(_, Vec<f64>)> =
        reply.columns().into_iter().map(|(name, column)| (name, column.iter().copied().map(rounded).collect())).collect();
    let table: Vec<_> = columns.iter().map(|(name, column)| (name.clone(), column.as_slice())).collect();
    let json = serde_json::to_value(reply).map(with_rounded_numbers).unwrap_or_default();
    vec![(JSON, json), ("text/csv", String::from_utf8(csv(&table)).unwrap_or_default().into())]
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
    for (media_type, set) in validation::record("ding-2011-smooth")
        .map(|record| written(&ValidationSet::from(found::validation(record))))
        .unwrap_or_default()
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
