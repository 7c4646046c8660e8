//! `/v1/identify` with the linear estimator.

use serde_json::{Value, json};

use crate::asking::{letter, post, with};
use crate::identify::{codes, cohesive, estimate, measured, value};

/// What the closed forms say of a wheel, for the linear estimator, which knows nothing but the shear modulus.
fn line_request() -> Value {
    json!({"wheel": {"radius_m": 0.2, "width_m": 0.1}, "soil": {"shear_modulus_m": 0.015}, "estimator": "linear",
        "fit": ["cohesion_pa", "friction_angle_rad"], "data": measured(&cohesive(), "linearised")})
}

#[test]
fn the_linear_estimator_finds_the_strength_in_one_pass() {
    let reply = post("/v1/identify", &line_request()).ok();
    assert!((value(&reply, "cohesion_pa") / 400.0 - 1.0).abs() < 1e-6, "{reply}");
    assert!((value(&reply, "friction_angle_rad") / 0.478 - 1.0).abs() < 1e-9);
    assert_eq!((&reply["converged"], &reply["identifiable"]), (&json!(true), &json!(true)));
    assert_eq!(codes(&reply), ["linearised_stresses"]);
    assert!(estimate(&reply, "cohesion_pa").get("model_bias").is_none(), "no law, no simulation");
    assert!(reply["soil"].get("pressure_sinkage").is_none(), "none was sent");
    // Its soil with a law is one for requests; so is one whose catalogue has the law.
    let named = post("/v1/identify", &with(&line_request(), json!({"soil": {"preset": "letter-sand"}}))).ok();
    assert_eq!(named["soil"]["pressure_sinkage"]["law"], "bekker");
}

/// The contact is not the published one only.
#[test]
fn the_linear_estimator_takes_the_contact_and_the_radius() {
    let around = json!({"contact": {"rule": "wong_reece", "c1": 0.4, "c2": 0.2, "c3": -0.1}, "normal_stress_radius": "shearing",
        "wheel": {"lug_height_m": 0.01}});
    let body = with(&with(&line_request(), around.clone()), json!({"data": measured(&with(&cohesive(), around), "linearised")}));
    let reply = post("/v1/identify", &body).ok();
    assert!((value(&reply, "cohesion_pa") / 400.0 - 1.0).abs() < 1e-6, "{reply}");
    let other = post("/v1/identify", &with(&body, json!({"contact": null}))).ok();
    assert!((value(&other, "cohesion_pa") / 400.0 - 1.0).abs() > 0.05, "{other}");
}

#[test]
fn the_linear_estimator_refuses_what_has_no_meaning_for_it() {
    let faults = |changes: Value| post("/v1/identify", &with(&line_request(), changes)).pointers();
    assert_eq!(faults(json!({"fit": ["cohesion_pa"], "soil": {"friction_angle_rad": 0.5}})), ["/fit"]);
    assert_eq!(faults(json!({"data": {"torque_n_m": null}})), ["/data/torque_n_m"]);
    assert_eq!(faults(json!({"data": {"normal_force_n": vec![0.0; 9]}})), ["/data/normal_force_n/0"]);
    let idle =
        json!({"starts": 3, "loss": "huber", "method": "explicit", "peak_sinkage": "half", "lambda_a": 0.1, "lambda_b": 0});
    let mut pointers = faults(idle);
    pointers.sort();
    assert_eq!(pointers, ["/lambda_a", "/lambda_b", "/loss", "/method", "/peak_sinkage", "/starts"]);
    assert_eq!(post("/v1/identify", &with(&line_request(), json!({"method": "linearised"}))).status, 200);
    let shear = json!({"soil": {"shear": {"law": "wong_peak", "peak_displacement_m": 0.02}}});
    assert_eq!(faults(shear), ["/soil/shear"]);
    let alike = json!({"data": {"slip": [0.2, 0.2], "sinkage_m": [0.02, 0.02], "normal_force_n": [80, 80], "torque_n_m": [7, 7], "longitudinal_force_n": null}});
    assert_eq!(faults(alike), ["/data"]);
    assert_eq!(faults(json!({"soil": {"shear_modulus_m": null}})), ["/soil/shear_modulus_m"]);
}

