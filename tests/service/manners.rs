//! Answers that a client has already, answers that are packed, and pages of other origins.

use std::io::Read;

use axum::body::{Body, to_bytes};
use axum::http::{Request, Response};
use serde_json::json;
use terramechanics_server::{Limits, Outside, Service, app};
use tower::ServiceExt;

use crate::asking::{get, request, runtime, send, send_to};

const FORCES: &str = "/v1/forces?wheel.preset=letter&soil.preset=letter-sand&slip=0.2&normal_load_n=50";
const SWEEP: &str = "/v1/slip-sweep?wheel.preset=letter&soil.preset=letter-sand&normal_load_n=50&method=linearised&slip.from=0&slip.to=1&slip.points=201";

fn asked(path: &str, headers: &[(&str, &str)]) -> crate::asking::Answer {
    send(request("GET", path, headers, Body::empty()))
}

#[test]
fn an_answer_that_a_client_has_is_not_sent_again() {
    for path in
        [FORCES, SWEEP, "/v1/soils", "/v1/soils/letter-sand", "/v1/model", "/v1/limits", "/v1/validation/ding-2011-smooth"]
    {
        let first = get(path);
        let tag = first.header("etag");
        assert!(tag.starts_with('"') && tag.len() > 10, "{path}: {tag}");
        assert_eq!(first.header("cache-control"), "no-cache");
        assert!(first.header("vary").contains("accept-encoding"), "{path}");
        for known in [tag.to_owned(), format!("W/{tag}"), format!("\"other\", {tag}")] {
            let again = asked(path, &[("if-none-match", &known)]);
            assert_eq!((again.status.as_u16(), again.text.as_str(), again.header("etag")), (304, "", tag), "{path}");
            assert!(!again.header("x-model-version").is_empty());
        }
        let other = asked(path, &[("if-none-match", "\"other\"")]);
        assert_eq!((other.status.as_u16(), other.text == first.text), (200, true));
    }
}

#[test]
fn a_tag_is_of_one_answer_alone() {
    let tag = |path: &str, headers: &[(&str, &str)]| asked(path, headers).header("etag").to_owned();
    let plain = tag(FORCES, &[]);
    assert_eq!(plain, tag(FORCES, &[]));
    assert_ne!(plain, tag(&FORCES.replace("0.2", "0.3"), &[]));
    assert_ne!(tag(SWEEP, &[]), tag(SWEEP, &[("accept", "text/csv")]));
    assert_ne!(tag("/v1/soils", &[]), tag("/v1/soils", &[("accept", "text/csv")]));
    assert_ne!(tag("/v1/soils", &[]), tag("/v1/soils?kind=lunar", &[]));
    let limits = |body| {
        let service = Service::new(Limits { body, ..Limits::default() });
        send_to(service, request("GET", "/v1/limits", &[], Body::empty())).header("etag").to_owned()
    };
    assert_ne!(limits(1 << 20), limits(1 << 21));
    let packed = asked(SWEEP, &[("accept-encoding", "gzip;q=0, identity")]);
    assert_eq!(packed.header("etag"), tag(SWEEP, &[]));
}

