//! The contract is made of the declaration.

use crate::sample::BRIDGE;
use serde_json::{Value, json};
use terramechanics_reading::Components;

fn components() -> Value {
    let mut found = Components::new();
    found.push((BRIDGE.name.to_owned(), BRIDGE.schema()));
    BRIDGE.components(&mut found);
    found
        .into_iter()
        .map(|(name, schema)| (name, serde_json::to_value(schema).expect("JSON")))
        .collect::<serde_json::Map<_, _>>()
        .into()
}

#[test]
fn every_object_and_every_form_is_a_named_component() {
    let components = components();
    let names: Vec<_> = components.as_object().expect("components").keys().collect();
    assert_eq!(names, ["Beam", "BridgeRequest", "HollowBeam", "LoadRange", "Pier", "SolidBeam"]);
    let bridge = &components["BridgeRequest"];
    assert_eq!(bridge["additionalProperties"], false);
    assert_eq!(bridge["required"], json!(["span_m", "beam", "load"]));
    assert_eq!(bridge["properties"]["beam"]["$ref"], "#/components/schemas/Beam");
    assert_eq!(bridge["properties"]["piers"]["items"]["$ref"], "#/components/schemas/Pier");
}

#[test]
fn the_forms_of_a_tagged_object_are_told_apart_by_the_tag() {
    let components = components();
    let beam = &components["Beam"];
    assert_eq!(beam["oneOf"][1]["$ref"], "#/components/schemas/HollowBeam");
    assert_eq!(beam["discriminator"]["propertyName"], "law");
    assert_eq!(beam["discriminator"]["mapping"]["solid"], "#/components/schemas/SolidBeam");
    let solid = &components["SolidBeam"];
    assert_eq!(solid["required"], json!(["law", "width_m"]));
    assert_eq!(solid["properties"]["law"]["enum"], json!(["solid"]));
    assert_eq!(solid["properties"]["depth"]["default"], 2.0);
}

#[test]
fn numbers_have_their_units_and_bounds() {
    let components = components();
    let span = &components["BridgeRequest"]["properties"]["span_m"];
    assert_eq!((&span["x-unit"], span["minimum"].as_f64(), span["maximum"].as_f64()), (&json!("m"), Some(1.0), Some(5000.0)));
    let load = &components["BridgeRequest"]["properties"]["load"]["oneOf"];
    assert_eq!(load[0]["x-unit"], "N");
    assert_eq!(load[1]["enum"], json!(["own"]));
    assert_eq!((&load[2]["items"]["x-unit"], &load[2]["maxItems"]), (&json!("N"), &json!(100)));
}

#[test]
fn a_query_has_a_parameter_for_every_field_but_lists_of_numbers_and_objects() {
    let mut found = Vec::new();
    BRIDGE.parameters("", &mut found);
    let names: Vec<_> = found.iter().map(|parameter| parameter.name.as_str()).collect();
    let beam = ["beam.law", "beam.width_m", "beam.depth", "beam.wall_m"];
    assert_eq!(names, [&["span_m"][..], &beam, &["load", "load.from", "load.to", "side", "sides", "note"]].concat());
    let sides = serde_json::to_value(&found[9]).expect("JSON");
    assert_eq!((&sides["style"], &sides["explode"], &sides["schema"]["type"]), (&json!("form"), &json!(false), &json!("array")));
    let load = serde_json::to_value(&found[5]).expect("JSON");
    assert_eq!(load["schema"]["oneOf"].as_array().map(Vec::len), Some(2));
    assert_eq!(load["description"], "The load.");
}
