//! The running estimate of the soil's strength in `/v1/track`.

use serde_json::{Value, json};

use crate::asking::{Answer, post, post_for_csv, request, send, with};
use crate::track::{path, stream_to};

/// Noisy samples and what dense matrices make of them, by `strength.py` beside it.
const REFERENCE: &str = include_str!("../../crates/identification/tests/reference/strength.json");

/// What the reference promises, see its test in the crate.
const DENSE: f64 = 1e-7;

fn reference() -> Value {
    serde_json::from_str(REFERENCE).expect("JSON")
}

/// A run on a soil that has nothing of the samples' own but the shear modulus, with the displacement on the rim, as the reference has it.
fn settings() -> Value {
    let reference = reference();
    json!({"wheel": reference["wheel"], "contact": reference["contact"], "method": "linearised",
        "shear_displacement_radius": "rim",
        "soil": {"cohesion_pa": 10, "friction_angle_rad": 0.2, "shear_modulus_m": reference["shear_modulus_m"],
            "pressure_sinkage": {"law": "direct", "k_s": 1e6, "n0": 1}}})
}

const NAMES: [&str; 4] = ["slip", "sinkage_m", "normal_load_n", "torque_n_m"];

/// The first samples of the reference, as columns.
fn samples(count: usize) -> Value {
    let reference = reference();
    let rows = reference["samples"].as_array().expect("samples");
    let mut columns = json!({"time_s": (0..count).collect::<Vec<_>>()});
    for (i, name) in NAMES.iter().enumerate() {
        columns[*name] = rows.iter().take(count).map(|row| row[i].clone()).collect();
    }
    columns
}

fn table(columns: &Value, names: &[&str]) -> String {
    let rows = columns["time_s"].as_array().expect("times").len();
    let line = |row: usize| names.iter().map(|name| columns[*name][row].to_string()).collect::<Vec<_>>().join(",");
    format!("{}\n{}\n", names.join(","), (0..rows).map(line).collect::<Vec<_>>().join("\n"))
}

fn lines(columns: &Value, names: &[&str]) -> String {
    let rows = columns["time_s"].as_array().expect("times").len();
    let line = |row: usize| -> Value { names.iter().map(|name| ((*name).to_owned(), columns[*name][row].clone())).collect() };
    (0..rows).map(|row| format!("{}\n", line(row))).collect()
}

fn codes(reply: &Value) -> Vec<&str> {
    reply["warnings"].as_array().expect("warnings").iter().filter_map(|warning| warning["code"].as_str()).collect()
}

#[test]
fn every_row_has_the_estimate_of_dense_matrices() {
    let columns = samples(60);
    for case in reference()["cases"].as_array().expect("cases") {
        let asked = with(&settings(), json!({"strength": {"forgetting_factor": case["forgetting_factor"]}, "columns": columns}));
        let reply = post("/v1/track", &asked).ok();
        assert_eq!(reply["columns"]["status"], json!(vec!["ok"; 60]));
        assert!(codes(&reply).contains(&"linearised_stresses"));
        for known in case["estimates"].as_array().expect("estimates") {
            let row = known["row"].as_u64().expect("a row") as usize;
            for (name, reference) in [
                ("cohesion_pa", "cohesion_pa"),
                ("tan_friction", "tan_friction"),
                ("cohesion_variance_pa2", "cohesion_variance_pa2"),
                ("tan_friction_variance", "tan_friction_variance"),
                ("cohesion_tan_friction_covariance_pa", "covariance_pa"),
            ] {
                let found = reply["columns"][name][row].as_f64().unwrap_or_else(|| panic!("{name} {row} in {reply}"));
                let expected = known[reference].as_f64().expect("a number");
                assert!((found / expected - 1.0).abs() < DENSE, "{asked} {name} {row}: {found}, not {expected}");
            }
        }
        let cell = |name: &str, row: usize| reply["columns"][name][row].as_f64();
        assert_eq!((cell("cohesion_pa", 0), cell("tan_friction", 0)), (None, None), "one sample determines no line");
        assert!(cell("tan_friction", 1).is_some() && cell("tan_friction_variance", 1).is_none(), "two leave no freedom");
    }
}

