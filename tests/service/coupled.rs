//! `POST /v1/coupled`.

use serde_json::{Value, json};

use crate::asking::{letter, post, post_for_csv, table, with};

/// Some tens of roundings.
const ROUNDING: f64 = 1e-12;

fn number(value: &Value, name: &str) -> f64 {
    value[name].as_f64().unwrap_or_else(|| panic!("{name} in {value}"))
}

fn measured(changes: Value) -> Value {
    with(&with(&letter(), json!({"normal_load_n": 80})), changes)
}

/// The load and the torque of the linearised method lead back to its torque and its pull, with lugs and for both radii.
#[test]
fn the_coupled_forms_are_the_linearised_method_seen_from_its_load() {
    for radius in ["rim", "shearing"] {
        for slip in [-0.4, 0.0, 0.2, 1.0] {
            let body = with(
                &letter(),
                json!({"slip": slip, "wheel": {"lug_height_m": 0.01}, "soil": {"cohesion_pa": 500}, "normal_stress_radius": radius}),
            );
            let linear = post("/v1/forces", &with(&body, json!({"method": "linearised"}))).ok();
            let (pull, torque) = (number(&linear, "longitudinal_force_n"), number(&linear, "torque_n_m"));
            let scale = number(&linear["components"], "traction_n").abs() + number(&linear["components"], "resistance_n").abs();
            let from_load = post("/v1/coupled", &with(&body, json!({"normal_load_n": linear["normal_force_n"]}))).ok();
            assert!((number(&from_load, "torque_n_m") / torque - 1.0).abs() < ROUNDING, "{radius} {slip}");
            assert!((number(&from_load, "longitudinal_force_n") - pull).abs() < ROUNDING * scale, "{radius} {slip}");
            assert_eq!(from_load["angles"], linear["angles"]);
            let known = json!({"normal_load_n": linear["normal_force_n"], "torque_n_m": torque});
            let from_both = post("/v1/coupled", &with(&body, known)).ok();
            assert_eq!(number(&from_both, "torque_n_m"), torque);
            assert!((number(&from_both, "longitudinal_force_n") - pull).abs() < ROUNDING * scale, "{radius} {slip}");
        }
    }
}

#[test]
fn the_pressure_sinkage_law_has_no_influence() {
    let softer = json!({"soil": {"pressure_sinkage": {"k_phi": 300_000, "n0": 1.3, "n1": 0.2}}});
    assert_eq!(post("/v1/coupled", &measured(softer)).ok(), post("/v1/coupled", &measured(json!({}))).ok());
}

#[test]
fn a_result_beyond_the_tests_of_its_forms_says_so() {
    assert_eq!(post("/v1/coupled", &measured(json!({}))).warned_of(), Vec::<String>::new());
    let deep = json!({"slip": 0.95, "sinkage_m": 0.19});
    assert_eq!(post("/v1/coupled", &measured(deep)).warned_of(), ["deep_sinkage", "slip_beyond_fit"]);
    assert_eq!(post("/v1/coupled", &measured(json!({"slip": -0.2}))).warned_of(), ["slip_beyond_fit"]);
}

#[test]
fn velocities_give_the_slip_and_a_wheel_that_turns_backwards_is_the_mirror_image() {
    let moving = |sign: f64, torque: Value| {
        let motion =
            json!({"slip": null, "forward_velocity_m_s": 0.16 * sign, "angular_velocity_rad_s": sign, "torque_n_m": torque});
        post("/v1/coupled", &measured(motion)).ok()
    };
    for torque in [Value::Null, json!(4.0)] {
        let ahead = moving(1.0, torque.clone());
        let back = moving(-1.0, torque.as_f64().map_or(Value::Null, |torque| json!(-torque)));
        assert!((number(&ahead, "slip") - 0.2).abs() < ROUNDING);
        assert_eq!(ahead["slip"], back["slip"]);
        for name in ["longitudinal_force_n", "torque_n_m"] {
            assert_eq!(number(&back, name), -number(&ahead, name), "{name}");
        }
    }
}

#[test]
fn a_torque_that_the_load_cannot_go_with_is_warned_of() {
    let reply = post("/v1/coupled", &measured(json!({"torque_n_m": 200}))).ok();
    assert_eq!(reply["warnings"][0]["code"], "negative_normal_stress");
    assert_eq!(post("/v1/coupled", &measured(json!({}))).ok()["warnings"], json!([]));
}

/// The law cancels, so that it may be left out; what does not cancel may not.
#[test]
fn no_pressure_sinkage_law_is_needed() {
    let without = post("/v1/coupled", &measured(json!({"soil": {"pressure_sinkage": null}})));
    assert_eq!(without.ok(), post("/v1/coupled", &measured(json!({}))).ok());
    let nothing = post("/v1/coupled", &measured(json!({"soil": {"pressure_sinkage": null, "cohesion_pa": null}})));
    assert_eq!(nothing.pointers(), ["/soil/cohesion_pa"]);
    let forces = with(&letter(), json!({"soil": {"pressure_sinkage": null}}));
    assert_eq!(post("/v1/forces", &forces).pointers(), ["/soil/pressure_sinkage"]);
}

#[test]
fn a_braking_wheel_that_carries_nothing_is_refused_at_its_slip() {
    let change = json!({"slip": -1, "sinkage_m": 0.2, "soil": {"friction_angle_rad": 1.2}});
    assert_eq!(post("/v1/coupled", &measured(change)).pointers(), ["/slip"]);
}

