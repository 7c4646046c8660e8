//! `POST /v1/towed`.

use serde_json::{Value, json};

use crate::asking::{letter, post, post_for_csv, table, with};
use crate::braking::REFERENCE;

/// A solved skid, sinkage and resistance.
const SOLVED: f64 = 1e-9;

fn towed(changes: Value) -> Value {
    with(&with(&letter(), json!({"slip": null, "sinkage_m": null, "normal_load_n": 80})), changes)
}

fn number(value: &Value) -> f64 {
    value.as_f64().expect("a number")
}

#[test]
fn reference_cases_come_back_over_http() {
    let cases: Vec<Value> = serde_json::from_str(REFERENCE).expect("a fixture is JSON");
    let mut compared = 0;
    for case in cases.iter().filter(|case| case["towed"].is_object()) {
        let expected = &case["towed"];
        let body = with(
            &case["input"],
            json!({"normal_stress_radius": null, "normal_load_n": expected["normal_load_n"], "shear_displacement_radius": "rim"}),
        );
        let reply = post("/v1/towed", &body).ok();
        for name in ["slip", "sinkage_m", "towing_resistance_n"] {
            let off = (number(&reply[name]) / number(&expected[name]) - 1.0).abs();
            assert!(off <= SOLVED, "{}: {name} off by {off:e}", case["name"]);
        }
        compared += 1;
    }
    assert!(compared >= 5, "only {compared} cases");
}

#[test]
fn the_forces_at_the_answer_carry_the_load_without_a_torque() {
    for braking in ["one_zone", "two_zone"] {
        let reply = post("/v1/towed", &towed(json!({"braking": braking}))).ok();
        let point = json!({"slip": reply["slip"], "sinkage_m": reply["sinkage_m"], "braking": braking});
        let forces = post("/v1/forces", &with(&letter(), point)).ok();
        assert!((number(&forces["normal_force_n"]) / 80.0 - 1.0).abs() < SOLVED);
        assert!(number(&forces["torque_n_m"]).abs() < SOLVED * 80.0 * 0.2);
        let pull = number(&forces["longitudinal_force_n"]);
        assert!((pull + number(&reply["towing_resistance_n"])).abs() < SOLVED * 80.0);
        assert_eq!(forces["angles"], reply["angles"]);
        assert!(number(&reply["slip"]) < 0.0 && number(&reply["towing_resistance_n"]) > 0.0);
    }
}

#[test]
fn two_zones_are_the_default() {
    let plain = post("/v1/towed", &towed(json!({}))).ok();
    assert_eq!(plain, post("/v1/towed", &towed(json!({"braking": "two_zone"}))).ok());
    assert_ne!(plain, post("/v1/towed", &towed(json!({"braking": "one_zone"}))).ok());
}

#[test]
fn a_table_has_the_same_numbers() {
    let reply = post("/v1/towed", &towed(json!({}))).ok();
    let columns = table(&post_for_csv("/v1/towed", &towed(json!({}))).text);
    let names: Vec<&str> = columns.iter().map(|(name, _)| name.as_str()).collect();
    assert_eq!(names, ["slip", "sinkage_m", "towing_resistance_n", "entry_rad", "maximum_stress_rad", "exit_rad"]);
    for (name, values) in &columns {
        let value = if name.ends_with("_rad") { &reply["angles"][name] } else { &reply[name] };
        assert_eq!(values, &[value.as_f64()], "{name}");
    }
}

#[test]
fn warnings_name_what_was_extrapolated_or_set_aside() {
    let changes = json!({"soil": {"pressure_sinkage": {"n1": 0.2}}, "contact": {"rule": "half_sinkage"}});
    assert_eq!(post("/v1/towed", &towed(json!({}))).warned_of(), ["small_wheel"]);
    let codes = post("/v1/towed", &towed(changes)).warned_of();
    assert_eq!(codes, ["small_wheel", "slip_gain_extrapolated", "peak_rule_set_aside"]);
}

#[test]
fn faults_are_named_all_at_once() {
    let body = json!({"wheel": {"radius_m": -1, "width_m": 0.1}, "braking": "no_zone", "slip": 0.1});
    assert_eq!(post("/v1/towed", &body).pointers(), ["/slip", "/wheel/radius_m", "/soil", "/normal_load_n", "/braking"]);
    assert_eq!(
        post("/v1/towed", &towed(json!({"normal_load_n": "80"}))).fault("/normal_load_n"),
        "must be a number, not a string"
    );
    assert_eq!(post("/v1/towed", &towed(json!({"normal_load_n": 1e6}))).pointers(), ["/normal_load_n"]);
    // No friction and no cohesion: nothing turns the wheel at any skid.
    let slick = post("/v1/towed", &towed(json!({"soil": {"friction_angle_rad": 0}}))).fault("/normal_load_n");
    assert!(slick.starts_with("no skid was found"), "{slick}");
}
