//! The method `resistive_force` in every operation.

use serde_json::{Value, json};

use crate::asking::{get, letter, post, post_for_csv, table, with};

/// Thirty random cases at thirty digits, by an implementation independent of this one: see the fixture's README.
const REFERENCE_CASES: &str = include_str!("../../crates/terramechanics/tests/reference/resistive_force_cases.json");

/// What an integral promises, on the scale of the parts.
const INTEGRAL: f64 = 1e-10;
/// A solved sinkage: the integral's error and what is left of the balance.
pub(crate) const SOLVED: f64 = 1e-9;
/// Some roundings of a product.
pub(crate) const ROUNDING: f64 = 1e-14;
/// Values by hand, or by a peer, have ten digits.
const TEN_DIGITS: f64 = 1e-9;

pub(crate) fn number(value: &Value, name: &str) -> f64 {
    value[name].as_f64().unwrap_or_else(|| panic!("{name} in {value}"))
}

pub(crate) fn grains(changes: Value) -> Value {
    let body = json!({
        "wheel": {"radius_m": 0.2, "width_m": 0.1}, "soil": {"friction_angle_rad": 0.6, "granular_stiffness_n_m3": 2e6},
        "slip": 0.2, "sinkage_m": 0.02, "method": "resistive_force"
    });
    with(&body, changes)
}

pub(crate) fn forces(changes: Value) -> Value {
    post("/v1/forces", &grains(changes)).ok()
}

/// Largest size of the forces along x and along z.
fn scales(reply: &Value) -> [f64; 2] {
    let part = |name: &str| number(&reply["components"], name).abs();
    [part("traction_n") + part("resistance_n"), part("normal_support_n") + part("shear_support_n")]
}

#[test]
fn thirty_reference_cases_come_back_over_http() {
    let cases: Vec<Value> = serde_json::from_str(REFERENCE_CASES).expect("a fixture is JSON");
    assert_eq!(cases.len(), 30);
    let mut solved = 0;
    for (i, case) in cases.iter().enumerate() {
        let expected = &case["expected"];
        let body = with(&case["input"], json!({"method": "resistive_force"}));
        let reply = post("/v1/forces", &body).ok();
        let [x_scale, z_scale] = scales(&reply);
        let radius = number(&case["input"]["wheel"], "radius_m");
        for (name, scale) in
            [("longitudinal_force_n", x_scale), ("normal_force_n", z_scale), ("torque_n_m", radius * (x_scale + z_scale))]
        {
            let off = (number(&reply, name) - number(expected, name)).abs() / scale;
            assert!(off <= INTEGRAL, "case {i}, {name}: off by {off:e}");
        }
        let off = number(&reply, "granular_stiffness_n_m3") / number(expected, "granular_stiffness_n_m3") - 1.0;
        assert!(off.abs() <= ROUNDING, "case {i}: stiffness off by {off:e}");
        if let Some(load) = expected.get("sinkage_for_load") {
            let by_load = json!({"sinkage_m": null, "normal_load_n": load["normal_load_n"]});
            let reply = post("/v1/forces", &with(&body, by_load)).ok();
            let off = number(&reply, "sinkage_m") / number(load, "sinkage_m") - 1.0;
            assert!(off.abs() <= SOLVED, "case {i}: sinkage off by {off:e}");
            solved += 1;
        }
    }
    assert_eq!(solved, 3);
}

/// F_x, F_z and T of the formulas, integrated at high precision by hand, at ξ = 2 MN/m³.
#[test]
fn driving_and_braking_are_as_computed_by_hand() {
    for (slip, expected) in
        [(0.2, [10.672_807_42, 162.322_901, 8.214_884_483]), (-0.5, [-43.173_081_63, 120.788_373_6, -4.038_428_745])]
    {
        let reply = forces(json!({"slip": slip}));
        for (name, expected) in ["longitudinal_force_n", "normal_force_n", "torque_n_m"].into_iter().zip(expected) {
            let off = number(&reply, name) / expected - 1.0;
            assert!(off.abs() < TEN_DIGITS, "{slip}, {name}: off by {off:e}");
        }
        let parts = |name: &str| number(&reply["components"], name);
        let [x_scale, z_scale] = scales(&reply);
        let x = parts("traction_n") - parts("resistance_n") - number(&reply, "longitudinal_force_n");
        let z = parts("normal_support_n") + parts("shear_support_n") - number(&reply, "normal_force_n");
        assert!(x.abs() <= ROUNDING * x_scale && z.abs() <= ROUNDING * z_scale);
        assert_eq!(reply["angles"]["exit_rad"], 0.0);
        assert!(reply["sinkage_modulus"].is_null() && reply["sinkage_exponent"].is_null());
    }
    assert!(post("/v1/forces", &letter()).ok()["granular_stiffness_n_m3"].is_null());
}

