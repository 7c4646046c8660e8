//! `POST /v1/forces`.

use serde_json::{Value, json};

use crate::asking::{letter, post, post_for_csv, table, with};

fn number(value: &Value, name: &str) -> f64 {
    value[name].as_f64().unwrap_or_else(|| panic!("{name} in {value}"))
}

/// Sixty random cases at thirty digits, with the displacement on the rim, by an implementation independent of this one: see the fixture's README.
const REFERENCE_CASES: &str = include_str!("../../crates/terramechanics/tests/reference/reference_cases.json");

#[test]
fn sixty_reference_cases_come_back_over_http() {
    let cases: Vec<Value> = serde_json::from_str(REFERENCE_CASES).expect("a fixture is JSON");
    assert_eq!(cases.len(), 60);
    for (i, case) in cases.iter().enumerate() {
        comes_back(case, i, json!({"shear_displacement_radius": "rim"}));
    }
}

/// Asks for a reference case by all methods, with `changes` in its input, and compares what comes back.
pub(crate) fn comes_back(case: &Value, i: usize, changes: Value) {
    for (method, tolerance) in [("quadrature", 1e-10), ("linearised", 1e-12), ("explicit", 1e-12)] {
        let expected = &case["expected"][method];
        let asked = with(&with(&case["input"], changes.clone()), json!({"method": method}));
        let reply = post("/v1/forces", &asked).ok();
        let x_scale = number(expected, "traction_n").abs() + number(expected, "resistance_n").abs();
        let z_scale = number(expected, "normal_support_n").abs() + number(expected, "shear_support_n").abs();
        for (computed, name, scale) in [
            (&reply, "longitudinal_force_n", x_scale),
            (&reply, "normal_force_n", z_scale),
            (&reply, "torque_n_m", number(expected, "torque_n_m").abs()),
            (&reply["components"], "traction_n", x_scale),
            (&reply["components"], "resistance_n", x_scale),
            (&reply["components"], "normal_support_n", z_scale),
            (&reply["components"], "shear_support_n", z_scale),
        ] {
            let off = (number(computed, name) - number(expected, name)).abs() / scale;
            assert!(off <= tolerance, "case {i}, {method}, {name}: off by {off:e}");
        }
        for name in ["entry_rad", "maximum_stress_rad", "exit_rad"] {
            let off = (number(&reply["angles"], name) - number(&case["expected"]["angles"], name)).abs();
            assert!(off <= 1e-12, "case {i}: {name} off by {off:e}");
        }
        if let Some(solution) = case["expected"].get("sinkage_for_load") {
            let load = json!({"sinkage_m": null, "normal_load_n": solution["normal_load_n"]});
            let solved = post("/v1/forces", &with(&asked, load)).ok();
            let off = (number(&solved, "sinkage_m") / number(solution, method) - 1.0).abs();
            assert!(off <= 1e-9, "case {i}, {method}: sinkage off by {off:e}");
        }
    }
}

#[test]
fn the_letters_example_has_its_known_answer() {
    // An independent integration with 401 000 points: 16.906 N, 89.716 N, 7.3396 N·m.
    let reply = post("/v1/forces", &letter()).ok();
    assert!((number(&reply, "longitudinal_force_n") - 16.906).abs() < 5e-4);
    assert!((number(&reply, "normal_force_n") - 89.716).abs() < 5e-4);
    assert!((number(&reply, "torque_n_m") - 7.3396).abs() < 5e-5);
    assert_eq!(reply["method"], "quadrature");
    assert_eq!(number(&reply, "sinkage_modulus"), 747_530.0); // −660/0.1 + 754130
    assert_eq!(number(&reply, "shearing_radius_m"), 0.2);
    let efficiency = number(&reply, "longitudinal_force_n") * 0.2 * 0.8 / number(&reply, "torque_n_m");
    assert!((number(&reply, "tractive_efficiency") / efficiency - 1.0).abs() < 1e-14);
}

#[test]
fn presets_are_the_letters_values_and_fields_beside_them_override() {
    let presets = json!({"wheel": {"preset": "letter"}, "soil": {"preset": "letter-sand"}, "slip": 0.2, "sinkage_m": 0.02});
    assert_eq!(post("/v1/forces", &presets).ok(), post("/v1/forces", &letter()).ok());
    let beside = with(&presets, json!({"wheel": {"lug_height_m": 0.01}, "soil": {"cohesion_pa": 200}}));
    let spelled = with(&letter(), json!({"wheel": {"lug_height_m": 0.01}, "soil": {"cohesion_pa": 200}}));
    assert_eq!(post("/v1/forces", &beside).ok(), post("/v1/forces", &spelled).ok());
    assert_ne!(post("/v1/forces", &beside).ok(), post("/v1/forces", &presets).ok());
}

#[test]
fn a_soils_own_contact_holds_unless_the_request_has_one() {
    let base = with(&letter(), json!({"soil": null}));
    let zhurong = with(&base, json!({"soil": {"preset": "zhurong-sand-marssim"}}));
    let angles = |body: &Value| post("/v1/forces", body).ok()["angles"].clone();
    let spelled = with(&zhurong, json!({"contact": {"rule": "wong_reece", "c1": 0.5, "c2": -0.3, "c3": 0}}));
    assert_eq!(angles(&zhurong), angles(&spelled));
    assert_ne!(angles(&zhurong), angles(&with(&zhurong, json!({"contact": {"rule": "midpoint"}}))));
}

