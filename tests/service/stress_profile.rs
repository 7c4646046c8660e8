//! `POST /v1/stress-profile`.

use serde_json::{Value, json};

use crate::asking::{letter, post, post_for_csv, table, with};

const COLUMNS: [&str; 6] =
    ["theta_rad", "sinkage_m", "normal_stress_pa", "shear_stress_pa", "normal_stress_linear_pa", "shear_stress_linear_pa"];

fn column(reply: &Value, name: &str) -> Vec<f64> {
    reply["columns"][name].as_array().expect("a column").iter().map(|value| value.as_f64().expect("a number")).collect()
}

#[test]
fn columns_run_from_exit_to_entry_through_the_peak() {
    for (points, rows) in [(json!(null), 201), (json!(2), 3), (json!(3), 3), (json!(50), 50), (json!(10_001), 10_001)] {
        let body = with(&letter(), json!({"points": points, "contact": {"rule": "midpoint", "c3": -0.2}}));
        let reply = post("/v1/stress-profile", &body).ok();
        let theta = column(&reply, "theta_rad");
        assert_eq!(theta.len(), rows);
        assert!(COLUMNS.iter().all(|name| column(&reply, name).len() == rows));
        assert!(theta.windows(2).all(|pair| pair[0] < pair[1]));
        let angle = |name: &str| reply["angles"][name].as_f64().expect("an angle");
        assert_eq!((theta[0], theta[rows - 1]), (angle("exit_rad"), angle("entry_rad")));
        let peak = theta.iter().position(|&theta| theta == angle("maximum_stress_rad")).expect("the peak is a point");
        assert_eq!(reply["peak"]["normal_stress_pa"].as_f64(), Some(column(&reply, "normal_stress_pa")[peak]));
        assert_eq!(reply["peak"]["shear_stress_pa"].as_f64(), Some(column(&reply, "shear_stress_linear_pa")[peak]));
        let raised = reply["warnings"].as_array().expect("warnings").iter().any(|warning| warning["code"] == "points_raised");
        assert_eq!(raised, points == json!(2));
    }
}

/// With the peak at the midpoint of a contact of angle θ1, at the peak: σ = K_s z_m^N and τ = E σ tan φ, by hand.
#[test]
fn the_peak_of_the_letters_example_is_what_a_calculator_gives() {
    let reply = post("/v1/stress-profile", &letter()).ok();
    let theta_1 = 0.9_f64.acos();
    let theta_m = 0.5 * theta_1;
    let normal = 747_530.0 * (0.2 * (theta_m.cos() - 0.9)).powf(0.91);
    let j = 0.2 * (theta_1 - theta_m - 0.8 * (theta_1.sin() - theta_m.sin()));
    let shear = (1.0 - (-j / 0.005).exp()) * normal * 0.478_f64.tan();
    let peak = |name: &str| reply["peak"][name].as_f64().expect("a number");
    assert!((peak("normal_stress_pa") / normal - 1.0).abs() < 1e-12);
    assert!((peak("shear_stress_pa") / shear - 1.0).abs() < 1e-12);
}

#[test]
fn a_load_is_carried_by_the_quadrature() {
    let load = json!({"sinkage_m": null, "normal_load_n": 80});
    let profile = post("/v1/stress-profile", &with(&letter(), load.clone())).ok();
    let forces = post("/v1/forces", &with(&letter(), load)).ok();
    assert_eq!(profile["sinkage_m"], forces["sinkage_m"]);
}

#[test]
fn a_table_has_the_same_numbers() {
    let body = with(&letter(), json!({"points": 11}));
    let reply = post("/v1/stress-profile", &body).ok();
    let columns = table(&post_for_csv("/v1/stress-profile", &body).text);
    assert_eq!(columns.iter().map(|(name, _)| name.as_str()).collect::<Vec<_>>(), COLUMNS);
    for (name, values) in columns {
        let values: Vec<f64> = values.into_iter().map(|value| value.expect("no empty cell")).collect();
        assert_eq!(values, column(&reply, &name));
    }
}

#[test]
fn a_backward_wheel_is_said_to_be_mirrored_and_a_method_is_unknown_here() {
    let back = json!({"slip": null, "forward_velocity_m_s": -0.16, "angular_velocity_rad_s": -1});
    assert!(post("/v1/stress-profile", &with(&letter(), back)).warned_of().contains(&"mirrored".into()));
    assert_eq!(post("/v1/stress-profile", &with(&letter(), json!({"method": "explicit"}))).pointers(), ["/method"]);
}