#[test]
fn forces_scale_with_the_stiffness_and_a_load_with_it_leaves_the_sinkage() {
    let (one, three) = (forces(json!({})), forces(json!({"soil": {"granular_stiffness_n_m3": 6e6}})));
    for name in ["longitudinal_force_n", "normal_force_n", "torque_n_m"] {
        assert!((number(&three, name) / number(&one, name) / 3.0 - 1.0).abs() < ROUNDING, "{name}");
    }
    assert_eq!(one["drawbar_coefficient"].as_f64().map(|share| share > 0.0), Some(true));
    let deep = |stiffness: f64, load: f64| {
        let soil = json!({"granular_stiffness_n_m3": stiffness});
        number(&forces(json!({"soil": soil, "sinkage_m": null, "normal_load_n": load})), "sinkage_m")
    };
    assert!((deep(2e6, 100.0) / deep(6e6, 300.0) - 1.0).abs() < SOLVED);
}

#[test]
fn what_the_method_lacks_is_named() {
    let fault = |soil: Value, pointer: &str| {
        post("/v1/forces", &with(&grains(json!({"soil": null})), json!({"soil": soil}))).fault(pointer)
    };
    assert_eq!(
        fault(json!({"friction_angle_rad": 0.6}), "/soil/bulk_density_kg_m3"),
        "is required; or give `granular_stiffness_n_m3`"
    );
    assert_eq!(fault(json!({"bulk_density_kg_m3": 1600}), "/soil/friction_angle_rad"), "is required");
    let smooth = fault(json!({"bulk_density_kg_m3": 1600, "friction_angle_rad": 0}), "/soil/friction_angle_rad");
    assert!(smooth.starts_with("must be greater than 0"), "{smooth}");
    let preset = fault(json!({"preset": "letter-sand"}), "/soil/bulk_density_kg_m3");
    assert!(preset.contains("no published value for `letter-sand`"), "{preset}");
    for (name, value) in [("bulk_density_kg_m3", 0.0), ("gravity_m_s2", -9.8), ("granular_stiffness_n_m3", 0.0)] {
        let detail = post("/v1/forces", &grains(json!({"soil": {name: value}}))).fault(&format!("/soil/{name}"));
        assert!(detail.contains("must be"), "{detail}");
    }
}

#[test]
fn what_the_method_does_not_take_is_refused_where_it_stands() {
    for (changes, pointer) in
        [(json!({"slip_angle_rad": 0.1}), "/slip_angle_rad"), (json!({"slip": -0.2, "braking": "two_zone"}), "/braking")]
    {
        assert_eq!(post("/v1/forces", &grains(changes)).pointers(), [pointer]);
    }
    let all = json!({"slip": -0.2, "slip_angle_rad": 0.1, "braking": "two_zone", "lambda_a": 0.5, "lambda_b": 0});
    assert_eq!(post("/v1/forces", &grains(all)).pointers(), ["/slip_angle_rad", "/braking"]);
    let load = json!({"slip": null, "sinkage_m": null, "normal_load_n": 100, "braking": "two_zone"});
    assert_eq!(post("/v1/towed", &grains(load)).pointers(), ["/braking"]);
    assert_eq!(post("/v1/stress-profile", &grains(json!({"braking": "two_zone"}))).pointers(), ["/braking"]);
    let fit = json!({
        "wheel": {"radius_m": 0.2, "width_m": 0.1}, "soil": {"preset": "letter-sand", "bulk_density_kg_m3": 1600},
        "method": "resistive_force", "fit": ["cohesion_pa"], "data": {"slip": [0.1, 0.2], "sinkage_m": [0.01, 0.01], "torque_n_m": [1, 2]}
    });
    assert_eq!(post("/v1/identify", &fit).pointers(), ["/fit/0"]);
}