#[test]
fn velocities_give_the_slip_and_a_wheel_that_turns_backwards_is_the_mirror_image() {
    let moving = |forward: f64, angular: f64| {
        let motion = json!({"slip": null, "forward_velocity_m_s": forward, "angular_velocity_rad_s": angular});
        post("/v1/forces", &with(&letter(), motion))
    };
    let (ahead, back) = (moving(0.16, 1.0).ok(), moving(-0.16, -1.0).ok());
    assert!((number(&ahead, "slip") - 0.2).abs() < 1e-15);
    assert_eq!(ahead["slip"], back["slip"]);
    for name in ["longitudinal_force_n", "torque_n_m", "drawbar_coefficient"] {
        assert_eq!(number(&ahead, name), -number(&back, name));
    }
    for name in ["normal_force_n", "tractive_efficiency"] {
        assert_eq!(ahead[name], back[name]);
    }
    for (forward, angular, slip) in [(0.0, 0.0, 0.0), (0.0, 2.0, 1.0), (0.3, 0.0, -1.0), (0.2, 0.5, -0.5)] {
        assert_eq!(number(&moving(forward, angular).ok(), "slip"), slip);
    }
    assert!(moving(0.1, -1.0).fault("/angular_velocity_rad_s").contains("opposite signs"));
}

/// Share of the load to which a solved sinkage and its forces agree: the search ends with a step in which the forces are linear.
const SOLVED: f64 = 1e-12;

#[test]
fn the_sinkage_comes_from_the_slip_or_carries_a_load() {
    let from_static = post("/v1/forces", &with(&letter(), json!({"sinkage_m": null, "static_sinkage_m": 0.01}))).ok();
    assert!((number(&from_static, "sinkage_m") - 0.01 * 1.2 / 0.9).abs() < 1e-17);
    for method in ["quadrature", "linearised", "explicit"] {
        let body = with(&letter(), json!({"sinkage_m": null, "normal_load_n": 80, "method": method}));
        let carried = post("/v1/forces", &body).ok();
        assert!((number(&carried, "normal_force_n") - 80.0).abs() < 1e-9, "{method}");
        let z = &carried["sinkage_m"];
        let again = post("/v1/forces", &with(&letter(), json!({"sinkage_m": z, "method": method}))).ok();
        let (pull, same) = (number(&carried, "longitudinal_force_n"), number(&again, "longitudinal_force_n"));
        assert!((pull - same).abs() <= SOLVED * 80.0, "{method}: {pull} {same}");
    }
}

#[test]
fn options_of_the_methods_are_taken() {
    let forces = |changes: Value| number(&post("/v1/forces", &with(&letter(), changes)).ok(), "normal_force_n");
    let lugs = json!({"lug_height_m": 0.02});
    assert!(forces(json!({"wheel": lugs, "normal_stress_radius": "shearing"})) > forces(json!({"wheel": lugs})));
    let linearised = forces(json!({"method": "linearised", "peak_sinkage": "half"}));
    let explicit = forces(json!({"method": "explicit", "lambda_a": "exact", "lambda_b": "exact"}));
    assert!((linearised / explicit - 1.0).abs() < 1e-13);
    assert!(forces(json!({"method": "explicit", "lambda_a": 0.5})) < forces(json!({"method": "explicit"})));
    assert!(forces(json!({"method": "explicit", "peak_sinkage": "geometric"})) > forces(json!({"method": "explicit"})));
}

#[test]
fn coefficients_are_null_where_they_are_undefined() {
    let braking = post("/v1/forces", &with(&letter(), json!({"slip": -0.3}))).ok();
    assert!(braking["tractive_efficiency"].is_null() && braking["drawbar_coefficient"].is_number());
}

#[test]
fn forces_as_a_table_are_one_row() {
    let answer = post_for_csv("/v1/forces", &letter());
    assert!(answer.header("content-type").starts_with("text/csv"));
    let reply = post("/v1/forces", &letter()).ok();
    let columns = table(&answer.text);
    for name in [
        "slip",
        "sinkage_m",
        "longitudinal_force_n",
        "normal_force_n",
        "torque_n_m",
        "traction_n",
        "resistance_n",
        "normal_support_n",
        "shear_support_n",
        "drawbar_coefficient",
        "tractive_efficiency",
    ] {
        assert!(columns.iter().any(|(column, _)| column == name), "{name}");
    }
    for (name, column) in columns {
        let expected = reply.get(&name).or_else(|| reply["components"].get(&name)).and_then(Value::as_f64);
        assert_eq!(column, [expected], "{name}");
    }
}

