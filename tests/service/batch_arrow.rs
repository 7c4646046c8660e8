//! `/v1/batch` as an Arrow stream, and from one form to another.

use std::io::Write;
use std::sync::Arc;

use arrow_array::cast::AsArray;
use arrow_array::types::{Float64Type, Int32Type, Int64Type};
use arrow_array::{ArrayRef, DictionaryArray, Float64Array, Int64Array, RecordBatch, StringArray};
use arrow_ipc::reader::StreamReader;
use arrow_ipc::writer::StreamWriter;
use axum::body::Body;
use http_body_util::BodyExt;
use serde_json::json;
use terramechanics_server::{Limits, Service, app};
use tower::ServiceExt;

use crate::asking::{letter, post, request, runtime, with};
use crate::batch::{CSV, batch, points, rows_of, single, table_of};

const ARROW: &str = "application/vnd.apache.arrow.stream";

/// The answer to a batch: status, media type and bytes; none where it broke off.
fn asked(query: &str, headers: &[(&str, &str)], body: Vec<u8>) -> (u16, String, Option<Vec<u8>>) {
    runtime().block_on(async {
        let request = request("POST", &format!("/v1/batch?{query}"), headers, Body::from(body));
        let response = app(Service::new(Limits::default())).oneshot(request).await.expect("an answer");
        let kind = response.headers()["content-type"].to_str().expect("text").to_owned();
        let status = response.status().as_u16();
        (status, kind, response.into_body().collect().await.ok().map(|body| body.to_bytes().to_vec()))
    })
}

fn stream(batches: &[RecordBatch]) -> Vec<u8> {
    let mut writer = StreamWriter::try_new(Vec::new(), &batches[0].schema()).expect("a schema");
    batches.iter().for_each(|batch| writer.write(batch).expect("memory"));
    writer.into_inner().expect("memory")
}

fn batch_of(columns: Vec<(&str, ArrayRef)>) -> RecordBatch {
    RecordBatch::try_from_iter_with_nullable(columns.into_iter().map(|(name, array)| (name, array, true))).expect("columns")
}

fn read(bytes: &[u8]) -> Vec<RecordBatch> {
    StreamReader::try_new(bytes, None).expect("a stream").collect::<Result<_, _>>().expect("batches")
}

/// The numbers and words of a column of all batches.
fn numbers(batches: &[RecordBatch], name: &str) -> Vec<Option<u64>> {
    let of = |batch: &RecordBatch| batch.column_by_name(name).expect("a column").as_primitive::<Float64Type>().clone();
    batches.iter().flat_map(|batch| of(batch).iter().map(|value| value.map(f64::to_bits)).collect::<Vec<_>>()).collect()
}

fn words(batches: &[RecordBatch], name: &str) -> Vec<String> {
    let of = |batch: &RecordBatch| batch.column_by_name(name).expect("a column").as_string::<i32>().clone();
    batches.iter().flat_map(|batch| of(batch).iter().flatten().map(str::to_owned).collect::<Vec<_>>()).collect()
}

