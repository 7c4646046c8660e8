//! The schemas of the contract, as generators of clients read them.

use std::collections::BTreeSet;

use serde_json::{Map, Value, json};

use crate::asking::{get, post, query_of, with};
use crate::documents::{document, resolved};

/// Generated clients send the defaults that the document names, whether their user asked for them or not.
#[test]
fn a_default_that_is_sent_changes_nothing() {
    let document = document();
    let named_preset = json!({"wheel": {"preset": "letter"}, "soil": {"preset": "letter-sand"}});
    let mut sent = 0;
    for (path, own) in [
        ("/v1/forces", json!({"slip": 0.2, "sinkage_m": 0.02})),
        ("/v1/resistances", json!({"slip": 0.2, "normal_load_n": 80})),
        ("/v1/stress-profile", json!({"slip": 0.2, "sinkage_m": 0.02})),
        ("/v1/slip-sweep", json!({"slip": {"from": -0.5, "to": 1, "points": 4}, "normal_load_n": 80})),
    ] {
        let body = with(&named_preset, own);
        let twin = resolved(&document, document["paths"][path]["get"].clone());
        let parameters = twin["parameters"].as_array().expect("parameters");
        let defaults: Vec<String> = parameters
            .iter()
            .filter_map(|parameter| Some((parameter["name"].as_str()?, parameter["schema"].get("default")?)))
            .map(|(name, default)| format!("&{name}={}", default.as_str().map_or(default.to_string(), str::to_owned)))
            .collect();
        let query = format!("{path}?{}", query_of(&body));
        assert_eq!(get(&format!("{query}{}", defaults.concat())).ok(), get(&query).ok(), "{path} {defaults:?}");

        let reference = document["paths"][path]["post"]["requestBody"]["content"]["application/json"]["schema"]["$ref"].as_str();
        let schema = document.pointer(reference.expect("a named schema").trim_start_matches('#')).expect("the schema");
        let fields = schema["properties"].as_object().expect("properties");
        let defaults: Map<String, Value> =
            fields.iter().filter_map(|(name, field)| Some((name.clone(), field.get("default")?.clone()))).collect();
        assert_eq!(post(path, &with(&body, defaults.clone().into())).ok(), post(path, &body).ok(), "{path} {defaults:?}");
        sent += defaults.len();
    }
    assert!(sent > 10, "{sent} defaults");
}

/// A generated client names a form that is a component by its name, and any other by its place in the list.
#[test]
fn no_form_of_an_object_is_without_a_name() {
    let document = document();
    let mut named = 0;
    for (name, schema) in document["components"]["schemas"].as_object().expect("schemas") {
        for form in schema["oneOf"].as_array().into_iter().flatten() {
            assert_ne!(form["type"], "object", "a form of {name} has no name");
            named += usize::from(form["$ref"].is_string());
        }
    }
    assert!(named > 10, "{named} forms");
}

/// The forms of a tagged object are components of their own, told apart by the tag: generated clients make types of them.
#[test]
fn the_forms_of_a_tagged_object_are_named_and_told_apart_by_its_tag() {
    let document = document();
    let schemas = document["components"]["schemas"].as_object().expect("schemas");
    let tagged: Vec<&String> =
        schemas.iter().filter(|(_, schema)| schema.get("discriminator").is_some()).map(|(name, _)| name).collect();
    assert_eq!(tagged, ["Contact", "PressureSinkage", "Shear", "SlipSinkage"]);
    for schema in tagged.into_iter().map(|name| &schemas[name]) {
        let tag = schema["discriminator"]["propertyName"].as_str().expect("a tag");
        let mapping = schema["discriminator"]["mapping"].as_object().expect("a mapping");
        let forms = schema["oneOf"].as_array().into_iter().flatten().map(|form| form["$ref"].as_str());
        assert_eq!(mapping.values().map(Value::as_str).collect::<BTreeSet<_>>(), forms.collect());
        for (word, target) in mapping {
            let form = document.pointer(&target.as_str().expect("a reference")[1..]).expect("a form");
            assert_eq!(form["properties"][tag]["enum"], json!([word]));
            assert!(form["required"].as_array().is_some_and(|required| required.contains(&json!(tag))));
        }
    }
    assert!(schemas.contains_key("BekkerLaw") && schemas.contains_key("WongReeceContact"));
}

/// Every number of a request says in which unit it comes.
#[test]
fn every_number_of_a_request_has_a_unit() {
    fn numbers<'a>(document: &'a Value, schema: &'a Value, at: &str, found: &mut Vec<(String, &'a Value)>) {
        if let Some(target) = schema["$ref"].as_str() {
            return numbers(document, document.pointer(&target[1..]).expect("a schema"), at, found);
        }
        let is_number = |kind: &Value| kind == "number" || kind == "integer";
        if is_number(&schema["type"]) || schema["type"].as_array().is_some_and(|types| types.iter().any(is_number)) {
            found.push((at.to_owned(), schema));
        }
        for (name, property) in schema["properties"].as_object().into_iter().flatten() {
            numbers(document, property, &format!("{at}/{name}"), found);
        }
        // Values without the word of their form are those of all forms, whose units may differ.
        let has_word = |option: &&Value| option["$ref"].as_str().is_none_or(|target| !target.ends_with("Values"));
        let options = schema["oneOf"].as_array().into_iter().flatten().filter(has_word);
        options.for_each(|option| numbers(document, option, at, found));
        if schema["items"].is_object() {
            numbers(document, &schema["items"], at, found);
        }
    }
    let document = document();
    let mut found = Vec::new();
    for operation in document["paths"].as_object().expect("paths").values() {
        let schema = &operation["post"]["requestBody"]["content"]["application/json"]["schema"];
        numbers(&document, schema, "", &mut found);
    }
    assert!(found.len() > 200, "{}", found.len());
    // The values of an axis, a variable or a distribution are in the unit of its field, a limit in that of its formula or quantity.
    let of_others = [
        "/conditions/above",
        "/conditions/below",
        "/correlation",
        "/inputs/high",
        "/inputs/low",
        "/inputs/mean",
        "/inputs/mode",
        "/inputs/standard_deviation",
        "/inputs/values",
        "/posterior/correlation",
        "/posterior/estimates/interval_95",
        "/posterior/estimates/model_bias",
        "/posterior/estimates/standard_error",
        "/posterior/estimates/value",
        "/axis/from",
        "/axis/to",
        "/axis/values",
        "/axes/from",
        "/axes/to",
        "/axes/values",
        "/variables/from",
        "/variables/to",
        "/variables/start",
        "/constraints/at_least",
        "/constraints/at_most",
    ];
    for (at, schema) in found.iter().filter(|(at, _)| !of_others.contains(&at.as_str())) {
        let unit = schema["x-unit"].as_str().unwrap_or_else(|| panic!("{at} has no unit"));
        // The ends of a range are in the unit of the range.
        let whole = at.strip_suffix("/from").or_else(|| at.strip_suffix("/to")).unwrap_or(at);
        let name = whole.rsplit('/').next().expect("a name");
        for (ending, own) in
            [("_rad", "rad"), ("_pa", "Pa"), ("_n_m", "N.m"), ("_m_s", "m/s"), ("_rad_s", "rad/s"), ("_n_m3", "N/m3")]
        {
            assert_eq!(name.ends_with(ending), unit == own, "{at} in {unit}");
        }
    }
}
