//! The contract as a document: complete, consistent, committed.

use std::collections::BTreeSet;

use serde_json::{Map, Value, json};

use crate::asking::{get, post, query_of, with};

/// The committed document.
const COMMITTED: &str = include_str!("../../openapi/openapi.json");

pub(crate) fn document() -> Value {
    serde_json::from_str(COMMITTED).expect("the document is JSON")
}

/// All operations, with their own parameters and responses in place of references: path, method, operation.
pub(crate) fn operations(document: &Value) -> Vec<(String, String, Value)> {
    let paths = document["paths"].as_object().expect("paths");
    let of_path = |(path, item): (&String, &Value)| {
        let methods = item.as_object().expect("methods").clone();
        let path = path.clone();
        methods.into_iter().map(move |(method, operation)| (path.clone(), method, resolved(document, operation)))
    };
    paths.iter().flat_map(of_path).collect()
}

fn resolved(document: &Value, mut operation: Value) -> Value {
    let parameters = operation["parameters"].as_array_mut().into_iter().flatten().collect::<Vec<_>>();
    for part in parameters {
        resolve(document, part);
    }
    for part in operation["responses"].as_object_mut().into_iter().flatten().map(|(_, response)| response) {
        resolve(document, part);
    }
    operation
}

/// Puts what a reference leads to in its place.
fn resolve(document: &Value, part: &mut Value) {
    if let Some(target) = part["$ref"].as_str() {
        *part = document.pointer(&target[1..]).expect("a component").clone();
    }
}

/// The path with a name that is there in place of `{id}`.
pub(crate) fn with_a_name(path: &str) -> String {
    let name = match path {
        "/v1/wheels/{id}" => "letter",
        "/v1/soils/{id}" => "letter-sand",
        _ => "ding-2011-smooth",
    };
    path.replace("{id}", name)
}

#[test]
fn the_committed_document_is_the_generated_one() {
    assert!(
        COMMITTED == terramechanics_server::contract().pretty_text(),
        "write it anew: cargo run --release -- openapi > openapi/openapi.json"
    );
    let served = get("/openapi.json");
    assert_eq!(served.ok(), document());
    assert!(!served.text.contains('\n'), "it is served without indentation");
}

/// What several operations say alike stands once, and long lists of names once.
#[test]
fn what_operations_share_stands_once() {
    let document = document();
    let mut failures = BTreeSet::new();
    let mut parameters = BTreeSet::new();
    for operation in
        document["paths"].as_object().expect("paths").values().flat_map(|item| item.as_object().expect("methods").values())
    {
        for (status, response) in operation["responses"].as_object().expect("responses") {
            assert!(status == "200" || response["$ref"].is_string() || failures.insert(response.to_string()), "{response}");
        }
        for parameter in operation["parameters"].as_array().into_iter().flatten() {
            let has_own_value = parameter["example"] != Value::Null;
            assert!(parameter["$ref"].is_string() || has_own_value || parameters.insert(parameter.to_string()), "{parameter}");
        }
    }
    for list in ["WheelPreset", "SoilPreset"] {
        let names = document["components"]["schemas"][list]["enum"].to_string();
        assert!(names.len() > 300 && document.to_string().matches(&names).count() == 1, "{list}");
    }
}

/// A client with little room asks for the operations it uses.
#[test]
fn a_part_of_the_document_stands_alone() {
    let whole = get("/openapi.json").ok();
    let paths = |document: &Value| document["paths"].as_object().expect("paths").keys().cloned().collect::<BTreeSet<_>>();
    let mut together = BTreeSet::new();
    for tag in ["forces", "identification", "catalogue", "operations"] {
        let part = get(&format!("/openapi.json?tags={tag}")).ok();
        assert_eq!(part["tags"].as_array().map(Vec::len), Some(1));
        for (path, item) in part["paths"].as_object().expect("paths") {
            for (method, operation) in item.as_object().expect("methods") {
                assert_eq!(operation, &whole["paths"][path][method]);
                assert_eq!(operation["tags"], json!([tag]));
            }
        }
        assert_references_lead_somewhere(&part);
        assert!(part.to_string().len() < whole.to_string().len() * 3 / 4, "{tag}");
        together.extend(paths(&part));
    }
    assert_eq!(together, paths(&whole));
    assert_eq!(get("/openapi.json?tags=forces,identification,catalogue,operations").ok(), whole);
    let problem = get("/openapi.json?tags=forces,force").problem(422);
    assert_eq!(problem["errors"][0]["pointer"], "/tags/1");
    assert!(problem["errors"][0]["detail"].as_str().is_some_and(|detail| detail.contains("forces")), "{problem}");
}

