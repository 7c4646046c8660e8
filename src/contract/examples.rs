//! Examples for the contract: requests as a user would send them, and what the service answers.
//!
//! Numbers of replies are rounded, so that the document does not depend on the last bit of a machine's library.

use serde::Serialize;
use serde_json::Value;
use utoipa::openapi::path::{Operation, ParameterBuilder};
use utoipa::openapi::{OpenApi, RefOr};

use crate::quantity::csv;
use crate::reply::Reply;

/// Digits kept of a number in an example.
const DIGITS: i32 = 6;

const JSON: &str = "application/json";

/// What the contract shows of a path.
pub(crate) struct Shown {
    pub(crate) path: String,
    /// It takes a while to compute.
    pub(crate) example: fn() -> Example,
}

/// A request and what the service answers.
pub(crate) struct Example {
    /// The body; none of an operation that has none.
    pub(crate) request: Option<Value>,
    /// Media type and text of the answer in each of its forms.
    pub(crate) replies: Vec<(&'static str, Value)>,
}

impl Example {
    /// A reply to a request without a body, as JSON.
    pub(crate) fn of_json<T: Serialize>(reply: &T) -> Self {
        Self { request: None, replies: vec![(JSON, serde_json::to_value(reply).unwrap_or_default())] }
    }

    /// A reply as JSON and as a table.
    pub(crate) fn replies_of<T: Reply>(reply: &T) -> Vec<(&'static str, Value)> {
        let columns: Vec<(_, Vec<f64>)> =
            reply.columns().into_iter().map(|(name, column)| (name, column.iter().copied().map(rounded).collect())).collect();
        let table: Vec<_> = columns.iter().map(|(name, column)| (name.clone(), column.as_slice())).collect();
        let json = serde_json::to_value(reply).map(with_rounded_numbers).unwrap_or_default();
        vec![(JSON, json), ("text/csv", String::from_utf8(csv(&table)).unwrap_or_default().into())]
    }
}

/// A reply in each of the forms of a series: as JSON, as a table and as an object a line.
pub(crate) fn replies_of_texts(json: Option<Value>, table: &str, objects: &str) -> Vec<(&'static str, Value)> {
    let rounded_cell = |cell: &str| cell.parse().map_or_else(|_| cell.to_owned(), |value: f64| format!("{:?}", rounded(value)));
    let rounded_line = |line: &str| match line.strip_prefix('#') {
        Some(_) => line.to_owned(),
        None => line.split(',').map(rounded_cell).collect::<Vec<_>>().join(","),
    };
    let rounded_object = |line: &str| serde_json::from_str(line).map(with_rounded_numbers).unwrap_or_default().to_string();
    let lines =
        |text: &str, rounded: &dyn Fn(&str) -> String| -> String { text.lines().map(|line| rounded(line) + "\n").collect() };
    vec![
        (JSON, json.map(with_rounded_numbers).unwrap_or_default()),
        ("text/csv", lines(table, &rounded_line).into()),
        ("application/x-ndjson", lines(objects, &rounded_object).into()),
    ]
}

/// Puts at every path what is shown of it: the body at the request, its fields at the parameters of a twin, the answer at both.
pub(crate) fn attach(document: &mut OpenApi, shown: &[Shown]) {
    for Shown { path, example } in shown {
        let Some(item) = document.paths.paths.get_mut(path) else { continue };
        let Example { request, replies } = example();
        if let (Some(operation), Some(request)) = (&mut item.post, &request) {
            set_body(operation, request);
        }
        if let (Some(twin), Some(request)) = (&mut item.get, &request) {
            set_parameters(twin, request);
        }
        for operation in [&mut item.post, &mut item.get].into_iter().flatten() {
            for (media_type, example) in &replies {
                set_reply(operation, media_type, example.clone());
            }
        }
    }
}

fn set_body(operation: &mut Operation, body: &Value) {
    if let Some(RefOr::T(of_body)) = operation.request_body.as_mut()
        && let Some(RefOr::T(content)) = of_body.content.get_mut(JSON)
    {
        content.example = Some(body.clone());
    }
}

fn set_reply(operation: &mut Operation, media_type: &str, example: Value) {
    if let Some(RefOr::T(response)) = operation.responses.responses.get_mut("200")
        && let Some(RefOr::T(content)) = response.content.get_mut(media_type)
    {
        content.example = Some(example);
    }
}

/// Puts what the example of a body has at the parameters of its twin.
fn set_parameters(operation: &mut Operation, body: &Value) {
    for parameter in operation.parameters.iter_mut().flatten() {
        let RefOr::T(parameter) = parameter else { continue };
        let pointer = format!("/{}", parameter.name.replace('.', "/"));
        if let Some(value) = body.pointer(&pointer) {
            *parameter = ParameterBuilder::from(parameter.clone()).example(Some(value.clone())).build();
        }
    }
}

/// A number with as many digits as an example keeps.
fn rounded(value: f64) -> f64 {
    format!("{value:.*e}", DIGITS as usize - 1).parse().unwrap_or(value)
}

/// A value with its numbers rounded.
fn with_rounded_numbers(value: Value) -> Value {
    match value {
        Value::Number(number) if number.is_f64() => number.as_f64().map_or(Value::Null, |number| rounded(number).into()),
        Value::Array(items) => items.into_iter().map(with_rounded_numbers).collect(),
        Value::Object(fields) => fields.into_iter().map(|(name, value)| (name, with_rounded_numbers(value))).collect(),
        other => other,
    }
}
