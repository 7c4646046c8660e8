//! Results say when they leave the range in which their model was tested.

use serde_json::{Value, json};

use crate::asking::{get, letter, post, with};

/// The letter's case on a wheel that is large enough for Bekker's law: nothing to warn of.
fn tested() -> Value {
    with(&letter(), json!({"wheel": {"radius_m": 0.25}}))
}

fn warned_of(changes: Value) -> Vec<String> {
    post("/v1/forces", &with(&tested(), changes)).warned_of()
}

#[test]
fn a_result_within_all_ranges_carries_no_warning() {
    assert!(warned_of(json!({})).is_empty());
}

#[test]
fn a_small_wheel_is_warned_of_with_bekkers_law_only() {
    assert_eq!(warned_of(json!({"wheel": {"radius_m": 0.2499}})), ["small_wheel"]);
    let direct = json!({"law": "direct", "k_s": 747_530.0, "n0": 0.91});
    let soil = json!({"cohesion_pa": 0, "friction_angle_rad": 0.478, "shear_modulus_m": 0.005, "pressure_sinkage": direct});
    let body = json!({"wheel": {"preset": "letter"}, "soil": soil, "slip": 0.2, "sinkage_m": 0.02});
    assert!(post("/v1/forces", &body).warned_of().is_empty());
}

#[test]
fn a_deep_sinkage_is_warned_of() {
    assert!(warned_of(json!({"sinkage_m": 0.0749})).is_empty());
    assert_eq!(warned_of(json!({"sinkage_m": 0.0751})), ["deep_sinkage"]);
}

#[test]
fn slip_beyond_the_fit_is_warned_of_where_a_slip_gain_is_used() {
    let gain = json!({"pressure_sinkage": {"n1": 0.3}});
    assert!(warned_of(json!({"slip": 0.6, "soil": gain})).is_empty());
    assert_eq!(warned_of(json!({"slip": 0.61, "soil": gain})), ["slip_beyond_fit"]);
    assert!(warned_of(json!({"slip": 0.61})).is_empty());
    let from_static = json!({"slip": 0.7, "sinkage_m": null, "static_sinkage_m": 0.01});
    assert_eq!(warned_of(from_static), ["slip_beyond_fit"]);
}

#[test]
fn gains_applied_to_a_braking_wheel_are_warned_of() {
    let gain = json!({"pressure_sinkage": {"n1": 0.3}});
    assert_eq!(warned_of(json!({"slip": -0.2, "soil": gain})), ["slip_gain_extrapolated"]);
    let with_skid_gain = json!({"pressure_sinkage": {"n1": 0.3, "n2": 0.2}});
    assert!(warned_of(json!({"slip": -0.2, "soil": with_skid_gain})).is_empty());
    let from_static = json!({"slip": -0.2, "sinkage_m": null, "static_sinkage_m": 0.01});
    assert_eq!(warned_of(from_static), ["slip_sinkage_extrapolated"]);
    assert!(warned_of(json!({"slip": 0.2, "soil": gain})).is_empty());
}

#[test]
fn a_negative_cohesive_modulus_near_its_limit_is_warned_of() {
    // b = 0.1 m: the modulus vanishes at k_c = −b k_φ = −75 413 and is half of k_φ at −37 706.5.
    let k_c = |k_c: f64| json!({"soil": {"pressure_sinkage": {"k_c": k_c}}});
    assert!(warned_of(k_c(-37_700.0)).is_empty());
    assert_eq!(warned_of(k_c(-37_710.0)), ["negative_cohesive_modulus"]);
    assert_eq!(post("/v1/forces", &with(&tested(), k_c(-75_413.0))).pointers(), ["/soil/pressure_sinkage"]);
}

#[test]
fn a_soil_of_the_moon_or_mars_is_warned_of_by_its_gravity() {
    for (soil, gravity) in [("lunar-apollo-nominal", 1.62), ("zhurong-sand-marssim", 3.71)] {
        let body = with(&tested(), json!({"soil": null}));
        let reply = post("/v1/forces", &with(&body, json!({"soil": {"preset": soil}}))).ok();
        let warnings = reply["warnings"].as_array().expect("warnings");
        let warning = warnings.iter().find(|warning| warning["code"] == "low_gravity").expect("a warning");
        assert_eq!(warning["range"]["value"], gravity, "{soil}");
    }
}

#[test]
fn a_warning_names_value_range_and_source() {
    let reply = post("/v1/forces", &letter()).ok();
    let warning = &reply["warnings"][0];
    assert_eq!(warning["code"], "small_wheel");
    assert_eq!(warning["range"]["value"], 0.4);
    assert_eq!(warning["range"]["lower"], 0.5);
    assert!(warning["range"]["upper"].is_null());
    assert_eq!(warning["range"]["source"], "Meirion-Griffith & Spenko 2011");
    let detail = warning["detail"].as_str().expect("a detail");
    assert!(detail.starts_with("diameter (m) is 0.4, below 0.5 (Meirion-Griffith & Spenko 2011): Bekker's law"), "{detail}");
}

#[test]
fn every_code_is_listed_with_its_range_and_source() {
    let model = get("/v1/model").ok();
    let listed = model["warnings"].as_array().expect("warnings");
    let of = |code: &str| listed.iter().find(|warning| warning["code"] == code).unwrap_or_else(|| panic!("{code} is not listed"));
    for code in [
        "small_wheel",
        "deep_sinkage",
        "slip_beyond_fit",
        "slip_gain_extrapolated",
        "slip_sinkage_extrapolated",
        "negative_cohesive_modulus",
        "low_gravity",
        "bulldozing_not_mobilised",
    ] {
        let warning = of(code);
        assert!(warning["source"].is_string() && (warning["lower"].is_number() || warning["upper"].is_number()), "{code}");
    }
    for code in [
        "lug_height_assumed",
        "integration_error",
        "load_residual",
        "mirrored",
        "no_solution",
        "points_raised",
        "bulldozing_left_out",
    ] {
        assert!(of(code)["meaning"].is_string());
    }
}

#[test]
fn a_backward_wheel_keeps_the_rovers_axes_and_says_so() {
    let forward = post("/v1/forces", &with(&letter(), velocities(0.16, 1.0))).ok();
    let answer = post("/v1/forces", &with(&letter(), velocities(-0.16, -1.0)));
    assert!(answer.warned_of().contains(&"mirrored".into()));
    let back = answer.ok();
    let number = |reply: &Value, name: &str| reply[name].as_f64().expect("a number");
    for (name, sign) in [("longitudinal_force_n", -1.0), ("torque_n_m", -1.0), ("normal_force_n", 1.0), ("slip", 1.0)] {
        assert_eq!(number(&back, name), sign * number(&forward, name), "{name}");
    }
}

fn velocities(forward: f64, angular: f64) -> Value {
    json!({"slip": null, "forward_velocity_m_s": forward, "angular_velocity_rad_s": angular})
}
