//! What `/v1/identify` refuses.

use serde_json::{Value, json};

use crate::asking::{Answer, letter, post, with};
use crate::identify::request;

fn refused(changes: Value) -> Answer {
    post("/v1/identify", &with(&request("linearised"), changes))
}

#[test]
fn bad_data_are_pointed_at() {
    let faults = |changes: Value| refused(changes).pointers();
    assert_eq!(faults(json!({"data": {"torque_n_m": [1, 2]}})), ["/data/torque_n_m"]);
    let holes = json!([0.1, "0.2", null, 0.3, 7, 0.3, 0.3, 0.3, 0.3]);
    assert_eq!(faults(json!({"data": {"slip": holes}})), ["/data/slip/1", "/data/slip/2", "/data/slip/4"]);
    assert_eq!(faults(json!({"data": {"slip": []}})), ["/data/slip"]);
    assert_eq!(
        faults(json!({"data": {"sinkage_m": [0.01, 0.3, 0.01, 0.01, 0.01, 0.01, 0.01, 0.01, 0.01]}})),
        ["/data/sinkage_m/1"]
    );
    assert_eq!(faults(json!({"data": {"slip": vec![2.0; 30]}})).len(), 11, "ten are listed, the others are counted");
    assert_eq!(faults(json!({"data": {"sinkage_m": null, "normal_force_n": null}})), ["/data"]);
    assert_eq!(faults(json!({"data": {"sinkage_m": null, "normal_force_n": vec![-1.0; 9]}})), ["/data/normal_force_n/0"]);
    assert_eq!(faults(json!({"data": {"torque_n_m": null, "normal_force_n": null, "longitudinal_force_n": null}})), ["/data"]);
    assert_eq!(faults(json!({"data": {"slip": vec![0.1; 10_002]}})), ["/data/slip"]);
    assert_eq!(refused(json!({"data": {"torque": [1]}})).fault("/data/torque"), "unknown field; did you mean `torque_n_m`?");
}

#[test]
fn bad_parameters_are_pointed_at() {
    let faults = |changes: Value| refused(changes).pointers();
    assert_eq!(refused(json!({"fit": ["cohesion"]})).fault("/fit/0"), "unknown name `cohesion`; did you mean `cohesion_pa`?");
    assert_eq!(faults(json!({"fit": ["k_s", "k_s", 3]})), ["/fit/1", "/fit/2"]);
    assert_eq!(faults(json!({"fit": []})), ["/fit"]);
    assert_eq!(faults(json!({"fit": null})), ["/fit"]);
    assert_eq!(faults(json!({"soil": letter()["soil"], "fit": ["k_s"]})), ["/fit/0"]);
    assert_eq!(faults(json!({"soil": letter()["soil"], "fit": ["lambda_a"]})), ["/fit/0"]);
    assert_eq!(
        faults(json!({"fit": ["n0"]})),
        ["/soil/cohesion_pa", "/soil/friction_angle_rad", "/soil/shear_modulus_m", "/soil/pressure_sinkage"]
    );
    assert_eq!(
        refused(json!({"soil": null, "fit": ["n0", "cohesion_pa", "k_c"]})).fault("/soil"),
        "a soil is needed: neither given nor fitted are friction_angle_rad, shear_modulus_m, k_phi"
    );
    let fault = refused(json!({"soil": letter()["soil"], "fit": ["k_s"]})).fault("/fit/0");
    assert!(fault.ends_with("fit `k_c` and `k_phi`, or choose the law `direct`"), "{fault}");
    assert_eq!(faults(json!({"bounds": {"n0": [2, 1]}})), ["/bounds/n0"]);
    assert_eq!(faults(json!({"bounds": {"n0": [0, 1]}})), ["/bounds/n0/0"]);
    assert_eq!(faults(json!({"bounds": {"n0": [1]}, "start": {"c1": 0.4}})), ["/start/c1", "/bounds/n0"]);
    assert_eq!(faults(json!({"bounds": {"n0": [0.5, 1]}, "start": {"n0": 2}})), ["/start/n0"]);
    assert_eq!(
        faults(json!({"standard_deviation": {"torque_n_m": 0.1}})),
        ["/standard_deviation/longitudinal_force_n", "/standard_deviation/normal_force_n"]
    );
    assert_eq!(faults(json!({"standard_deviation": {"torque_n_m": [1, 2]}})), ["/standard_deviation/torque_n_m"]);
    assert_eq!(faults(json!({"slip_sinkage": {"law": "lyasko"}})), ["/slip_sinkage"]);
    assert_eq!(faults(json!({"loss": "hubber", "estimator": "magic", "starts": 33})).len(), 3);
}

