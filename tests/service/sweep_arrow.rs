//! `/v1/sweep` as an Arrow stream, and in blocks that several threads compute.

use std::collections::BTreeSet;

use arrow_array::RecordBatch;
use arrow_array::cast::AsArray;
use arrow_array::types::Float64Type;
use arrow_ipc::reader::StreamReader;
use axum::body::Body;
use http_body_util::BodyExt;
use serde_json::{Value, json};
use terramechanics_server::{Limits, Service, app};
use tower::ServiceExt;

use crate::asking::{letter, post, request, runtime, with};

const ARROW: &str = "application/vnd.apache.arrow.stream";

/// The answer in a form that is preferred to JSON: its type and its bytes.
fn asked(body: &Value, accept: &str) -> (String, Vec<u8>) {
    runtime().block_on(async {
        let headers = [("content-type", "application/json"), ("accept", accept)];
        let request = request("POST", "/v1/sweep", &headers, Body::from(body.to_string()));
        let response = app(Service::new(Limits::default())).oneshot(request).await.expect("an answer");
        assert_eq!(response.status().as_u16(), 200);
        let kind = response.headers()["content-type"].to_str().expect("text").to_owned();
        (kind, response.into_body().collect().await.expect("the whole answer").to_bytes().to_vec())
    })
}

/// Some thousand points, of which some have no answer and some make no request.
fn grid() -> Value {
    let axes = json!([
        {"field": "/wheel/radius_m", "from": 0.1, "to": 0.2, "points": 41},
        {"field": "/sinkage_m", "from": 0.01, "to": 0.15, "points": 61}
    ]);
    json!({"of": "forces", "request": with(&letter(), json!({"method": "explicit"})), "axes": axes})
}

#[test]
fn a_stream_of_record_batches_has_the_rows_of_the_columns() {
    let columns = post("/v1/sweep", &grid()).ok()["columns"].clone();
    let (kind, bytes) = asked(&grid(), &format!("{ARROW}, application/json;q=0.5"));
    assert_eq!(kind, ARROW);
    let batches: Vec<RecordBatch> =
        StreamReader::try_new(&bytes[..], None).expect("a stream").collect::<Result<_, _>>().expect("batches");
    assert_eq!(batches.last().map(RecordBatch::num_rows), Some(0), "a whole answer ends with an empty batch");
    assert!(batches.len() > 3, "several blocks");
    let columns = columns.as_object().expect("columns");
    let schema = batches[0].schema();
    let names: BTreeSet<&String> = schema.fields().iter().map(|field| field.name()).collect();
    assert_eq!(names, columns.keys().collect());
    for (name, column) in columns {
        let column = column.as_array().expect("a column");
        let of = |batch: &RecordBatch| -> Vec<Value> {
            let array = &batch[name.as_str()];
            if name == "status" {
                return array.as_string::<i32>().iter().map(|word| json!(word)).collect();
            }
            array.as_primitive::<Float64Type>().iter().map(|number| json!(number)).collect()
        };
        let found: Vec<Value> = batches.iter().flat_map(of).collect();
        assert_eq!(&found, column, "{name}");
    }
    assert!(columns["status"].as_array().is_some_and(|all| all.contains(&json!("ok")) && all.contains(&json!("invalid"))));
}

/// What is said of a block comes behind what was said of those before, as if all rows were one.
#[test]
fn rows_and_warnings_of_blocks_are_those_of_the_whole() {
    let whole = post("/v1/sweep", &grid()).ok();
    let (_, bytes) = asked(&grid(), "application/x-ndjson");
    let text = String::from_utf8(bytes).expect("text");
    let lines: Vec<Value> = text.lines().map(|line| serde_json::from_str(line).expect("JSON")).collect();
    let (end, rows) = lines.split_last().expect("an end");
    assert_eq!((&end["end"], &end["rows"], &end["warnings"]), (&json!(true), &json!(rows.len()), &whole["warnings"]));
    for (i, row) in rows.iter().enumerate() {
        for (name, value) in row.as_object().expect("a row") {
            assert_eq!(value, &whole["columns"][name][i], "{name} of row {i}");
        }
    }
}
