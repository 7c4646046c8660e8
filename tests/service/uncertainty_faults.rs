//! What `/v1/uncertainty` refuses, and where it points.

use serde_json::{Value, json};

use crate::asking::{get, post, with};
use crate::uncertainty::{COHESION, MODULUS, of_two};

#[test]
fn every_fault_is_pointed_at() {
    let pointers = |changes: Value| post("/v1/uncertainty", &of_two(changes)).pointers();
    let of = |input: Value| pointers(json!({"inputs": [with(&json!({"field": COHESION}), input)]}));
    assert_eq!(of(json!({"distribution": "gauss"})), ["/inputs/0/distribution"]);
    assert_eq!(of(json!({"distribution": "normal"})), ["/inputs/0/mean", "/inputs/0/standard_deviation"]);
    assert_eq!(of(json!({"distribution": "normal", "mean": 1, "standard_deviation": 0})), ["/inputs/0/standard_deviation"]);
    assert_eq!(of(json!({"distribution": "lognormal", "mean": 0, "standard_deviation": 1})), ["/inputs/0/mean"]);
    assert_eq!(of(json!({"distribution": "uniform", "low": 2, "high": 1})), ["/inputs/0/high"]);
    assert_eq!(of(json!({"distribution": "uniform", "low": 2, "high": 3, "mode": 2})), ["/inputs/0/mode"]);
    assert_eq!(of(json!({"distribution": "uniform", "relative": 0.1, "high": 1})), ["/inputs/0/high"]);
    assert_eq!(of(json!({"distribution": "triangular", "low": 0, "mode": 5, "high": 1})), ["/inputs/0/mode"]);
    assert_eq!(of(json!({"distribution": "quantiles", "values": [2, 1]})), ["/inputs/0/values"]);
    assert_eq!(of(json!({"distribution": "quantiles", "values": [-1, 1]})), ["/inputs/0/values/0"]);
    assert_eq!(of(json!({"distribution": "quantiles", "relative": 0.1})), ["/inputs/0/values", "/inputs/0/relative"]);
    let at = |field: &str| pointers(json!({"inputs": [{"field": field, "distribution": "normal", "relative": 0.1}]}));
    assert_eq!(at("/soil/cohesoin_pa"), ["/inputs/0/field", "/inputs/0/relative"]);
    assert_eq!(at("/contact/c1"), ["/inputs/0/relative"]);
    let twice = json!({"field": COHESION, "distribution": "normal", "relative": 0.1});
    assert_eq!(pointers(json!({"inputs": [twice, twice]})), ["/inputs/1/field"]);
    let samples = |values: Value| json!({"field": COHESION, "distribution": "samples", "values": values});
    let other = json!({"field": MODULUS, "distribution": "samples", "values": [7e5, 8e5, 9e5]});
    assert_eq!(pointers(json!({"inputs": [samples(json!([1, 2])), other]})), ["/inputs/1/values"]);

    assert_eq!(pointers(json!({"correlation": [[1, 0.5]]})), ["/correlation"]);
    assert_eq!(pointers(json!({"correlation": [[1, 2], [0.5, 1]]})), ["/correlation/0"]);
    assert_eq!(pointers(json!({"correlation": [[1, 1], [1, 1]]})), ["/correlation"]);
    assert_eq!(pointers(json!({"correlation": 0.5})), ["/correlation"]);
    let mut edges = json!({"samples": 255, "seed": -1, "inputs": [with(&json!({"field": COHESION, "distribution": "normal"}), json!({"relative": 10.1}))]});
    assert_eq!(pointers(edges.clone()), ["/inputs/0/relative", "/samples", "/seed"]);
    edges["samples"] = 16_385.into();
    edges["seed"] = 268_435_456.into();
    assert_eq!(pointers(edges), ["/inputs/0/relative", "/samples", "/seed"]);
    assert_eq!(pointers(json!({"samples": 16_384, "axis": {"field": "/slip", "from": 0, "to": 1, "points": 201}})), ["/samples"]);
    assert_eq!(pointers(json!({"axis": {"field": "/slip", "from": 0, "to": 1, "points": 202}})), ["/axis"]);
    assert_eq!(pointers(json!({"axis": {"field": COHESION, "values": [1]}})), ["/axis/field"]);
    assert_eq!(pointers(json!({"conditions": [{"quantity": "pull", "below": 1}]})), ["/conditions/0/quantity"]);
    assert_eq!(
        pointers(json!({"conditions": [{"quantity": "slip"}, {"quantity": "slip", "below": 1, "above": 2}]})),
        ["/conditions/0", "/conditions/1"]
    );
    assert_eq!(pointers(json!({"sensitivity_of": "torque"})), ["/sensitivity_of"]);
    assert_eq!(pointers(json!({"inputs": []})), ["/inputs"]);
    assert_eq!(pointers(json!({"request": {"sinkage_m": 0.5}})), ["/request/sinkage_m"]);
    assert_eq!(pointers(json!({"request": {"wheel": {"width_m": null}}})), ["/request/wheel/width_m"]);
    assert_eq!(post("/v1/uncertainty", &json!({})).pointers(), ["/of", "/request"]);
}

