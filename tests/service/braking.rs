//! The field `braking` of the requests for forces.

use serde_json::{Value, json};

use crate::asking::{letter, post, with};

/// Braking wheels with two zones, and towed wheels, at sixty digits: see the fixture's script.
pub(crate) const REFERENCE: &str = include_str!("../../crates/terramechanics/tests/reference/two_zones.json");
/// What the quadrature promises, on the scale of the normal force.
const QUADRATURE: f64 = 1e-10;

fn two_zones(changes: Value) -> Value {
    with(&with(&letter(), json!({"slip": -0.1, "braking": "two_zone"})), changes)
}

#[test]
fn reference_cases_come_back_over_http() {
    let cases: Vec<Value> = serde_json::from_str(REFERENCE).expect("a fixture is JSON");
    let mut compared = 0;
    // The thinnest contact of all is a difference of angles that has lost five digits before it comes here.
    let forces =
        |case: &&Value| case["expected"].is_object() && !case["name"].as_str().expect("a name").starts_with("front zone");
    for case in cases.iter().filter(forces) {
        let reply =
            post("/v1/forces", &with(&case["input"], json!({"braking": "two_zone", "shear_displacement_radius": "rim"}))).ok();
        let expected = &case["expected"]["quadrature"];
        let number = |value: &Value| value.as_f64().expect("a number");
        let scale = number(&expected["normal_support_n"]) + number(&expected["resistance_n"]).abs();
        for name in ["longitudinal_force_n", "normal_force_n"] {
            let off = (number(&reply[name]) - number(&expected[name])).abs() / scale;
            assert!(off <= QUADRATURE, "{}: {name} off by {off:e}", case["name"]);
        }
        compared += 1;
    }
    assert!(compared >= 19, "only {compared} cases");
}

#[test]
fn one_zone_is_the_default_and_a_driving_wheel_has_no_other() {
    for slip in [-1.0, -0.3, 0.0, 0.2] {
        let plain = post("/v1/forces", &with(&letter(), json!({"slip": slip}))).ok();
        let one = post("/v1/forces", &with(&letter(), json!({"slip": slip, "braking": "one_zone"}))).ok();
        assert_eq!(plain, one);
        if slip >= 0.0 {
            assert_eq!(post("/v1/forces", &two_zones(json!({"slip": slip}))).ok(), plain);
        }
    }
    let braking = post("/v1/forces", &two_zones(json!({}))).ok();
    assert_ne!(braking, post("/v1/forces", &with(&letter(), json!({"slip": -0.1}))).ok());
}

#[test]
fn a_closed_form_with_two_zones_is_a_fault_of_braking() {
    for method in ["linearised", "explicit"] {
        for (path, slip) in [("/v1/forces", json!(0.1)), ("/v1/slip-sweep", json!([-0.1, 0.1]))] {
            let body = two_zones(json!({"method": method, "slip": slip}));
            assert_eq!(post(path, &body).pointers(), ["/braking"], "{path}");
        }
        let body = two_zones(json!({"methods": ["quadrature", method], "slip": [-0.1, 0.1]}));
        assert_eq!(post("/v1/compare", &body).pointers(), ["/braking"]);
    }
    // All methods are the default of a comparison: one fault, not one for each.
    assert_eq!(post("/v1/compare", &two_zones(json!({"slip": [-0.1, 0.1]}))).pointers(), ["/braking"]);
    assert_eq!(post("/v1/forces", &two_zones(json!({"braking": "three_zone", "slip": 3}))).pointers(), ["/braking", "/slip"]);
    assert_eq!(post("/v1/forces", &two_zones(json!({"braking": 2}))).pointers(), ["/braking"]);
}

#[test]
fn a_sweep_and_a_comparison_have_the_forces_of_the_points() {
    let slips = [-1.0, -0.3, -0.1, -1e-3, 0.0, 0.2];
    let sweep = post("/v1/slip-sweep", &two_zones(json!({"slip": slips, "sinkage_m": 0.19}))).ok();
    let comparison = post("/v1/compare", &two_zones(json!({"slip": slips, "sinkage_m": 0.19, "methods": ["quadrature"]}))).ok();
    assert_eq!(comparison["series"][0]["columns"], sweep["columns"]);
    for (i, slip) in slips.into_iter().enumerate() {
        let point = post("/v1/forces", &two_zones(json!({"slip": slip, "sinkage_m": 0.19}))).ok();
        for name in ["longitudinal_force_n", "normal_force_n", "torque_n_m"] {
            assert_eq!(sweep["columns"][name][i], point[name], "{slip}");
        }
    }
}

