//! The quantities of answers: `/v1/model` lists them, the contract has their units, and answers have no others.

use std::collections::{BTreeMap, BTreeSet};

use axum::body::Body;
use serde_json::{Value, json};

use crate::asking::{get, letter, post, request, send, with};
use crate::documents::document;

/// Name and unit of the quantities that the answers of an operation have.
fn listed(path: &str) -> BTreeMap<String, String> {
    let model = get("/v1/model").ok();
    let of_path = |quantity: &&Value| quantity["operations"].as_array().expect("operations").contains(&json!(path));
    let text = |value: &Value| value.as_str().expect("a text").to_owned();
    let quantities = model["quantities"].as_array().expect("quantities").iter().filter(of_path);
    quantities.map(|quantity| (text(&quantity["name"]), text(&quantity["unit"]))).collect()
}

fn names(object: &Value) -> BTreeSet<String> {
    object.as_object().expect("an object").keys().cloned().collect()
}

/// The unit of each property of a schema that is a number or a list of numbers.
fn units(document: &Value, schema: &str) -> BTreeMap<String, String> {
    let properties = document["components"]["schemas"][schema]["properties"].as_object().expect("properties");
    let unit = |property: &Value| property.get("x-unit").or_else(|| property["items"].get("x-unit")).cloned();
    properties.iter().filter_map(|(name, of)| Some((name.clone(), unit(of)?.as_str()?.to_owned()))).collect()
}

fn sideways() -> Value {
    with(&letter(), json!({"slip_angle_rad": 0.2, "soil": {"unit_weight_n_m3": 15000}}))
}

#[test]
fn answers_have_the_quantities_that_are_listed_and_no_others() {
    let forces = post("/v1/forces", &sideways()).ok();
    let mut found = names(&forces);
    found.extend(names(&forces["components"]));
    let words = ["method", "shear_displacement_radius", "slip_radius", "normal_stress_from"];
    for other in words.into_iter().chain(["angles", "components", "warnings"]) {
        assert!(found.remove(other), "{other}");
    }
    assert_eq!(found, listed("/v1/forces").into_keys().collect());

    // What the load shows of the soil is there where it is known beside the sinkage.
    let slips = json!({"slip": [0.1, 0.2], "normal_load_n": 80});
    let sweep = post("/v1/slip-sweep", &with(&sideways(), slips.clone())).ok();
    assert_eq!(names(&sweep["columns"]), listed("/v1/slip-sweep").into_keys().collect());
    let comparison = post("/v1/compare", &with(&letter(), slips)).ok();
    assert_eq!(names(&comparison["series"][0]["columns"]), listed("/v1/compare").into_keys().collect());

    let columns = json!({"time_s": [0, 1], "slip": [0.1, 0.2], "sinkage_m": [0.01, 0.02], "torque_n_m": [2, 4]});
    let body = with(
        &letter(),
        json!({"slip": null, "sinkage_m": null, "static_sinkage_m": 0.01, "normal_load_n": 80, "strength": true, "columns": columns}),
    );
    let track = post("/v1/track", &body).ok();
    assert_eq!(names(&track["columns"]), listed("/v1/track").into_keys().collect());
}

#[test]
fn the_contract_has_the_unit_of_every_quantity() {
    let document = document();
    let with_unit = |path: &str| -> BTreeMap<String, String> {
        listed(path).into_iter().filter(|(_, unit)| !unit.is_empty()).collect() // a word has none
    };
    let mut of_forces = units(&document, "Forces");
    of_forces.extend(units(&document, "Components"));
    assert_eq!(of_forces, with_unit("/v1/forces"));
    assert_eq!(units(&document, "SweepColumns"), with_unit("/v1/slip-sweep"));
    assert_eq!(units(&document, "TrackedColumns"), with_unit("/v1/track"));
    // Elsewhere the suffix of a name is its unit.
    assert_eq!(units(&document, "Angles").into_values().collect::<BTreeSet<_>>(), ["rad".to_owned()].into());
    assert_eq!(units(&document, "ValidationForces")["lateral_coefficient"], "1");
}

/// What was found can be asked about as it stands.
#[test]
fn a_fitted_soil_and_its_contact_can_be_sent_back() {
    let document = document();
    let schemas = &document["components"]["schemas"];
    let reference = |schema: &str, field: &str| schemas[schema]["properties"][field]["$ref"].clone();
    // Whole laws are the first of what a request takes; the other are single values of a preset's law.
    let whole = |schema: &str, field: &str| schemas[schema]["properties"][field]["oneOf"][0]["$ref"].clone();
    assert_eq!(reference("Identification", "soil"), reference("ForcesRequest", "soil"));
    assert_eq!(reference("Identification", "contact"), whole("ForcesRequest", "contact"));
    assert_eq!(reference("PlatesIdentification", "pressure_sinkage"), whole("Soil", "pressure_sinkage"));

    // The letter's wheel and sand by independent integrals.
    let body = json!({
        "wheel": {"preset": "letter"}, "soil": {"preset": "letter-sand"}, "fit": ["friction_angle_rad"],
        "data": {"slip": [0.2, 0.5], "sinkage_m": [0.02, 0.02], "torque_n_m": [7.3396, 8.3513]}
    });
    let found = post("/v1/identify", &body).ok();
    let asked = json!({
        "wheel": {"preset": "letter"}, "soil": found["soil"], "contact": found["contact"], "slip": 0.2, "sinkage_m": 0.02
    });
    let torque = post("/v1/forces", &asked).ok()["torque_n_m"].as_f64().expect("a torque");
    assert!((torque - 7.3396).abs() < 1e-3, "{torque}");
}

#[test]
fn answers_of_the_api_name_the_version_of_the_model() {
    for (path, status) in [("/v1/model", 200), ("/v1/forces", 422), ("/v1/nothing", 404)] {
        let answer = send(request("GET", path, &[], Body::empty()));
        assert_eq!((answer.status.as_u16(), answer.header("x-model-version")), (status, terramechanics::VERSION), "{path}");
    }
    assert_eq!(send(request("GET", "/healthz", &[], Body::empty())).header("x-model-version"), "");
}

/// A number in words is for people; programs have it beside them.
#[test]
fn a_warning_has_its_data_beside_its_sentence() {
    let small = json!({"slip": {"from": -0.5, "to": 1, "points": 7}, "sinkage_m": null, "static_sinkage_m": 0.01});
    let warnings = post("/v1/slip-sweep", &with(&letter(), small)).ok()["warnings"].clone();
    let of = |code: &str| warnings.as_array().expect("warnings").iter().find(|w| w["code"] == code).expect(code).clone();
    // s is −0.5, −0.25, 0, 0.25, 0.5, 0.75 and 1.
    let (braking, fast) = (of("slip_sinkage_extrapolated"), of("slip_beyond_fit"));
    assert_eq!((&braking["rows"], &braking["count"], &braking["value"]), (&json!([[0, 1]]), &json!(2), &json!(-0.5)));
    assert_eq!((&fast["rows"], &fast["count"], &fast["value"]), (&json!([[5, 6]]), &json!(2), &json!(1.0)));
    for warning in [&braking, &fast] {
        assert_eq!((&warning["quantity"], &warning["unit"]), (&json!("slip"), &json!("1")));
        assert_eq!(warning["range"]["quantity"], "slip (–)");
    }
}
