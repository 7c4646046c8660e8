//! Fields that a method does not read are told, and no others.

use serde_json::{Value, json};

use crate::asking::{Answer, get, post, with};

/// A lugged wheel on a soil that every method knows.
fn body(changes: Value) -> Value {
    let body = json!({
        "wheel": {"radius_m": 0.2, "width_m": 0.1, "lug_height_m": 0.02},
        "soil": {
            "cohesion_pa": 200, "friction_angle_rad": 0.5, "shear_modulus_m": 0.015, "bulk_density_kg_m3": 1600, "unit_weight_n_m3": 15000,
            "lateral_shear_modulus_m": 0.01, "pressure_sinkage": {"law": "bekker", "k_c": 1000, "k_phi": 800e3, "n0": 1}
        },
        "contact": {"rule": "wong_reece", "c1": 0.4, "c2": 0.2, "c3": -0.1},
        "slip": 0.2, "sinkage_m": 0.02
    });
    with(&body, changes)
}

/// The pointers that `not_used` names.
fn told(answer: &Value) -> Vec<String> {
    let warnings = answer["warnings"].as_array().expect("warnings").iter();
    let names = warnings.filter(|warning| warning["code"] == "not_used").flat_map(|warning| {
        warning["names"].as_array().expect("names").iter().map(|name| name.as_str().expect("a pointer").to_owned())
    });
    names.collect()
}

/// The numbers of the answer, without the angles: the explicit formulas tell an exit that they do not use.
fn numbers(answer: &Answer) -> Value {
    with(&answer.ok(), json!({"warnings": null, "shear_displacement_radius": null, "angles": null}))
}

