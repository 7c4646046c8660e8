//! Asking the service and reading its answers.

use std::io::Read;

use axum::body::{Body, to_bytes};
use axum::http::response::Parts;
use axum::http::{HeaderMap, Request, StatusCode};
use serde_json::{Value, json};
use terramechanics_server::{Limits, Service, app};
use tower::ServiceExt;

use crate::sentences::assert_told;

/// What two ways to one number may differ by, relative to it or, for one below 1 in SI units, by itself: searches of one sinkage
/// that start elsewhere, and closed forms of one row and of eight at a time.
pub(crate) const ROUNDING: f64 = 1e-12;

/// Whether two ways lead to one number, or both to none.
pub(crate) fn same_but_for_rounding(one: &Value, other: &Value) -> bool {
    match (one.as_f64(), other.as_f64()) {
        (Some(one), Some(other)) => (one - other).abs() <= ROUNDING * other.abs().max(1.0),
        _ => one == other,
    }
}

/// An answer of the service.
#[derive(Debug)]
pub(crate) struct Answer {
    pub(crate) status: StatusCode,
    pub(crate) headers: HeaderMap,
    pub(crate) text: String,
}

impl Answer {
    /// The body as JSON.
    pub(crate) fn json(&self) -> Value {
        serde_json::from_str(&self.text).unwrap_or_else(|error| panic!("{error}: {}", self.text))
    }

    pub(crate) fn header(&self, name: &str) -> &str {
        self.headers.get(name).map_or("", |value| value.to_str().expect("a header of text"))
    }

    /// The body of a 200, whose warnings are told as they have to be.
    pub(crate) fn ok(&self) -> Value {
        assert_eq!(self.status, StatusCode::OK, "{}", self.text);
        let reply = self.json();
        assert_told(&reply);
        reply
    }

    /// The body of a failure, which has to be a problem document of that status.
    pub(crate) fn problem(&self, status: u16) -> Value {
        assert_eq!(self.status.as_u16(), status, "{}", self.text);
        assert_eq!(self.header("content-type"), "application/problem+json");
        assert!(!self.header("x-request-id").is_empty());
        let problem = self.json();
        assert_eq!(problem["status"], status);
        for member in ["type", "title", "detail"] {
            assert!(problem[member].as_str().is_some_and(|text| !text.is_empty()), "{member} in {problem}");
        }
        problem
    }

    /// The JSON pointers of a 422.
    pub(crate) fn pointers(&self) -> Vec<String> {
        let problem = self.problem(422);
        let errors = problem["errors"].as_array().expect("errors");
        errors.iter().map(|error| error["pointer"].as_str().expect("a pointer").to_owned()).collect()
    }

    /// The codes of the warnings of a 200.
    pub(crate) fn warned_of(&self) -> Vec<String> {
        let reply = self.ok();
        let warnings = reply["warnings"].as_array().expect("warnings");
        warnings.iter().map(|warning| warning["code"].as_str().expect("a code").to_owned()).collect()
    }

    /// What the 422 says of a pointer.
    pub(crate) fn fault(&self, pointer: &str) -> String {
        let problem = self.problem(422);
        let errors = problem["errors"].as_array().expect("errors");
        let fault = errors.iter().find(|error| error["pointer"] == pointer);
        fault.unwrap_or_else(|| panic!("no fault of {pointer} in {problem}"))["detail"].as_str().expect("a detail").to_owned()
    }
}

/// Sends a request to a service of its own.
pub(crate) fn send(request: Request<Body>) -> Answer {
    send_to(Service::new(Limits::default()), request)
}

pub(crate) fn send_to(service: Service, request: Request<Body>) -> Answer {
    let (parts, bytes) = parts_of(service, request);
    Answer { status: parts.status, headers: parts.headers, text: String::from_utf8(bytes).expect("text") }
}

/// An answer whose body was packed.
pub(crate) fn send_unpacking(request: Request<Body>) -> (Answer, usize) {
    let (parts, bytes) = parts_of(Service::new(Limits::default()), request);
    let mut text = String::new();
    flate2::read::GzDecoder::new(bytes.as_slice()).read_to_string(&mut text).expect("gzip");
    (Answer { status: parts.status, headers: parts.headers, text }, bytes.len())
}

fn parts_of(service: Service, request: Request<Body>) -> (Parts, Vec<u8>) {
    runtime().block_on(async {
        let response = app(service).oneshot(request).await.expect("the service always answers");
        let (parts, body) = response.into_parts();
        (parts, to_bytes(body, usize::MAX).await.expect("a body").to_vec())
    })
}

