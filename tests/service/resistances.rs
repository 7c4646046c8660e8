//! `POST /v1/resistances`.

use serde_json::{Value, json};

use crate::asking::{letter, post, post_for_csv, table, with};

const PATH: &str = "/v1/resistances";

fn number(value: &Value, name: &str) -> f64 {
    value[name].as_f64().unwrap_or_else(|| panic!("{name} in {value}"))
}

/// The wheel of the lunar roving vehicle and its soil, as printed in course material (Akin, University of Maryland).
fn lunar(changes: Value) -> Value {
    let body = json!({
        "wheel": {"radius_m": 0.4065, "width_m": 0.229},
        "soil": {
            "cohesion_pa": 170, "friction_angle_rad": 0.576, "shear_modulus_m": 0.0178, "unit_weight_n_m3": 2472,
            "pressure_sinkage": {"law": "bekker", "k_c": 1400, "k_phi": 820_000, "n0": 1}
        },
        "normal_load_n": 259, "slip": 0.05
    });
    with(&body, changes)
}

fn codes(reply: &Value) -> Vec<&str> {
    reply["warnings"].as_array().expect("warnings").iter().filter_map(|warning| warning["code"].as_str()).collect()
}

#[test]
fn the_lunar_roving_vehicle_is_the_worked_example() {
    let reply = post(PATH, &lunar(json!({}))).ok();
    assert!((number(&reply, "rigid_wheel_sinkage_m") - 0.01731).abs() < 5e-6);
    assert!((number(&reply, "compaction_resistance_n") - 28.34).abs() < 5e-3);
    assert!((number(&reply, "bulldozing_resistance_n") - 90.41).abs() < 5e-3); // by mpmath, from the formula
    assert_eq!(reply["warnings"], json!([]));
}

#[test]
fn what_does_not_depend_on_the_shear_needs_no_shear_modulus() {
    let mut body = lunar(json!({"slip": null}));
    let known = post(PATH, &body).ok();
    body["soil"].as_object_mut().expect("an object").remove("shear_modulus_m");
    assert_eq!(post(PATH, &body).ok(), known);
    body["slip"] = json!(0.05);
    assert_eq!(post(PATH, &body).pointers(), ["/soil/shear_modulus_m"]);
}

/// Sixty random cases at fifty digits, by an implementation independent of this one.
#[test]
fn sixty_cases_of_another_program_come_back_over_http() {
    const CASES: &str = include_str!("../../crates/terramechanics/tests/reference/resistances.json");
    let cases: Vec<Value> = serde_json::from_str(CASES).expect("a fixture is JSON");
    for (i, case) in cases.iter().enumerate() {
        let reply = post(PATH, &case["input"]).ok();
        for (name, expected) in case["expected"].as_object().expect("results") {
            match expected.as_f64() {
                None => assert_eq!(reply[name], Value::Null, "case {i}: {name}"),
                Some(expected) => {
                    let off = number(&reply, name) / expected - 1.0;
                    assert!(off.abs() < 1e-12, "case {i}: {name} off by {off:e}");
                }
            }
        }
    }
}

#[test]
fn what_is_lacking_is_null_with_a_warning_that_names_the_field() {
    let reply = post(PATH, &lunar(json!({"slip": null, "soil": {"unit_weight_n_m3": null}}))).ok();
    assert_eq!((&reply["bulldozing_resistance_n"], &reply["thrust_n"]), (&Value::Null, &Value::Null));
    assert!(reply["rigid_wheel_sinkage_m"].is_number() && reply["compaction_resistance_n"].is_number());
    assert_eq!(codes(&reply), ["needs_unit_weight", "needs_driving_slip"]);
    let details: Vec<&str> = (0..2).filter_map(|i| reply["warnings"][i]["detail"].as_str()).collect();
    assert!(details[0].starts_with("`bulldozing_resistance_n`") && details[1].starts_with("`thrust_n`"));
    assert_eq!(codes(&post(PATH, &lunar(json!({"slip": -0.2}))).ok()), ["needs_driving_slip"]);
    let peak = json!({"soil": {"shear": {"law": "wong_peak", "peak_displacement_m": 0.02}}});
    assert_eq!(codes(&post(PATH, &lunar(peak)).ok()), ["needs_janosi_hanamoto"]);
    let steep = post(PATH, &lunar(json!({"soil": {"pressure_sinkage": {"n0": 3}}}))).ok();
    assert_eq!(codes(&steep), ["needs_exponent_below_three"; 4]);
    assert_eq!(steep["rigid_wheel_sinkage_m"], Value::Null);
}

#[test]
fn the_unit_weight_of_reeces_law_serves_too() {
    let reece = json!({"law": "reece", "k_c": 10, "k_phi": 500, "unit_weight_n_m3": 2472, "n0": 1});
    let soil = |own: Value| json!({"soil": {"unit_weight_n_m3": own, "pressure_sinkage": null}});
    let ask = |own: Value| {
        let body = with(&lunar(soil(own)), json!({"soil": {"pressure_sinkage": reece.clone()}}));
        post(PATH, &body).ok()
    };
    assert_eq!(ask(Value::Null), ask(json!(2472)));
    assert_ne!(ask(Value::Null), ask(json!(9000)));
}

#[test]
fn a_wheel_that_would_sink_beyond_its_axle_is_refused_at_its_load() {
    let refused = post(PATH, &lunar(json!({"normal_load_n": 1e6})));
    assert_eq!(refused.pointers(), ["/normal_load_n"]);
    let deep = post(PATH, &lunar(json!({"normal_load_n": 1.3e4}))).ok();
    assert_eq!(codes(&deep), ["sinkage_beyond_estimates"]);
}

#[test]
fn all_that_is_missing_or_wrong_is_named_at_once() {
    assert_eq!(post(PATH, &json!({})).pointers(), ["/wheel", "/soil", "/normal_load_n"]);
    let wrong = json!({"normal_load_n": -1, "slip": 2, "soil": {"cohesion_pa": -1}});
    assert_eq!(post(PATH, &lunar(wrong)).pointers(), ["/soil/cohesion_pa", "/normal_load_n", "/slip"]);
    assert_eq!(post(PATH, &letter()).pointers(), ["/sinkage_m", "/normal_load_n"]);
}

#[test]
fn a_table_is_one_row_with_empty_cells() {
    let body = lunar(json!({"slip": null}));
    let (reply, answer) = (post(PATH, &body).ok(), post_for_csv(PATH, &body));
    assert_eq!(answer.header("x-warnings"), "needs_driving_slip");
    for (name, column) in table(&answer.text) {
        assert_eq!(column, [reply[name.as_str()].as_f64()], "{name}");
    }
}
