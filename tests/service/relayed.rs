//! Streams that come by a proxy, which may stop to send once an answer begins: the answer waits for the whole body.

use std::time::Duration;

use axum::body::Body;
use axum::http::{Request, StatusCode, Version};
use http_body_util::{BodyExt, channel};
use terramechanics_server::{Begin, Limits, Service, app};
use tower::ServiceExt;

use crate::asking::{request, runtime, send_to};
use crate::track::{path, settings};

/// Whether an answer to a table begins before its body has ended, and the whole of it.
fn answered(limits: Limits, path: &str, version: Version, headers: &[(&str, &str)]) -> (bool, String) {
    runtime().block_on(async {
        let (mut sender, body) = channel::Channel::<axum::body::Bytes, std::io::Error>::new(1);
        let mut request = Request::post(path).version(version).header("host", "test").header("content-type", "text/csv");
        for (name, value) in headers {
            request = request.header(*name, *value);
        }
        let request = request.body(Body::new(body)).expect("a request");
        let answer = tokio::spawn(app(Service::new(limits)).oneshot(request));
        sender.send_data("time_s,slip\n0,0.1\n".into()).await.expect("room");
        // An answer that begins does so within milliseconds; one that begins later than this is taken for one that waits.
        tokio::time::sleep(Duration::from_millis(300)).await;
        let is_early = answer.is_finished();
        sender.send_data("1,0.2\n".into()).await.expect("room");
        drop(sender);
        let response = answer.await.expect("no panic").expect("an answer");
        assert_eq!(response.status(), StatusCode::OK);
        assert_eq!(response.headers()["x-accel-buffering"], "no");
        let text = response.into_body().collect().await.expect("a body").to_bytes();
        (is_early, String::from_utf8(text.to_vec()).expect("text"))
    })
}

#[test]
fn a_table_that_a_proxy_passes_on_is_answered_when_it_has_ended() {
    let (path, limits) = (path(&settings()), Limits::default());
    let (is_early, direct) = answered(limits, &path, Version::HTTP_11, &[]);
    assert!(is_early && direct.ends_with("#end,2\n"), "{direct}");
    for (version, headers) in [
        (Version::HTTP_10, &[][..]),
        (Version::HTTP_11, &[("via", "1.1 proxy")]),
        (Version::HTTP_11, &[("x-forwarded-for", "192.0.2.7")]),
        (Version::HTTP_11, &[("content-length", "24")]),
    ] {
        assert_eq!(answered(limits, &path, version, headers), (false, direct.clone()), "{version:?} {headers:?}");
    }
}

#[test]
fn a_setting_says_when_answers_begin() {
    let path = path(&settings());
    let (early, after) = (
        Limits { stream_begin: Begin::Early, ..Limits::default() },
        Limits { stream_begin: Begin::AfterBody, ..Limits::default() },
    );
    assert!(answered(early, &path, Version::HTTP_11, &[("via", "1.1 proxy")]).0);
    assert!(!answered(after, &path, Version::HTTP_11, &[]).0);
}

#[test]
fn a_batch_waits_as_well() {
    let path = "/v1/batch?wheel.preset=letter&soil.preset=letter-sand&slip=0.2";
    let texts = [&[][..], &[("via", "1.1 proxy")]].map(|signs| {
        let headers = [&[("content-type", "text/csv")], signs].concat();
        let answer = send_to(Service::new(Limits::default()), request("POST", path, &headers, "sinkage_m\n0.01\n0.02\n"));
        assert_eq!(answer.status, StatusCode::OK);
        answer.text
    });
    assert!(texts[0] == texts[1] && texts[0].ends_with("#end,2\n"), "{texts:?}");
}

#[test]
fn a_table_that_is_too_large_to_keep_is_refused() {
    let limits = Limits { spool: 1000, ..Limits::default() };
    let mut table = String::from("time_s,slip\n");
    for i in 0..200 {
        table.push_str(&format!("{i},0.1\n"));
    }
    let headers = [("content-type", "text/csv"), ("via", "1.1 proxy")];
    let question = request("POST", &path(&settings()), &headers, table);
    let problem = send_to(Service::new(limits), question).problem(413);
    assert!(problem["detail"].as_str().is_some_and(|detail| detail.contains("1000 bytes")), "{problem}");
}