/// Without forgetting the last row is the line through all samples.
#[test]
fn a_run_that_forgets_nothing_ends_at_the_batch() {
    let columns = samples(40);
    let asked = with(&settings(), json!({"strength": {"forgetting_factor": 1}, "columns": columns}));
    let run = post("/v1/track", &asked).ok();
    let data = json!({"slip": columns["slip"], "sinkage_m": columns["sinkage_m"], "torque_n_m": columns["torque_n_m"],
        "normal_force_n": columns["normal_load_n"]});
    let fit = json!({"estimator": "linear", "fit": ["cohesion_pa", "friction_angle_rad"], "data": data});
    let batch = post("/v1/identify", &with(&settings(), fit)).ok();
    let last = |name: &str| run["columns"][name][39].as_f64().expect("a number");
    let [cohesion, friction] = [0, 1].map(|i| batch["estimates"][i].clone());
    let number = |estimate: &Value, name: &str| estimate[name].as_f64().expect("a number");
    assert_eq!(last("cohesion_pa"), number(&cohesion, "value"));
    assert_eq!(last("tan_friction").atan(), number(&friction, "value"));
    assert_eq!(last("cohesion_variance_pa2").sqrt(), number(&cohesion, "standard_error"));
}

#[test]
fn every_form_has_the_same_numbers() {
    let columns = samples(8);
    let names = ["time_s", "slip", "sinkage_m", "normal_load_n", "torque_n_m"];
    let asked = with(&settings(), json!({"strength": true}));
    let body = with(&asked, json!({ "columns": columns }));
    let (reply, text) = (post("/v1/track", &body).ok(), post_for_csv("/v1/track", &body).text);
    let last = text.lines().nth(8).expect("a row").to_owned();
    assert!(last.ends_with(&format!(",{}", reply["columns"]["cohesion_tan_friction_covariance_pa"][7])), "{last}");
    assert!(path(&asked).ends_with("&strength=true") || path(&asked).contains("strength=true&"), "{}", path(&asked));
    let of_table = stream_to(&asked, "text/csv", "text/csv", table(&columns, &names));
    assert_eq!(of_table.text, text);
    let of_lines = stream_to(&asked, "application/x-ndjson", "text/csv", lines(&columns, &names));
    assert_eq!(of_lines.text, text);
    // `true` stands for the defaults.
    let spelt_out = with(&body, json!({"strength": {"forgetting_factor": 0.99}}));
    let spelt_out = send(request("POST", "/v1/track", &[("content-type", "application/json")], spelt_out.to_string()));
    assert_eq!(spelt_out.json(), reply);
    let unasked = post("/v1/track", &with(&body, json!({"strength": null}))).ok();
    assert!(unasked["columns"].get("tan_friction").is_none() && !codes(&unasked).contains(&"linearised_stresses"));
}

/// A bad sample, one at rest and one without a torque leave the estimate as it was.
#[test]
fn only_samples_that_move_and_are_measured_count() {
    let mut columns = samples(12);
    let slips: Vec<f64> = columns["slip"].as_array().expect("slips").iter().filter_map(Value::as_f64).collect();
    columns.as_object_mut().expect("columns").remove("slip");
    columns["angular_velocity_rad_s"] = json!(vec![1; 12]);
    columns["forward_velocity_m_s"] = slips.iter().map(|slip| json!(0.15 * (1.0 - slip))).collect();
    for (name, row, value) in [
        ("torque_n_m", 5, Value::Null),
        ("sinkage_m", 6, Value::Null),
        ("forward_velocity_m_s", 7, json!(0)),
        ("angular_velocity_rad_s", 7, json!(0)),
    ] {
        columns[name][row] = value;
    }
    let body = with(&with(&settings(), json!({"strength": true})), json!({ "columns": columns }));
    let reply = post("/v1/track", &body).ok();
    let found = &reply["columns"];
    assert_eq!(found["status"][7], "static");
    for row in 5..=7 {
        assert_eq!(found["tan_friction"][row], found["tan_friction"][4], "{row}");
    }
    assert_ne!(found["tan_friction"][8], found["tan_friction"][4]);
    // Driven backwards, a wheel shows the same strength.
    let mut mirrored = body.clone();
    for name in ["forward_velocity_m_s", "angular_velocity_rad_s", "torque_n_m"] {
        let turned = body["columns"][name].as_array().expect("a column").iter();
        mirrored["columns"][name] = turned.map(|value| value.as_f64().map_or(Value::Null, |value| json!(-value))).collect();
    }
    assert_eq!(post("/v1/track", &mirrored).ok()["columns"]["tan_friction"], found["tan_friction"]);
}