pub(crate) fn runtime() -> tokio::runtime::Runtime {
    tokio::runtime::Builder::new_current_thread().enable_all().build().expect("a runtime")
}

pub(crate) fn request(method: &str, path: &str, headers: &[(&str, &str)], body: impl Into<Body>) -> Request<Body> {
    let builder = Request::builder().method(method).uri(path).header("host", "test");
    let builder = headers.iter().fold(builder, |builder, (name, value)| builder.header(*name, *value));
    builder.body(body.into()).expect("a request")
}

pub(crate) fn get(path: &str) -> Answer {
    send(request("GET", path, &[], Body::empty()))
}

pub(crate) fn post(path: &str, body: &Value) -> Answer {
    post_text(path, body.to_string())
}

/// The bodies of the 200s to many requests, all to one service.
pub(crate) fn post_all(path: &str, bodies: impl Iterator<Item = Value>) -> Vec<Value> {
    let router = app(Service::new(Limits::default()));
    runtime().block_on(async {
        let mut replies = Vec::new();
        for body in bodies {
            let request = request("POST", path, &[("content-type", "application/json")], body.to_string());
            let response = router.clone().oneshot(request).await.expect("the service always answers");
            assert_eq!(response.status(), StatusCode::OK, "{body}");
            let bytes = to_bytes(response.into_body(), usize::MAX).await.expect("a body");
            replies.push(serde_json::from_slice(&bytes).expect("JSON"));
        }
        replies
    })
}

pub(crate) fn post_text(path: &str, body: impl Into<Body>) -> Answer {
    send(request("POST", path, &[("content-type", "application/json")], body))
}

pub(crate) fn post_for_csv(path: &str, body: &Value) -> Answer {
    send(request("POST", path, &[("content-type", "application/json"), ("accept", "text/csv")], body.to_string()))
}

/// `base` with some fields replaced or added; a null takes a field away.
pub(crate) fn with(base: &Value, changes: Value) -> Value {
    let (Value::Object(mut fields), Value::Object(changes)) = (base.clone(), changes) else { panic!("objects") };
    for (name, change) in changes {
        match (fields.get(&name), change) {
            (_, Value::Null) => {
                fields.remove(&name);
            }
            (Some(old @ Value::Object(_)), change @ Value::Object(_)) => {
                let merged = with(old, change);
                fields.insert(name, merged);
            }
            (_, change) => {
                fields.insert(name, change);
            }
        }
    }
    Value::Object(fields)
}

/// The letter's own example (its Fig. 1b), spelled out.
pub(crate) fn letter() -> Value {
    json!({
        "wheel": {"radius_m": 0.2, "width_m": 0.1},
        "soil": {
            "cohesion_pa": 0, "friction_angle_rad": 0.478, "shear_modulus_m": 0.005,
            "pressure_sinkage": {"law": "bekker", "k_c": -660, "k_phi": 754_130, "n0": 0.91}
        },
        "slip": 0.2, "sinkage_m": 0.02
    })
}

/// The columns of a table by name; empty cells are none.
pub(crate) fn table(text: &str) -> Vec<(String, Vec<Option<f64>>)> {
    let mut lines = text.lines();
    let names: Vec<&str> = lines.next().expect("a header").split(',').collect();
    let mut columns: Vec<(String, Vec<Option<f64>>)> = names.iter().map(|name| ((*name).to_owned(), Vec::new())).collect();
    for line in lines {
        let cells: Vec<&str> = line.split(',').collect();
        assert_eq!(cells.len(), columns.len(), "{line}");
        for ((_, column), cell) in columns.iter_mut().zip(cells) {
            column.push(if cell.is_empty() { None } else { Some(cell.parse().expect("a number")) });
        }
    }
    columns
}

/// A body as a query with dotted names.
pub(crate) fn query_of(body: &Value) -> String {
    fn add(value: &Value, name: &str, pairs: &mut Vec<String>) {
        match value {
            Value::Object(fields) => {
                let around = if name.is_empty() { String::new() } else { format!("{name}.") };
                fields.iter().for_each(|(field, value)| add(value, &format!("{around}{field}"), pairs));
            }
            Value::String(text) => pairs.push(format!("{name}={text}")),
            other => pairs.push(format!("{name}={other}")),
        }
    }
    let mut pairs = Vec::new();
    add(body, "", &mut pairs);
    pairs.join("&")
}