#[test]
fn a_skid_beyond_the_sinkage_is_refused_at_braking_and_a_gap_in_a_sweep() {
    let refusal = post("/v1/forces", &two_zones(json!({"slip": -0.9})));
    assert_eq!(refusal.pointers(), ["/braking"]);
    let sweep = post("/v1/slip-sweep", &two_zones(json!({"slip": [-0.9, -0.1]}))).ok();
    assert_eq!(sweep["columns"]["torque_n_m"][0], Value::Null);
    assert_eq!(sweep["warnings"][0]["code"], "no_solution");
    // With a load instead the wheel digs itself in.
    let loaded = post("/v1/forces", &two_zones(json!({"slip": -0.9, "sinkage_m": null, "normal_load_n": 80}))).ok();
    assert!(loaded["sinkage_m"].as_f64().expect("a sinkage") > 0.05);
    assert!((loaded["normal_force_n"].as_f64().expect("a force") / 80.0 - 1.0).abs() < 1e-9);
}

#[test]
fn a_profile_of_two_zones_reverses_at_its_peak_and_has_no_linear_stresses() {
    let answer = post("/v1/stress-profile", &two_zones(json!({"points": 51})));
    assert!(answer.warned_of().contains(&"no_linear_stresses".into()));
    let reply = answer.ok();
    assert_eq!(reply["peak"]["shear_stress_pa"], 0.0);
    let column = |name: &str| reply["columns"][name].as_array().expect("a column").clone();
    for name in ["normal_stress_linear_pa", "shear_stress_linear_pa"] {
        assert!(column(name).len() == 51 && column(name).iter().all(Value::is_null));
    }
    let peak = reply["angles"]["maximum_stress_rad"].as_f64().expect("an angle");
    for (theta, shear) in column("theta_rad").iter().zip(column("shear_stress_pa")) {
        let (theta, shear) = (theta.as_f64().expect("an angle"), shear.as_f64().expect("a stress"));
        assert!(shear == 0.0 || (shear > 0.0) == (theta > peak), "{shear} at {theta}");
    }
    let driving = post("/v1/stress-profile", &two_zones(json!({"slip": 0.1})));
    assert!(!driving.warned_of().contains(&"no_linear_stresses".into()));
    assert!(driving.ok()["columns"]["shear_stress_linear_pa"][9].is_number());
}

#[test]
fn a_rule_for_the_peak_that_is_set_aside_is_warned_of() {
    let warns = |changes: Value| post("/v1/forces", &two_zones(changes)).warned_of().contains(&"peak_rule_set_aside".into());
    assert!(warns(json!({"contact": {"rule": "half_sinkage"}})) && !warns(json!({})));
}

/// The zones push up and pull down with some 6e13 N each, of which 41 N are less than the rounding.
#[test]
fn a_load_beyond_the_digits_of_its_parts_has_no_answer() {
    let body = json!({
        "wheel": {"radius_m": 12.862_471_313_342_724, "width_m": 62.090_996_941_008_02},
        "soil": {
            "cohesion_pa": 0, "friction_angle_rad": 1.503_178_367_540_06, "shear_modulus_m": 2.982_242_231_853_259_6e-6,
            "pressure_sinkage": {"law": "direct", "k_s": 169_820.135_296_161_04, "n0": 7.052_536_539_966_347}
        },
        "contact": {"rule": "midpoint", "c3": -0.423_786_163_305_589_66},
        "braking": "two_zone", "slip": -0.215_851_890_119_908_27, "normal_load_n": 41.216_848_668_175_01
    });
    assert!(post("/v1/forces", &body).fault("/normal_load_n").contains("no sinkage was found"));
    let sweep = post("/v1/slip-sweep", &with(&body, json!({"slip": [-0.215_851_890_119_908_27, -0.1]}))).ok();
    assert!(sweep["columns"]["normal_force_n"][0].is_null() && sweep["columns"]["sinkage_m"][0].is_null(), "{sweep}");
    assert!(sweep["warnings"].to_string().contains("no sinkage was found"), "{sweep}");
}