#[test]
fn what_the_model_refuses_points_at_its_field() {
    let refused = |changes: Value| post("/v1/forces", &with(&letter(), changes)).pointers();
    let on_load = |load: f64| json!({"sinkage_m": null, "normal_load_n": load});
    assert_eq!(refused(json!({"sinkage_m": 0.21})), ["/sinkage_m"]);
    assert_eq!(refused(json!({"sinkage_m": null, "static_sinkage_m": 0.19})), ["/static_sinkage_m"]);
    assert_eq!(refused(json!({"slip": -1, "sinkage_m": null, "static_sinkage_m": 0.01})), ["/static_sinkage_m"]);
    assert_eq!(refused(json!({"soil": {"pressure_sinkage": {"k_c": -1e6}}})), ["/soil/pressure_sinkage"]);
    assert_eq!(refused(json!({"slip": -1, "soil": {"pressure_sinkage": {"n1": 1.0}}})), ["/soil/pressure_sinkage/n0"]);
    assert_eq!(refused(json!({"contact": {"rule": "wong_reece", "c1": 1, "c2": 1}})), ["/contact"]);
    assert_eq!(refused(on_load(1e6)), ["/normal_load_n"]);
    let fault = post("/v1/forces", &with(&letter(), on_load(1e6))).fault("/normal_load_n");
    let full = post("/v1/forces", &with(&letter(), json!({"sinkage_m": 0.2}))).ok();
    let largest = format!("{:.2}", number(&full, "normal_force_n"));
    assert!(fault.contains(&format!("carries is {largest} N")), "the largest load is named: {fault}");
}

/// A locked wheel under Janosi–Hanamoto's law has E = −1, under Wong's with a residual E = −K_r; with c = 0 the traction is
/// proportional to it.
#[test]
fn shear_laws_are_taken_and_differ_as_they_should() {
    let traction = |shear: Value, slip: f64| {
        let reply = post("/v1/forces", &with(&letter(), json!({"slip": slip, "soil": {"shear": shear}}))).ok();
        number(&reply["components"], "traction_n")
    };
    let plain = json!({"law": "janosi_hanamoto"});
    let residual = json!({"law": "wong_residual", "residual_ratio": 0.4, "peak_displacement_m": 0.005});
    let peak = json!({"law": "wong_peak", "peak_displacement_m": 0.005});
    assert_eq!(traction(plain.clone(), 0.2), number(&post("/v1/forces", &letter()).ok()["components"], "traction_n"));
    assert!((traction(residual.clone(), -1.0) / traction(plain.clone(), -1.0) - 0.4).abs() < 1e-13);
    assert_eq!(traction(peak.clone(), -1.0), 0.0);
    // Far beyond the peak displacement, on the spot, what is left is the residual, and next to nothing.
    assert!(traction(residual, 1.0) < 0.75 * traction(plain.clone(), 1.0));
    assert!(traction(peak, 1.0) < 0.5 * traction(plain, 1.0));
}

#[test]
fn a_law_without_shear_modulus_does_not_ask_for_one() {
    let without = with(&letter(), json!({"soil": {"shear_modulus_m": null}}));
    let peak = json!({"law": "wong_peak", "peak_displacement_m": 0.02});
    post("/v1/forces", &with(&without, json!({"soil": {"shear": peak}}))).ok();
    assert_eq!(post("/v1/forces", &without).pointers(), ["/soil/shear_modulus_m"]);
    let faulty = json!({"shear": {"law": "wong_peek", "peak_displacement_m": -1}});
    let mut pointers = post("/v1/forces", &with(&without, json!({"soil": faulty}))).pointers();
    pointers.sort();
    assert_eq!(pointers, ["/soil/shear/law", "/soil/shear/peak_displacement_m"]);
}

#[test]
fn slip_sinkage_laws_are_taken_beside_a_static_sinkage_only() {
    let base = with(&letter(), json!({"sinkage_m": null, "static_sinkage_m": 0.01}));
    let sinkage = |law: Value| number(&post("/v1/forces", &with(&base, json!({"slip_sinkage": law}))).ok(), "sinkage_m");
    assert!((sinkage(json!({"law": "lyasko"})) - 0.01 * 1.2 / 0.9).abs() < 1e-17);
    assert!((sinkage(json!({"law": "linear", "gain": 1.5})) - 0.013).abs() < 1e-17);
    let linear = json!({"slip_sinkage": {"law": "linear", "gain": 1}});
    assert_eq!(post("/v1/forces", &with(&letter(), linear)).pointers(), ["/slip_sinkage"]);
    assert_eq!(post("/v1/forces", &with(&base, json!({"slip_sinkage": {"law": "linear"}}))).pointers(), ["/slip_sinkage/gain"]);
}

#[test]
fn a_skid_gain_changes_the_exponent_at_negative_slip_only() {
    let exponent = |slip: f64| {
        let gains = json!({"slip": slip, "soil": {"pressure_sinkage": {"n1": 0.1, "n2": 0.7}}});
        let answer = post("/v1/forces", &with(&letter(), gains));
        assert!(!answer.warned_of().iter().any(|code| code.starts_with("slip")));
        number(&answer.ok(), "sinkage_exponent")
    };
    assert!((exponent(0.2) - 0.93).abs() < 1e-15 && (exponent(-0.2) - 1.05).abs() < 1e-15);
}