#[test]
fn the_document_has_the_routes_of_the_api() {
    let document = document();
    assert!(document["openapi"].as_str().is_some_and(|version| version.starts_with("3.1")));
    let routes: BTreeSet<String> =
        operations(&document).into_iter().map(|(path, method, _)| format!("{method} {path}")).collect();
    let expected = [
        "get /healthz",
        "get /metrics",
        "get /openapi.json",
        "get /readyz",
        "get /v1/forces",
        "get /v1/limits",
        "get /v1/model",
        "get /v1/resistances",
        "get /v1/slip-sweep",
        "get /v1/soils",
        "get /v1/soils/{id}",
        "get /v1/stress-profile",
        "get /v1/validation",
        "get /v1/validation/{id}",
        "get /v1/wheels",
        "get /v1/wheels/{id}",
        "post /v1/compare",
        "post /v1/coupled",
        "post /v1/forces",
        "post /v1/identify",
        "post /v1/identify/plates",
        "post /v1/identify/shear",
        "post /v1/resistances",
        "post /v1/slip-sweep",
        "post /v1/stress-profile",
        "post /v1/towed",
        "post /v1/track",
    ];
    assert_eq!(routes, expected.map(str::to_owned).into());
    // A documented path exists: asked with its methods it is neither 404 nor 405; and no other method is.
    for (path, item) in document["paths"].as_object().expect("paths") {
        let path = with_a_name(path);
        for other in ["get", "post", "put", "delete", "patch"] {
            let request = crate::asking::request(&other.to_uppercase(), &path, &[], axum::body::Body::empty());
            let status = crate::asking::send(request).status.as_u16();
            assert_eq!(status == 405, item.get(other).is_none(), "{other} {path}: {status}");
            assert_ne!(status, 404, "{path}");
        }
    }
}

fn assert_references_lead_somewhere(document: &Value) {
    fn references(value: &Value, found: &mut Vec<String>) {
        match value {
            Value::Object(fields) => {
                for (name, value) in fields {
                    match value {
                        Value::String(target) if name == "$ref" => found.push(target.clone()),
                        _ => references(value, found),
                    }
                }
            }
            Value::Array(items) => items.iter().for_each(|item| references(item, found)),
            _ => {}
        }
    }
    let mut found = Vec::new();
    references(document, &mut found);
    assert!(found.len() > 5);
    for target in &found {
        let pointer = target.strip_prefix('#').expect("a reference within the document");
        assert!(document.pointer(pointer).is_some(), "{target}");
    }
    // And no component is there that nothing uses.
    for (kind, components) in document["components"].as_object().expect("components") {
        for name in components.as_object().expect("components").keys() {
            assert!(found.contains(&format!("#/components/{kind}/{name}")), "{name} is not used");
        }
    }
}

#[test]
fn no_reference_dangles() {
    assert_references_lead_somewhere(&document());
}

#[test]
fn every_operation_says_what_it_does_and_how_it_fails() {
    for (path, method, operation) in operations(&document()) {
        let summary = operation["summary"].as_str().unwrap_or("");
        assert!(summary.len() > 5, "{path} has no summary");
        let responses = operation["responses"].as_object().expect("responses");
        let mut expected = vec!["200", "405", "500", "503"];
        match method.as_str() {
            "post" => expected.extend(["400", "408", "413", "415", "422"]),
            // A query is refused where it has no effect as well.
            _ if path.contains("{id}") => expected.extend(["404", "422"]),
            _ if path.starts_with("/v1/") || path == "/openapi.json" => expected.push("422"),
            _ => {}
        }
        assert_eq!(responses.keys().map(String::as_str).collect::<BTreeSet<_>>(), expected.into_iter().collect(), "{path}");
        for (status, response) in responses {
            assert!(response["description"].as_str().is_some_and(|text| !text.is_empty()), "{path} {status}");
            let types = response["content"].as_object().expect("content");
            if status == "200" {
                assert!(types.values().all(|content| content.get("schema").is_some()), "{path}");
            } else {
                assert_eq!(types.keys().collect::<Vec<_>>(), ["application/problem+json"], "{path} {status}");
            }
        }
    }
}

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
        schema["oneOf"].as_array().into_iter().flatten().for_each(|option| numbers(document, option, at, found));
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
    for (at, schema) in &found {
        let unit = schema["x-unit"].as_str().unwrap_or_else(|| panic!("{at} has no unit"));
        let name = at.rsplit('/').next().expect("a name");
        for (ending, own) in
            [("_rad", "rad"), ("_pa", "Pa"), ("_n_m", "N.m"), ("_m_s", "m/s"), ("_rad_s", "rad/s"), ("_n_m3", "N/m3")]
        {
            assert_eq!(name.ends_with(ending), unit == own, "{at} in {unit}");
        }
    }
}