/// A wheel that needs more than the soil could carry at any start is an answer, not a failure of the service.
#[test]
fn data_that_the_model_cannot_explain_are_refused_with_the_row() {
    let body = json!({"bounds": {"k_s": [1, 10], "n0": [0.9, 1]}, "start": {"k_s": 5, "n0": 1}, "data": {"sinkage_m": null}});
    assert_eq!(refused(body).pointers(), ["/data/normal_force_n/0"]);
}

/// Every value of a request replaced by odd ones: an answer of the documented shape or a refusal, nothing else.
#[test]
fn whatever_is_sent_the_answer_is_no_500() {
    fn pointers(value: &Value, at: &str, found: &mut Vec<String>) {
        let children: Vec<(String, &Value)> = match value {
            Value::Object(fields) => fields.iter().map(|(name, value)| (name.clone(), value)).collect(),
            Value::Array(items) => items.iter().enumerate().take(2).map(|(i, value)| (i.to_string(), value)).collect(),
            _ => Vec::new(),
        };
        for (name, value) in children {
            let pointer = format!("{at}/{name}");
            found.push(pointer.clone());
            pointers(value, &pointer, found);
        }
    }
    let changes = json!({"soil": letter()["soil"], "fit": ["cohesion_pa", "friction_angle_rad", "n0"], "starts": 2, "loss": "huber",
        "contact": {"rule": "wong_reece", "c1": 0.4, "c2": 0.1}, "bounds": {"n0": [0.5, 1.5]}, "start": {"cohesion_pa": 10},
        "standard_deviation": {"longitudinal_force_n": 1, "normal_force_n": 1, "torque_n_m": vec![0.1; 9]}});
    let base = with(&request("explicit"), changes);
    let mut found = Vec::new();
    pointers(&base, "", &mut found);
    assert!(found.len() > 40);
    let odd = [
        json!(null),
        json!(0),
        json!(-1),
        json!(1e12),
        json!(-1e12),
        json!(5e-324),
        json!(""),
        json!([]),
        json!({}),
        json!(true),
    ];
    for pointer in found {
        for value in &odd {
            let mut body = base.clone();
            *body.pointer_mut(&pointer).expect("a field") = value.clone();
            let answer = post("/v1/identify", &body);
            if answer.status == 200 {
                let reply = answer.json();
                assert!(reply["estimates"].as_array().is_some_and(|all| all.iter().all(|one| one["value"].is_number())));
                assert!(reply["rmse"].as_object().is_some_and(|all| all.values().all(Value::is_number)), "{pointer} = {value}");
            } else {
                answer.problem(422);
            }
        }
    }
}

/// A column whose squares vanish, and one whose load is next to nothing: an answer or a fault, and in time.
#[test]
fn measurements_of_any_size_are_answered() {
    let body = |normal: f64, torque: f64| {
        json!({
            "wheel": {"radius_m": 0.15, "width_m": 0.12},
            "soil": {"cohesion_pa": 600, "shear_modulus_m": 0.012, "pressure_sinkage": {"law": "direct", "k_s": 9e5, "n0": 0.9}},
            "fit": ["friction_angle_rad"],
            "data": {"slip": [0.1, 0.3], "normal_force_n": [normal, 2.0 * normal], "torque_n_m": [torque, torque]}
        })
    };
    assert!(post("/v1/identify", &body(60.0, 1e-200)).fault("/data/torque_n_m").contains("1e-100"));
    assert!(post("/v1/identify", &body(1e-200, 1.0)).fault("/data/normal_force_n").contains("1e-100"));
    assert!(post("/v1/identify", &body(60.0, 1e12)).ok()["estimates"][0]["value"].is_number());
}