#[test]
fn rows_of_arrow_are_what_forces_gives_bit_for_bit() {
    let slips = [0.1, 0.2, 0.3, 0.4];
    let presets: DictionaryArray<Int32Type> =
        ["letter-sand", "wong-dry-sand", "letter-sand", "letter-sand"].into_iter().collect();
    let methods = StringArray::from(vec![Some("explicit"), None, Some("linearised"), Some("quadrature")]);
    let loads = Float64Array::from(vec![Some(80.0), Some(90.0), None, Some(-1.0)]);
    let sinkages = Float64Array::from(vec![None, None, Some(0.02), None]);
    let rows = batch_of(vec![
        ("id", Arc::new(Int64Array::from(vec![9_007_199_254_740_993, 2, 3, 4]))),
        ("slip", Arc::new(Float64Array::from(slips.to_vec()))),
        ("soil.preset", Arc::new(presets)),
        ("method", Arc::new(methods)),
        ("normal_load_n", Arc::new(loads)),
        ("sinkage_m", Arc::new(sinkages)),
    ]);
    // Several batches of one stream; what is repeated as it came is of one array each.
    let body = stream(&[rows.slice(0, 3), rows.slice(3, 1)]);
    let (status, kind, answer) = asked("wheel.preset=letter&echo=id", &[("content-type", ARROW)], body);
    assert_eq!((status, kind.as_str()), (200, ARROW));
    let answer = read(&answer.expect("the whole answer"));
    assert_eq!(answer.last().map(RecordBatch::num_rows), Some(0), "a whole answer ends with an empty batch");
    let ids = answer.iter().flat_map(|batch| batch["id"].as_primitive::<Int64Type>().values().to_vec()).collect::<Vec<_>>();
    assert_eq!(ids, [9_007_199_254_740_993, 2, 3, 4], "all digits are there");
    let statuses = words(&answer, "status");
    assert!(statuses[..3].iter().all(|status| status == "ok"), "{statuses:?}");
    assert!(statuses[3].starts_with("invalid: /normal_load_n must be from "), "{statuses:?}");
    let preset = |id: &str| json!({"wheel": {"preset": "letter"}, "soil": {"preset": id}});
    let bodies = [
        with(&preset("letter-sand"), json!({"slip": 0.1, "method": "explicit", "normal_load_n": 80})),
        with(&preset("wong-dry-sand"), json!({"slip": 0.2, "normal_load_n": 90})),
        with(&preset("letter-sand"), json!({"slip": 0.3, "method": "linearised", "sinkage_m": 0.02})),
    ];
    for name in ["longitudinal_force_n", "normal_force_n", "torque_n_m", "traction_n", "sinkage_m", "tractive_efficiency"] {
        let found = numbers(&answer, name);
        for (body, found) in bodies.iter().zip(&found) {
            assert_eq!(*found, single(&post("/v1/forces", body).ok(), name), "{name}");
        }
        assert_eq!(found[3], None);
    }
}

#[test]
fn a_form_becomes_another() {
    let bodies: Vec<_> = points().into_iter().filter(|body| body["slip_angle_rad"].is_null()).collect();
    let table = table_of(&bodies);
    let (plain, _) = rows_of(&batch("", CSV, table.clone()).text);
    let (status, _, arrow) = asked("", &[("content-type", CSV), ("accept", ARROW)], table.into_bytes());
    assert_eq!(status, 200);
    let arrow = read(&arrow.expect("the whole answer"));
    for name in ["torque_n_m", "drawbar_coefficient"] {
        let cells: Vec<_> = plain.iter().map(|row| row[name].parse::<f64>().ok().map(f64::to_bits)).collect();
        assert_eq!(numbers(&arrow, name), cells);
    }
    let slips = batch_of(vec![("slip", Arc::new(Float64Array::from(vec![0.1, 0.2])))]);
    let query = "wheel.preset=letter&soil.preset=letter-sand&sinkage_m=0.02&echo=slip";
    let (_, kind, text) = asked(query, &[("content-type", ARROW), ("accept", CSV)], stream(&[slips]));
    assert!(kind.starts_with(CSV));
    let (rows, comments) = rows_of(&String::from_utf8(text.expect("a body")).expect("text"));
    let alone = post(
        "/v1/forces",
        &json!({"wheel": {"preset": "letter"}, "soil": {"preset": "letter-sand"}, "slip": 0.2, "sinkage_m": 0.02}),
    );
    assert_eq!(rows[1]["torque_n_m"].parse::<f64>().ok().map(f64::to_bits), single(&alone.ok(), "torque_n_m"));
    assert_eq!(comments.last().map(String::as_str), Some("#end,2"));
}