#[test]
fn what_follows_from_more_than_its_address_has_no_tag() {
    let posted = send(request("POST", "/v1/forces", &[("content-type", "application/json")], r#"{"slip": 0.2}"#));
    assert_eq!((posted.status.as_u16(), posted.header("etag")), (422, ""));
    let refused = get("/v1/forces?slip=0.2");
    assert_eq!((refused.status.as_u16(), refused.header("etag")), (422, ""));
    for path in ["/healthz", "/readyz", "/metrics"] {
        assert_eq!(get(path).header("etag"), "", "{path}");
    }
}

fn unpacked(coding: &str, bytes: &[u8]) -> String {
    let mut text = String::new();
    match coding {
        "gzip" => drop(flate2::read::GzDecoder::new(bytes).read_to_string(&mut text).expect("gzip")),
        "zstd" => text = String::from_utf8(zstd::decode_all(bytes).expect("zstd")).expect("text"),
        other => panic!("{other}"),
    }
    text
}

async fn answered(service: &Service, request: Request<Body>) -> Response<Body> {
    app(service.clone()).oneshot(request).await.expect("the service always answers")
}

fn coding(response: &Response<Body>) -> &str {
    response.headers().get("content-encoding").map_or("", |value| value.to_str().expect("text"))
}

#[test]
fn a_long_answer_is_packed_for_those_who_take_it() {
    let body = json!({"wheel": {"preset": "letter"}, "soil": {"preset": "letter-sand"}, "normal_load_n": 50.0, "slip": {"from": 0, "to": 1, "points": 1001},
                      "method": "linearised"});
    let json = ("content-type", "application/json");
    let service = Service::new(Limits::default());
    for accept in ["application/json", "text/csv"] {
        let ask = |accepted| {
            request("POST", "/v1/slip-sweep", &[json, ("accept", accept), ("accept-encoding", accepted)], body.to_string())
        };
        runtime().block_on(async {
            let plain = answered(&service, ask("identity")).await;
            assert_eq!(coding(&plain), "");
            let plain = to_bytes(plain.into_body(), usize::MAX).await.expect("a body");
            for (accepted, sent) in
                [("gzip", "gzip"), ("zstd", "zstd"), ("gzip, deflate, br, zstd", "zstd"), ("zstd;q=0.1, gzip", "gzip")]
            {
                let packed = answered(&service, ask(accepted)).await;
                assert_eq!(coding(&packed), sent, "{accepted}");
                assert!(!packed.headers().contains_key("content-length"));
                let bytes = to_bytes(packed.into_body(), usize::MAX).await.expect("a body");
                assert_eq!(unpacked(sent, &bytes).as_bytes(), plain, "{accepted}");
                assert!(bytes.len() < plain.len() / 2, "{} of {}", bytes.len(), plain.len());
            }
        });
    }
}

#[test]
fn each_form_of_an_answer_has_its_tag() {
    let plain = get(SWEEP);
    let service = Service::new(Limits::default());
    let headers = [("accept-encoding", "gzip")];
    let packed = runtime().block_on(answered(&service, request("GET", SWEEP, &headers, Body::empty())));
    let tag = packed.headers()["etag"].to_str().expect("text");
    assert_eq!(tag.replace("-gzip", ""), plain.header("etag"));
    assert_ne!(tag, plain.header("etag"));
    let again = asked(SWEEP, &[("accept-encoding", "gzip"), ("if-none-match", tag)]);
    assert_eq!((again.status.as_u16(), again.header("etag")), (304, tag));
}

#[test]
fn short_answers_and_streams_go_as_they_are() {
    let packed = [("accept-encoding", "gzip"), ("content-type", "text/csv")];
    let service = Service::new(Limits::default());
    runtime().block_on(async {
        let short = answered(&service, request("GET", "/healthz", &packed, Body::empty())).await;
        assert_eq!((short.status().as_u16(), coding(&short)), (200, ""));
        let rows: String = (0..20_000).map(|i| format!("{i},0.2\n")).collect();
        let rows = "time_s,slip\n".to_owned() + &rows;
        let path = "/v1/track?wheel.preset=letter&soil.preset=letter-sand&method=explicit&normal_load_n=50";
        let stream = answered(&service, request("POST", path, &packed, rows)).await;
        assert_eq!((stream.status().as_u16(), coding(&stream)), (200, ""));
    });
}

#[test]
fn without_memory_for_it_nothing_is_packed() {
    let service = Service::new(Limits { answers: 1 << 20, ..Limits::default() });
    let ask = || request("GET", SWEEP, &[("accept-encoding", "gzip")], Body::empty());
    runtime().block_on(async {
        let first = answered(&service, ask()).await;
        let second = answered(&service, ask()).await;
        assert_eq!((coding(&first), coding(&second)), ("gzip", ""));
        drop(first);
        assert_eq!(coding(&answered(&service, ask()).await), "gzip");
    });
}

#[test]
fn the_methods_of_a_path_can_be_asked_for() {
    let answer = send(request("OPTIONS", "/v1/forces", &[], Body::empty()));
    assert_eq!((answer.status.as_u16(), answer.text.as_str()), (204, ""));
    for method in ["GET", "POST"] {
        assert!(answer.header("allow").contains(method), "{}", answer.header("allow"));
    }
    assert_eq!(send(request("OPTIONS", "/nowhere", &[], Body::empty())).status, 404);
}

#[test]
fn pages_of_other_origins_read_only_where_they_may() {
    let preflight = [
        ("origin", "https://a.example"),
        ("access-control-request-method", "POST"),
        ("access-control-request-headers", "content-type"),
    ];
    let ask = |origins: &[&'static str], method, headers: &[(&str, &str)]| {
        let origins = origins.iter().map(|origin| origin.parse().expect("a header")).collect();
        let service = Service::seen_as(Limits::default(), Outside { origins, ..Outside::default() });
        send_to(service, request(method, FORCES, headers, Body::empty()))
    };
    let allowed = "access-control-allow-origin";
    assert_eq!(ask(&[], "OPTIONS", &preflight).header(allowed), "");
    assert_eq!(ask(&[], "GET", &preflight).header(allowed), "");
    let some = ["https://b.example", "https://a.example"];
    let answer = ask(&some, "OPTIONS", &preflight);
    assert_eq!((answer.status.as_u16(), answer.header(allowed)), (200, "https://a.example"));
    assert!(answer.header("access-control-allow-methods").contains("POST"));
    assert!(answer.header("access-control-allow-headers").contains("content-type"));
    let answer = ask(&some, "GET", &preflight);
    assert_eq!((answer.status.as_u16(), answer.header(allowed)), (200, "https://a.example"));
    assert!(answer.header("access-control-expose-headers").contains("x-request-id"));
    assert!(answer.header("vary").contains("origin"), "{}", answer.header("vary"));
    assert_eq!(ask(&some, "GET", &[("origin", "https://c.example")]).header(allowed), "");
    assert_eq!(ask(&["*"], "GET", &preflight).header(allowed), "*");
}