#[test]
fn braking_cohesion_and_lugs_are_warned_of() {
    let bare = grains(json!({"soil": {"friction_angle_rad": null}}));
    let warned = |changes: Value| post("/v1/forces", &with(&bare, changes)).warned_of();
    assert!(warned(json!({})).is_empty());
    for (changes, code) in [
        (json!({"slip": -0.1}), "driving_only"),
        (json!({"wheel": {"lug_height_m": 0.01}}), "rough_cylinder"),
        (json!({"soil": {"gravity_m_s2": 1.62}}), "low_gravity"),
    ] {
        assert_eq!(warned(changes), [code]);
    }
    // What is beside a stiffness that is given is not used either.
    for (changes, code) in [
        (json!({"soil": {"cohesion_pa": 1000}}), "cohesion_left_out"),
        (json!({"soil": {"bulk_density_kg_m3": 1.6}}), "outside_catalogue"),
    ] {
        assert_eq!(warned(changes), [code, "not_used"]);
    }
}

/// Simpson's rule over the columns: F_x = b r ∫(τ cos θ − σ sin θ) dθ, F_z = b r ∫(σ cos θ + τ sin θ) dθ.
#[test]
fn a_profile_adds_up_to_the_forces() {
    let reply = post("/v1/stress-profile", &grains(json!({"slip": 0.3, "points": 2001}))).ok();
    let total = forces(json!({"slip": 0.3}));
    let column = |name: &str| -> Vec<f64> {
        reply["columns"][name].as_array().expect("a column").iter().map(|value| value.as_f64().expect("a number")).collect()
    };
    let (theta, normal, shear) = (column("theta_rad"), column("normal_stress_pa"), column("shear_stress_pa"));
    let places: Vec<(f64, f64, f64)> =
        theta.iter().zip(&normal).zip(&shear).map(|((theta, normal), shear)| (*theta, *normal, *shear)).collect();
    let integral = |of: &dyn Fn((f64, f64, f64)) -> f64| -> f64 {
        places.windows(2).map(|pair| 0.5 * (pair[1].0 - pair[0].0) * (of(pair[0]) + of(pair[1]))).sum()
    };
    let area = 0.2 * 0.1;
    let x = area * integral(&|(theta, normal, shear)| shear * theta.cos() - normal * theta.sin());
    let z = area * integral(&|(theta, normal, shear)| normal * theta.cos() + shear * theta.sin());
    // The trapezoidal rule over 2001 places; the stresses bend within a layer of a few tenths of the contact.
    assert!((x - number(&total, "longitudinal_force_n")).abs() < 1e-5 * number(&total, "normal_force_n"));
    assert!((z / number(&total, "normal_force_n") - 1.0).abs() < 1e-5);
    assert_eq!(number(&reply, "granular_stiffness_n_m3"), 2e6);
    assert_eq!(reply["angles"], total["angles"]);
    let largest = normal.iter().copied().fold(0.0, f64::max);
    assert!((number(&reply["peak"], "normal_stress_pa") / largest - 1.0).abs() < ROUNDING);
    for name in ["normal_stress_linear_pa", "shear_stress_linear_pa"] {
        let column = reply["columns"][name].as_array().expect("a column");
        assert!(column.len() == theta.len() && column.iter().all(Value::is_null));
    }
    assert_eq!(reply["warnings"][0]["code"], "no_linear_stresses");
    let plain = post("/v1/stress-profile", &letter()).ok();
    assert!(plain.get("granular_stiffness_n_m3").is_none() && plain["columns"]["normal_stress_linear_pa"][0].is_number());
}