#[test]
fn all_that_is_missing_or_wrong_is_named_at_once() {
    let empty = post("/v1/coupled", &json!({})).pointers();
    assert_eq!(empty, ["/wheel", "/soil", "/slip", "/sinkage_m", "/normal_load_n"]);
    let wrong = json!({"sinkage_m": 0.3, "normal_load_n": 0, "torque_n_m": "much", "normal_stress_radius": "rimm"});
    let faults = post("/v1/coupled", &measured(wrong)).pointers();
    assert_eq!(faults, ["/sinkage_m", "/normal_load_n", "/torque_n_m", "/normal_stress_radius"]);
    assert_eq!(post("/v1/coupled", &measured(json!({"method": "linearised"}))).pointers(), ["/method"]);
}

#[test]
fn a_table_is_one_row() {
    let (reply, text) = (post("/v1/coupled", &measured(json!({}))).ok(), post_for_csv("/v1/coupled", &measured(json!({}))).text);
    let columns = table(&text);
    assert_eq!(columns.len(), 4);
    for (name, column) in columns {
        assert_eq!(column, [reply[name.as_str()].as_f64()], "{name}");
    }
}

/// With a torque the pull follows without a soil, whether none is sent or null.
#[test]
fn a_null_soil_is_none() {
    let body = json!({
        "wheel": {"radius_m": 0.2, "width_m": 0.1}, "slip": 0.2, "sinkage_m": 0.02, "normal_load_n": 80, "torque_n_m": 6
    });
    let mut with_null = body.clone();
    with_null["soil"] = Value::Null;
    assert_eq!(post("/v1/coupled", &with_null).ok(), post("/v1/coupled", &body).ok());
    let mut without_torque = with_null;
    without_torque["torque_n_m"] = Value::Null;
    assert_eq!(post("/v1/coupled", &without_torque).pointers(), ["/soil"]);
}

/// The pull from torque is of the contact alone. A slip that is sent all the same changes no number, and tells a torque against it.
#[test]
fn a_torque_needs_no_slip_save_where_the_peak_moves_with_it() {
    let body = json!({"wheel": {"radius_m": 0.2, "width_m": 0.1}, "sinkage_m": 0.02, "normal_load_n": 80, "torque_n_m": 6});
    let alone = post("/v1/coupled", &body).ok();
    assert_eq!((&alone["slip"], &alone["warnings"]), (&Value::Null, &json!([])));
    for (slip, codes) in [(0.2, vec![]), (-0.5, vec!["torque_against_slip", "slip_beyond_fit"])] {
        let answer = post("/v1/coupled", &with(&body, json!({"slip": slip})));
        assert_eq!(answer.warned_of(), codes, "{slip}");
        let found = answer.ok();
        assert_eq!(found["slip"], slip);
        assert_eq!(found["longitudinal_force_n"], alone["longitudinal_force_n"]);
    }
    let contact = |c2: f64| with(&body, json!({"contact": {"rule": "wong_reece", "c1": 0.4, "c2": c2}}));
    assert_eq!(post("/v1/coupled", &contact(0.2)).pointers(), ["/slip"]);
    assert_eq!(post("/v1/coupled", &contact(0.0)).ok()["slip"], Value::Null);
    let half = with(&body, json!({"forward_velocity_m_s": 0.1}));
    assert_eq!(post("/v1/coupled", &half).pointers(), ["/angular_velocity_rad_s"]);
    let text = post_for_csv("/v1/coupled", &body).text;
    assert!(table(&text).into_iter().any(|(name, column)| name == "slip" && column == [None]), "{text}");
    assert_eq!(post("/v1/coupled", &with(&body, json!({"torque_n_m": null, "soil": letter()["soil"]}))).pointers(), ["/slip"]);
}

/// A wheel that moves backwards is the mirror image: its torque goes with its slip where the mirrored one does.
#[test]
fn a_torque_against_the_slip_is_told_of_the_mirrored_wheel_too() {
    let body = json!({
        "wheel": {"radius_m": 0.2, "width_m": 0.1}, "sinkage_m": 0.02, "normal_load_n": 80,
        "forward_velocity_m_s": -0.16, "angular_velocity_rad_s": -1.0
    });
    for (torque, codes) in [(-6.0, vec!["mirrored"]), (6.0, vec!["torque_against_slip", "mirrored"])] {
        let mut found = post("/v1/coupled", &with(&body, json!({"torque_n_m": torque}))).warned_of();
        found.sort();
        let mut codes: Vec<String> = codes.into_iter().map(str::to_owned).collect();
        codes.sort();
        assert_eq!(found, codes, "{torque}");
    }
}

/// Of a measured torque the pull follows without a soil.
#[test]
fn a_soil_that_has_no_influence_is_told() {
    let told = |changes: Value| {
        let found = post("/v1/coupled", &measured(changes)).ok();
        let warnings = found["warnings"].as_array().expect("warnings").clone();
        let names = warnings.iter().find(|warning| warning["code"] == "not_used").map(|warning| warning["names"].clone());
        names.unwrap_or_else(|| json!([]))
    };
    let soil = |torque: Value| told(json!({"torque_n_m": torque, "soil": {"cohesion_pa": 300, "granular_stiffness_n_m3": 1e6}}));
    let all = ["cohesion_pa", "friction_angle_rad", "shear_modulus_m", "pressure_sinkage", "granular_stiffness_n_m3"];
    assert_eq!(soil(json!(7)), json!(all.map(|name| format!("/soil/{name}"))));
    assert_eq!(soil(Value::Null), json!(["/soil/granular_stiffness_n_m3"]));
    assert_eq!(told(json!({"torque_n_m": 7, "soil": null})), json!([]));
}
