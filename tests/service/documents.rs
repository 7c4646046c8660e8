//! The contract as a document: complete, consistent, committed.

use std::collections::BTreeSet;

use serde_json::{Value, json};

use crate::asking::get;

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

pub(crate) fn resolved(document: &Value, mut operation: Value) -> Value {
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
        "/problems/{name}" => "busy",
        _ => "ding-2011-smooth",
    };
    path.replace("{id}", name).replace("{name}", name)
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
        "get /problems",
        "get /problems/{name}",
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
        "get /v1/vehicle",
        "get /v1/wheels",
        "get /v1/wheels/{id}",
        "post /v1/batch",
        "post /v1/compare",
        "post /v1/coupled",
        "post /v1/forces",
        "post /v1/identify",
        "post /v1/identify/plates",
        "post /v1/identify/shear",
        "post /v1/optimum",
        "post /v1/resistances",
        "post /v1/slip-sweep",
        "post /v1/stress-profile",
        "post /v1/sweep",
        "post /v1/towed",
        "post /v1/track",
        "post /v1/uncertainty",
        "post /v1/vehicle",
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
            // The rows of a batch are answered while they arrive, however many there are.
            "post" if path == "/v1/batch" => expected.extend(["400", "408", "415", "422"]),
            "post" => expected.extend(["400", "408", "413", "415", "422"]),
            // A query is refused where it has no effect as well.
            _ if path.contains('{') => expected.extend(["404", "422"]),
            _ if path.starts_with("/v1/") || ["/openapi.json", "/problems"].contains(&path.as_str()) => expected.push("422"),
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