#[test]
fn a_sweep_and_a_track_have_the_forces_of_their_points() {
    let load = json!({"sinkage_m": null, "normal_load_n": 100});
    let slips = json!([0, 0.2, 0.5]);
    let sweep = post("/v1/slip-sweep", &with(&grains(load.clone()), json!({"slip": slips}))).ok();
    assert_eq!(sweep["method"], "resistive_force");
    let columns = json!({"time_s": [0, 1, 2], "slip": slips});
    let track = post("/v1/track", &with(&grains(load.clone()), json!({"slip": null, "columns": columns}))).ok();
    assert_eq!(track["columns"]["status"], json!(["ok", "ok", "ok"]));
    for (row, slip) in [0.0, 0.2, 0.5].into_iter().enumerate() {
        let point = forces(with(&load, json!({"slip": slip})));
        for name in ["sinkage_m", "longitudinal_force_n", "normal_force_n", "torque_n_m"] {
            assert_eq!(sweep["columns"][name][row], point[name], "{name}");
            assert_eq!(track["columns"][name][row], point[name], "{name}");
        }
    }
}

#[test]
fn a_comparison_takes_all_four_methods_and_its_default_is_the_letters() {
    let names = |body: &Value| -> Vec<Value> {
        let reply = post("/v1/compare", body).ok();
        reply["series"].as_array().expect("series").iter().map(|series| series["method"].clone()).collect()
    };
    let slips = json!({"slip": [0, 0.2]});
    assert_eq!(names(&with(&letter(), slips.clone())), ["quadrature", "linearised", "explicit"]);
    let dense = with(&with(&letter(), slips.clone()), json!({"soil": {"bulk_density_kg_m3": 1600}}));
    let all = json!({"methods": ["resistive_force", "quadrature", "linearised", "explicit"]});
    assert_eq!(names(&with(&dense, all.clone())).len(), 4);
    assert_eq!(post("/v1/compare", &with(&with(&letter(), slips), all)).pointers(), ["/soil/bulk_density_kg_m3"]);
    // Alone it asks for no law, and there is no quadrature to compare it with.
    let alone = grains(json!({"method": null, "methods": ["resistive_force"], "slip": [0.1, 0.2]}));
    let reply = post("/v1/compare", &alone).ok();
    assert_eq!(reply["series"][0]["gap_to_quadrature"], json!({}));
    assert_eq!(reply["series"][0]["columns"]["longitudinal_force_n"][1], forces(json!({}))["longitudinal_force_n"]);
}

#[test]
fn a_towed_wheel_takes_no_torque_in_grains() {
    let body = grains(json!({"slip": null, "sinkage_m": null, "normal_load_n": 100}));
    let reply = post("/v1/towed", &body).ok();
    let (slip, sinkage) = (number(&reply, "slip"), number(&reply, "sinkage_m"));
    let point = forces(json!({"slip": slip, "sinkage_m": sinkage}));
    assert!(slip < 0.0 && number(&reply, "towing_resistance_n") > 0.0);
    assert!((number(&point, "normal_force_n") / 100.0 - 1.0).abs() < SOLVED);
    assert!(number(&point, "torque_n_m").abs() < SOLVED * 100.0 * 0.2);
    let pull = number(&point, "longitudinal_force_n"); // a balance is corrected for its last step, so it differs by rounding
    assert!((number(&reply, "towing_resistance_n") + pull).abs() < SOLVED * 100.0);
    assert_eq!(number(&reply, "granular_stiffness_n_m3"), 2e6);
    let codes: Vec<&Value> = reply["warnings"].as_array().expect("warnings").iter().map(|warning| &warning["code"]).collect();
    assert_eq!(codes, ["driving_only", "not_used"]); // the friction angle, beside a stiffness that is given
}

#[test]
fn a_query_and_a_table_have_the_same_numbers() {
    let path = "/v1/forces?wheel.radius_m=0.2&wheel.width_m=0.1&soil.granular_stiffness_n_m3=2e6&soil.friction_angle_rad=0.6\
                &slip=0.2&sinkage_m=0.02&method=resistive_force";
    assert_eq!(get(path).ok(), forces(json!({})));
    let columns = table(&post_for_csv("/v1/forces", &grains(json!({}))).text);
    let (_, pull) = columns.iter().find(|(name, _)| *name == "longitudinal_force_n").expect("a pull");
    assert_eq!(pull[0], forces(json!({}))["longitudinal_force_n"].as_f64());
}