#[test]
fn a_wrong_correlation_says_what_is_wanted() {
    let said = |correlation: Value| post("/v1/uncertainty", &of_two(json!({"correlation": correlation}))).problem(422);
    let detail = |correlation: Value| said(correlation)["errors"][0]["detail"].as_str().expect("a detail").to_owned();
    assert_eq!(detail(json!([[1, 0.5]])), "must have 2 rows of 2 coefficients, one for each input; the number of rows is 1");
    assert_eq!(detail(json!([[1, 0.5], [0.5]])), "must have 2 rows of 2 coefficients, one for each input; row 1 has 1");
    assert_eq!(detail(json!([[1, 2], [0.5, 1]])), "must have numbers from -1 to 1; the one at 1 is 2");
    assert_eq!(
        detail(json!([[1, 1], [1, 1]])),
        "is not positive definite: [1][0] makes inputs 0 and 1 the same one; it must be above -1 and below 1"
    );
}

#[test]
fn a_share_needs_a_value_to_be_relative_to() {
    let fault = |field: &str, pointer: &str| {
        let input = json!({"field": field, "distribution": "normal", "relative": 0.1});
        post("/v1/uncertainty", &of_two(json!({"inputs": [input]}))).fault(pointer)
    };
    assert_eq!(
        fault("/contact/c1", "/inputs/0/relative"),
        "needs a value of the field to be relative to, and the request has none, itself or by a preset; give `mean` and `standard_deviation`"
    );
    let none = json!({"field": COHESION, "distribution": "uniform", "relative": 0.1});
    let body = of_two(json!({"inputs": [none], "request": {"soil": {"cohesion_pa": 0}}}));
    assert_eq!(
        post("/v1/uncertainty", &body).fault("/inputs/0/relative"),
        "makes no width, because the request has 0 for the field; give `low` and `high`"
    );
}

#[test]
fn a_condition_takes_no_formula() {
    let body = of_two(json!({"conditions": [{"quantity": "0.1 - sinkage_m", "below": 0.08}]}));
    let said = post("/v1/uncertainty", &body).fault("/conditions/0/quantity");
    assert_eq!(said, "must be the name of one quantity of the answer; formulas are not taken here");
}

#[test]
fn a_share_of_an_assumed_value_tells_what_was_assumed() {
    // A soil of which nobody published the shear modulus.
    let soil = "robomech2020-sand";
    let catalogue: Value = serde_json::from_str(&get(&format!("/v1/soils/{soil}")).text).expect("JSON");
    let substitute = catalogue["assumed"].as_array().expect("substitutes").iter().find(|one| one["field"] == "shear_modulus_m");
    let value = substitute.expect("one of the shear modulus")["value"].as_f64().expect("a number");
    let request = json!({"wheel": {"preset": "letter"}, "soil": {"preset": soil}, "slip": 0.2, "normal_load_n": 20});
    let input = json!({"field": "/soil/shear_modulus_m", "distribution": "normal", "relative": 0.1});
    let body = |assume: bool| {
        let request = with(&request, json!({"assume": assume}));
        json!({"of": "forces", "request": request, "inputs": [input], "samples": 256, "sensitivity": false})
    };
    assert!(post("/v1/uncertainty", &body(false)).fault("/inputs/0/relative").starts_with("needs a value"));
    let found = post("/v1/uncertainty", &body(true)).ok();
    assert_eq!(found["inputs"][0]["mean"], value);
    assert_eq!((&found["assumed"][0]["field"], &found["assumed"][0]["value"]), (&json!("soil.shear_modulus_m"), &json!(value)));
    let warned = |warning: &Value| warning["code"] == "assumed_values";
    assert!(found["warnings"].as_array().expect("warnings").iter().any(warned), "{found}");
}