/// Two values for the field at a pointer, of which the second is no default.
const FIELDS: [(&str, &str, &str); 20] = [
    ("/contact", r#"{"rule": "midpoint"}"#, r#"{"rule": "wong_reece", "c1": 0.6, "c2": 0.1}"#),
    ("/contact/c3", "-0.2", "-0.05"),
    ("/contact/interface", r#"{"friction_angle_rad": 0.3}"#, r#"{"friction_angle_rad": 0.4}"#),
    ("/normal_stress_radius", r#""rim""#, r#""shearing""#),
    ("/shear_displacement_radius", r#""shearing""#, r#""rim""#),
    ("/slip_radius", r#""rim""#, r#""lug_tip""#),
    ("/peak_sinkage", r#""geometric""#, r#""half""#),
    ("/lambda_a", "0.1", "0.2"),
    ("/lambda_b", "0.1", "0.2"),
    ("/shear_coupling", r#""independent""#, r#""coupled""#),
    ("/bulldozing", r#""full""#, r#""mobilised""#),
    ("/soil/cohesion_pa", "100", "300"),
    ("/soil/friction_angle_rad", "0.5", "0.6"),
    ("/soil/shear_modulus_m", "0.01", "0.02"),
    (
        "/soil/shear",
        r#"{"law": "wong_peak", "peak_displacement_m": 0.01}"#,
        r#"{"law": "wong_peak", "peak_displacement_m": 0.02}"#,
    ),
    ("/soil/pressure_sinkage", r#"{"law": "direct", "k_s": 8e5, "n0": 1}"#, r#"{"law": "direct", "k_s": 9e5, "n0": 1.1}"#),
    ("/soil/lateral_shear_modulus_m", "0.01", "0.02"),
    ("/soil/unit_weight_n_m3", "15000", "16000"),
    ("/soil/bulk_density_kg_m3", "1500", "1700"),
    ("/soil/granular_stiffness_n_m3", "2e6", "3e6"),
];

/// The body with a value at a pointer.
fn changed(body: &Value, pointer: &str, value: &str) -> Value {
    let mut body = body.clone();
    let (around, name) = pointer.rsplit_once('/').expect("a pointer");
    body.pointer_mut(around).expect("an object")[name] = serde_json::from_str(value).expect("JSON");
    body
}

/// What is told changes nothing, and what is not told changes a number.
fn holds(base: &Value) {
    for (pointer, one, other) in FIELDS {
        let [one, other] = [one, other].map(|value| post("/v1/forces", &changed(base, pointer, value)));
        let told = told(&other.ok());
        let is_told = told.iter().any(|told| pointer == told || pointer.starts_with(&format!("{told}/")));
        assert_eq!(is_told, numbers(&one) == numbers(&other), "{pointer} in {base}: told {told:?}");
    }
}

#[test]
fn a_field_is_told_where_and_only_where_it_changes_nothing() {
    holds(&body(json!({})));
    holds(&body(json!({"method": "linearised"})));
    holds(&body(json!({"method": "explicit"})));
    holds(&body(json!({"method": "resistive_force"})));
    holds(&body(json!({"slip_angle_rad": 0.1, "bulldozing": "mobilised"})));
    holds(&body(json!({"normal_load_n": 80, "method": "resistive_force"})));
    holds(&body(json!({"normal_load_n": 80, "method": "linearised", "sinkage_m": null})));
}

/// What the answer of an operation tells.
fn told_by(path: &str, body: &Value) -> Vec<String> {
    told(&post(path, body).ok())
}

#[test]
fn every_operation_tells_them() {
    let mut grains = body(json!({
        "method": "resistive_force", "sinkage_m": null, "normal_load_n": 80, "normal_stress_radius": "shearing"
    }));
    grains["soil"] = json!({"friction_angle_rad": 0.5, "bulk_density_kg_m3": 1600, "shear_modulus_m": 0.01});
    let own = ["/contact", "/normal_stress_radius", "/soil/shear_modulus_m"];
    for path in ["/v1/forces", "/v1/stress-profile"] {
        assert_eq!(told_by(path, &grains), own, "{path}");
    }
    let sweep = with(&grains, json!({"slip": [0.1, 0.2]}));
    assert_eq!(told_by("/v1/slip-sweep", &sweep), own);
    assert_eq!(told_by("/v1/compare", &with(&sweep, json!({"method": null, "methods": ["resistive_force"]}))), own);
    let towed = with(&grains, json!({"slip": null, "normal_stress_radius": null}));
    assert_eq!(told_by("/v1/towed", &towed), ["/contact", "/soil/shear_modulus_m"]);
    let grid = json!({"of": "forces", "request": grains, "axes": [{"field": "/slip", "values": [0.1, 0.2]}]});
    assert_eq!(told_by("/v1/sweep", &grid), own);
    let data = json!({"slip": [0.1, 0.2], "sinkage_m": [0.02, 0.03], "normal_force_n": [80, 120]});
    let fit = json!({"slip": null, "normal_load_n": null, "fit": ["granular_stiffness_n_m3"], "data": data});
    let of_fit = [own[0], own[1], "/soil/friction_angle_rad", own[2], "/soil/bulk_density_kg_m3"];
    assert_eq!(told_by("/v1/identify", &with(&grains, fit)), of_fit);
    // A run may show a pull that follows from the torque, which reads the contact.
    let columns = json!({"time_s": [0, 1], "slip": [0.1, 0.2]});
    let run = with(&grains, json!({"slip": null, "columns": columns}));
    assert_eq!(told_by("/v1/track", &run), [own[2]]);
}

#[test]
fn a_rover_tells_them_of_every_soil() {
    let (wheel, grains) =
        (json!({"radius_m": 0.1, "width_m": 0.06}), json!({"friction_angle_rad": 0.5, "granular_stiffness_n_m3": 2e6}));
    let station = |x: f64, soil: &Value| json!({"x_m": x, "wheel": wheel, "soil": soil});
    let rover = json!({
        "mass_kg": 20, "method": "resistive_force", "soil": {"preset": "letter-sand"}, "peak_sinkage": "half",
        "stations": [station(0.5, &grains), station(-0.5, &with(&grains, json!({"bulk_density_kg_m3": 1500})))]
    });
    let expected = [
        "/stations/0/soil/friction_angle_rad",
        "/stations/1/soil/friction_angle_rad",
        "/stations/1/soil/bulk_density_kg_m3",
        "/peak_sinkage",
        "/soil",
    ];
    assert_eq!(told_by("/v1/vehicle", &with(&rover, json!({"soil": grains}))), expected);
}

#[test]
fn a_method_without_a_shear_displacement_names_no_circle_for_it() {
    let of = |method: &str| post("/v1/forces", &body(json!({"method": method}))).ok()["shear_displacement_radius"].clone();
    assert_eq!([of("resistive_force"), of("explicit")], [Value::Null, json!("shearing")]);
}

#[test]
fn what_is_not_read_of_a_preset_was_not_sent() {
    let answer = get("/v1/forces?wheel.preset=letter&soil.preset=letter-sand&slip=0.2&sinkage_m=0.02&peak_sinkage=half").ok();
    assert_eq!(told(&answer), ["/peak_sinkage"]);
    let plain = get("/v1/forces?wheel.preset=letter&soil.preset=letter-sand&slip=0.2&sinkage_m=0.02").ok();
    assert_eq!(told(&plain), Vec::<String>::new());
}
