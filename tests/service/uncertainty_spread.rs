//! `"spread": "catalogue"`: a soil that is known by its kind.

use serde_json::{Value, json};

use crate::asking::{get, post, with};
use crate::uncertainty::{COHESION, MODULUS, found};

fn snow(soil: Value, inputs: Value) -> Value {
    let soil = with(&json!({"preset": "lever-snow", "spread": "catalogue"}), soil);
    let request = json!({"wheel": {"preset": "letter"}, "soil": soil, "slip": 0.2, "normal_load_n": 80, "method": "linearised"});
    json!({"of": "forces", "request": request, "inputs": inputs, "samples": 256})
}

#[test]
fn a_soil_takes_the_published_spread_of_its_kind() {
    let answer = found(&snow(json!({}), json!([])));
    let inputs = answer["inputs"].as_array().expect("inputs");
    let fields: Vec<&Value> = inputs.iter().map(|input| &input["field"]).collect();
    let law = "/soil/pressure_sinkage";
    let [k_c, n0] = ["k_c", "n0"].map(|name| format!("{law}/{name}"));
    assert_eq!(fields, [COHESION, "/soil/friction_angle_rad", &k_c, MODULUS, &n0]);
    // The cohesions of snow, from the catalogue.
    let mut cohesions: Vec<f64> = published_soils()
        .iter()
        .filter(|soil| soil["kind"] == "snow")
        .map(|soil| soil["values"]["cohesion_pa"]["value"].as_f64().expect("a cohesion"))
        .collect();
    cohesions.sort_by(f64::total_cmp);
    assert_eq!(inputs[0]["values"], json!(cohesions));
    assert!(
        inputs
            .iter()
            .all(|input| input["from"] == "catalogue" && input["reason"].as_str().is_some_and(|text| text.contains("snow")))
    );
    assert!(inputs[0]["soils"].as_array().expect("soils").contains(&json!("lever-snow")));
    assert_eq!(answer["held"][0]["field"], "shear_modulus_m");
    let groups: Vec<usize> = answer["sensitivities"]
        .as_array()
        .expect("sensitivities")
        .iter()
        .filter(|one| one["quantity"] == "longitudinal_force_n")
        .map(|one| one["fields"].as_array().expect("fields").len())
        .collect();
    assert_eq!(groups, [1, 1, 3]);
}

fn published_soils() -> Vec<Value> {
    get("/v1/soils").ok()["soils"].as_array().expect("soils").clone()
}

#[test]
fn what_a_client_knows_does_not_spread() {
    let fields = |body: &Value| -> Vec<Value> {
        found(body)["inputs"].as_array().expect("inputs").iter().map(|input| input["field"].clone()).collect()
    };
    let law = json!({"law": "bekker", "k_c": 1000, "k_phi": 2e5, "n0": 1.5});
    assert_eq!(fields(&snow(json!({"pressure_sinkage": law, "cohesion_pa": 800}), json!([]))), ["/soil/friction_angle_rad"]);
    let own = json!([{"field": "/soil/friction_angle_rad", "distribution": "uniform", "low": 0.3, "high": 0.4}]);
    let varied = fields(&snow(json!({"cohesion_pa": 800}), own));
    assert_eq!((varied.len(), &varied[0]), (4, &json!("/soil/friction_angle_rad")));
    let alone = with(&snow(json!({}), json!([])), json!({"request": {"soil": {"preset": "letter-sand"}}}));
    let said = post("/v1/uncertainty", &alone).fault("/request/soil/spread");
    assert!(said.contains("only one soil of the kind `paper`"), "{said}");
    let without = with(&snow(json!({}), json!([])), json!({"request": {"soil": {"preset": null}}}));
    assert!(post("/v1/uncertainty", &without).pointers().contains(&"/request/soil/spread".to_owned()));
    let wrong = with(&snow(json!({}), json!([])), json!({"request": {"soil": {"spread": "catalog"}}}));
    assert_eq!(
        post("/v1/uncertainty", &wrong).fault("/request/soil/spread"),
        "unknown name `catalog`; did you mean `catalogue`?"
    );
}