#[test]
fn a_run_under_one_load_is_flagged() {
    let constant = |name: &str, value: f64| {
        let columns = with(&samples(30), json!({name: vec![value; 30]}));
        let reply = post("/v1/track", &with(&settings(), json!({"strength": true, "columns": columns}))).ok();
        codes(&reply).into_iter().map(str::to_owned).collect::<Vec<_>>()
    };
    assert!(constant("normal_load_n", 60.0).contains(&"single_load".to_owned()));
    assert!(constant("slip", 0.3).contains(&"single_slip".to_owned()));
    let asked = with(&settings(), json!({"strength": true, "columns": samples(30)}));
    let reply = post("/v1/track", &asked).ok();
    assert!(!codes(&reply).contains(&"single_load") && !codes(&reply).contains(&"single_slip"), "{}", reply["warnings"]);
    let none = post("/v1/track", &with(&settings(), json!({"strength": true, "columns": samples(1)}))).ok();
    assert!(codes(&none).contains(&"not_identifiable"));
}

/// Torques that fall short of a line through zero: the cohesion stays at 0, and has no variance.
#[test]
fn a_cohesion_held_at_zero_is_marked() {
    let mut columns = samples(30);
    for row in 0..30 {
        let (load, torque) = (columns["normal_load_n"][row].as_f64(), columns["torque_n_m"][row].as_f64());
        columns["torque_n_m"][row] = json!(load.zip(torque).map(|(load, torque)| torque * load / 200.0));
    }
    let reply = post("/v1/track", &with(&settings(), json!({"strength": true, "columns": columns}))).ok();
    let last = |name: &str| reply["columns"][name][29].clone();
    assert_eq!((last("cohesion_pa"), last("cohesion_variance_pa2")), (json!(0.0), Value::Null), "{reply}");
    assert_eq!(last("cohesion_tan_friction_covariance_pa"), Value::Null);
    assert!(last("tan_friction_variance").is_number() && codes(&reply).contains(&"at_bound"));
}

/// A sinkage that is modelled follows from the very soil that is sought, so that only a measured one will do.
#[test]
fn a_strength_needs_what_is_measured() {
    let asked = with(&settings(), json!({"strength": {}, "static_sinkage_m": 0.01}));
    let columns = samples(3);
    let answers = |asked: &Value, names: &[&str]| -> Vec<Answer> {
        let kept: Value = names.iter().map(|name| ((*name).to_owned(), columns[*name].clone())).collect();
        let query = with(asked, json!({"strength": true}));
        vec![
            post("/v1/track", &with(asked, json!({ "columns": kept }))),
            stream_to(&query, "text/csv", "*/*", table(&columns, names)),
            stream_to(&query, "application/x-ndjson", "*/*", lines(&columns, names)),
        ]
    };
    for answer in answers(&asked, &["time_s", "slip", "torque_n_m", "normal_load_n"]) {
        assert_eq!(answer.pointers(), ["/columns/sinkage_m"]);
        assert_eq!(answer.fault("/columns/sinkage_m"), "`strength` needs this column, as measured");
    }
    for answer in answers(&asked, &["time_s", "slip", "sinkage_m", "normal_load_n"]) {
        assert_eq!(answer.pointers(), ["/columns/torque_n_m"]);
    }
    for answer in answers(&asked, &["time_s", "slip", "sinkage_m", "torque_n_m"]) {
        assert_eq!(answer.pointers(), ["/columns/normal_load_n"]);
    }
    let constant = with(&asked, json!({"static_sinkage_m": null, "normal_load_n": 80}));
    for answer in answers(&constant, &["time_s", "slip", "sinkage_m", "torque_n_m"]) {
        assert_eq!(answer.status, 200, "{}", answer.text);
    }
    let whole = with(&asked, json!({ "columns": columns }));
    let faults = |changes: Value| post("/v1/track", &with(&whole, changes)).pointers();
    assert_eq!(faults(json!({"soil": {"shear": {"law": "wong_peak", "peak_displacement_m": 0.02}}})), ["/strength"]);
    assert_eq!(faults(json!({"strength": {"forgetting_factor": 1.1}})), ["/strength/forgetting_factor"]);
    let wrong = post("/v1/track", &with(&with(&whole, json!({"strength": null})), json!({"strength": false})));
    assert_eq!(wrong.fault("/strength"), "must be an object or true, not false");
}