/// A wheel of 0.125 m with lugs under five loads, by the quadrature: both intervals miss the truth, and the answer says by how much.
#[test]
fn the_bias_of_linear_stresses_is_told() {
    let soil = json!({"cohesion_pa": 800, "friction_angle_rad": 0.52, "shear_modulus_m": 0.012,
        "pressure_sinkage": {"law": "direct", "k_s": 9e5, "n0": 0.9}});
    let base = json!({"wheel": {"radius_m": 0.125, "width_m": 0.1, "lug_height_m": 0.012}, "soil": soil});
    let (mut slips, mut sinkages, mut loads, mut torques) = (vec![], vec![], vec![], vec![]);
    for load in [20, 40, 60, 80, 100] {
        for slip in [0.1, 0.3, 0.6] {
            let forces = post("/v1/forces", &with(&base, json!({"slip": slip, "normal_load_n": load}))).ok();
            slips.push(json!(slip));
            loads.push(json!(load));
            sinkages.push(forces["sinkage_m"].clone());
            torques.push(forces["torque_n_m"].clone());
        }
    }
    let data = json!({"slip": slips, "sinkage_m": sinkages, "normal_force_n": loads, "torque_n_m": torques});
    let body = with(&base, json!({"estimator": "linear", "fit": ["cohesion_pa", "friction_angle_rad"], "data": data}));
    let reply = post("/v1/identify", &body).ok();
    assert_eq!(codes(&reply), ["linearised_stresses", "model_bias", "model_bias"], "{reply}");
    for (name, truth) in [("cohesion_pa", 800.0), ("friction_angle_rad", 0.52)] {
        let found = estimate(&reply, name);
        let [lower, upper] = [0, 1].map(|end| found["interval_95"][end].as_f64().expect("an end"));
        assert!(!(lower..=upper).contains(&truth), "{found}");
        let bias = found["model_bias"].as_f64().expect("a bias");
        assert!(((value(&reply, name) - bias) / truth - 1.0).abs() < 0.02, "{found}");
    }
}

/// One load, one slip: the line has small errors, and they mean nothing.
#[test]
fn a_line_through_samples_of_one_kind_is_flagged() {
    for (slips, sinkages, code) in
        [([0.1, 0.2, 0.4, 0.6], [0.02; 4], "single_load"), ([0.3; 4], [0.01, 0.02, 0.03, 0.035], "single_slip")]
    {
        let points: Vec<Value> = slips
            .iter()
            .zip(sinkages)
            .map(|(slip, sinkage)| {
                let point = json!({"slip": slip, "sinkage_m": sinkage, "method": "explicit"});
                post("/v1/forces", &with(&with(&letter(), cohesive()), point)).ok()
            })
            .collect();
        let column = |name: &str| points.iter().map(|point| point[name].clone()).collect::<Vec<_>>();
        let load = if code == "single_load" { vec![json!(100.0); 4] } else { column("normal_force_n") };
        let data = json!({"slip": slips, "sinkage_m": sinkages, "normal_force_n": load, "torque_n_m": column("torque_n_m"), "longitudinal_force_n": null});
        let reply = post("/v1/identify", &with(&line_request(), json!({ "data": data }))).ok();
        assert_eq!(reply["identifiable"], false, "{reply}");
        assert!(codes(&reply).contains(&code.to_owned()) && codes(&reply).contains(&"not_identifiable".to_owned()), "{reply}");
        for name in ["cohesion_pa", "friction_angle_rad"] {
            let words = estimate(&reply, name)["identifiability"].as_str().expect("words").to_owned();
            assert!(words.starts_with("not determined by data of this kind"), "{words}");
            let known = &estimate(&reply, name)["known"];
            // A wrong K changes both by the same factor; under one load, c and φ stand for one another.
            let other = match (code, name) {
                ("single_slip", _) => "shear_modulus_m",
                (_, "cohesion_pa") => "friction_angle_rad",
                _ => "cohesion_pa",
            };
            assert_eq!(
                (&known["code"], &known["gap"], &known["tied_to"]),
                (&json!("unseparated"), &json!(code), &json!([other]))
            );
        }
    }
}