#[test]
fn packed_bodies_are_unpacked() {
    let table = table_of(&[letter()]);
    let plain = batch("", CSV, table.clone()).text;
    let mut gzip = flate2::write::GzEncoder::new(Vec::new(), flate2::Compression::default());
    gzip.write_all(table.as_bytes()).expect("memory");
    let zstd = zstd::encode_all(table.as_bytes(), 3).expect("memory");
    for (coding, body) in [("gzip", gzip.finish().expect("memory")), ("zstd", zstd)] {
        let (_, _, text) = asked("", &[("content-type", CSV), ("content-encoding", coding)], body);
        assert_eq!(text.expect("a body"), plain.as_bytes(), "{coding}");
    }
}

#[test]
fn a_stream_that_cannot_be_read_is_refused_or_breaks_off() {
    let query = "wheel.preset=letter&soil.preset=letter-sand&sinkage_m=0.02&method=explicit";
    let of = |body: Vec<u8>| asked(query, &[("content-type", ARROW)], body);
    let slips = |rows: usize| batch_of(vec![("slip", Arc::new(Float64Array::from(vec![0.1; rows])))]);
    for body in [Vec::new(), b"slip\n0.1\n".to_vec(), stream(&[slips(0)]), stream(&[slips(3)])[..300].to_vec()] {
        assert_eq!(of(body).0, 400);
    }
    let large = of(stream(&[slips(3 << 20)]));
    assert!(large.0 == 400 && String::from_utf8_lossy(&large.2.expect("a problem")).contains("at most 16 MiB"));
    let odd = batch_of(vec![("slip", Arc::new(arrow_array::Date32Array::from(vec![1])))]);
    assert_eq!(of(stream(&[odd])).0, 422);
    let texts = batch_of(vec![("slip", Arc::new(StringArray::from(vec!["0.1"])))]);
    let (status, _, told) = of(stream(&[texts]));
    let told = String::from_utf8(told.expect("a problem")).expect("text");
    assert!(
        status == 422 && told.contains("/slip: must be a column of numbers (integers, Float32 or Float64), not of texts"),
        "{told}"
    );
    // Written by pyarrow 26.
    let (status, _, told) =
        asked("wheel.preset=letter&sinkage_m=0.02", &[("content-type", ARROW)], include_bytes!("batch_zstd.arrows").to_vec());
    let told = String::from_utf8(told.expect("a problem")).expect("text");
    assert!(status == 400 && told.contains("write them without compression") && told.contains("Content-Encoding"), "{told}");
    // What is wrong behind rows that were answered breaks the answer off, which has no place for words.
    let mut cut = stream(&[slips(9000)]);
    cut.truncate(cut.len() - 8);
    cut.extend([0xff; 40]);
    let (status, _, answer) = of(cut);
    assert_eq!((status, answer), (200, None));
}

/// Whatever is sent is answered or refused.
#[test]
fn damaged_streams_are_no_fault_of_the_service() {
    let names = StringArray::from(vec!["letter-sand", "wong-dry-sand"]);
    let words: DictionaryArray<Int32Type> = ["explicit", "linearised"].into_iter().collect();
    let columns: Vec<(&str, ArrayRef)> = vec![
        ("slip", Arc::new(Float64Array::from(vec![Some(0.1), None]))),
        ("soil.preset", Arc::new(names)),
        ("method", Arc::new(words)),
    ];
    let whole = stream(&[batch_of(columns)]);
    let mut state = 7_u64;
    let mut random = |below: usize| {
        state = state.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        (state >> 33) as usize % below
    };
    for _ in 0..400 {
        let mut body = whole.clone();
        for _ in 0..=random(3) {
            let at = random(body.len());
            body[at] = [0, 1, 0x7f, 0x80, 0xff, random(256) as u8][random(6)];
        }
        let (status, ..) = asked("wheel.preset=letter&sinkage_m=0.02", &[("content-type", ARROW)], body.clone());
        assert!([200, 400, 422].contains(&status), "{status}: {body:?}");
    }
}
