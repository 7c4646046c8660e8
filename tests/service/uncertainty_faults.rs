//! What `/v1/uncertainty` refuses, and where it points.

use serde_json::{Value, json};

use crate::asking::{post, with};
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
