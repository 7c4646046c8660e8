//! Requests as bytes: heads that can be read in two ways, codings of bodies, bodies that are too large, names that are no text.

use std::io::{Read, Write};
use std::net::TcpStream;
use std::time::Duration;

use axum::body::{Body, Bytes};
use flate2::Compression;
use flate2::write::{GzEncoder, ZlibEncoder};

use crate::asking::{Answer, get, letter, request, send, send_to};
use crate::running::Server;
use terramechanics_server::{Limits, Service};

/// What the server answers to these bytes until it closes the connection.
fn answer_to(server: &Server, bytes: &[u8]) -> String {
    let mut stream = server.connect();
    stream.write_all(bytes).expect("sent");
    let mut answer = String::new();
    stream.read_to_string(&mut answer).expect("an answer, then the end");
    answer
}

fn answers(text: &str) -> usize {
    text.matches("HTTP/1.1 ").count()
}

#[test]
fn a_head_that_can_be_read_in_two_ways_is_refused_and_the_connection_closed() {
    let server = Server::start(&[]);
    // The second request must not be answered, for it may be a part of the first.
    let next = "GET /healthz HTTP/1.1\r\nHost: test\r\n\r\n";
    for (head, is_ours) in [
        ("GET /healthz HTTP/1.1\r\n", true),
        ("GET /healthz HTTP/1.1\r\nHost: a\r\nHost: b\r\n", true),
        ("GET /healthz HTTP/1.1\r\nHost: a\r\nHost: a\r\n", true),
        ("GET /healthz HTTP/1.0\r\nHost: a\r\nHost: b\r\n", true),
        ("GET /healthz HTTP/1.1\r\nHost: a b\r\n", true),
        ("GET /healthz HTTP/1.1\r\nHost: user@a\r\n", true),
        ("GET /healthz HTTP/1.1\r\nHost: a/b\r\n", true),
        ("GET /healthz HTTP/1.1\r\nHost: a:x\r\n", true),
        ("POST /v1/forces HTTP/1.1\r\nHost: a\r\nTransfer-Encoding: chunked\r\nTransfer-Encoding: chunked\r\n", true),
        ("POST /v1/forces HTTP/1.1\r\nHost: a\r\nTransfer-Encoding: gzip, chunked\r\n", true),
        ("POST /v1/forces HTTP/1.1\r\nHost: a\r\nTransfer-Encoding: chunked, chunked\r\n", true),
        ("POST /v1/forces HTTP/1.1\r\nHost: a\r\nTransfer-Encoding: gzip\r\nTransfer-Encoding: chunked\r\n", true),
        ("POST /v1/forces HTTP/1.1\r\nHost: a\r\nTransfer-Encoding: gzip\r\n", false),
        ("POST /v1/forces HTTP/1.1\r\nHost: a\r\nTransfer-Encoding: chunked, gzip\r\n", false),
        ("POST /v1/forces HTTP/1.0\r\nHost: a\r\nTransfer-Encoding: chunked\r\n", false),
        ("POST /v1/forces HTTP/1.1\r\nHost: a\r\nContent-Length: 5\r\nContent-Length: 6\r\n", false),
        ("POST /v1/forces HTTP/1.1\r\nHost: a\r\nContent-Length: 5, 5\r\n", false),
        ("POST /v1/forces HTTP/1.1\r\nHost: a\r\nContent-Length: +5\r\n", false),
        ("POST /v1/forces HTTP/1.1\r\nHost: a\r\nContent-Length: -1\r\n", false),
        ("POST /v1/forces HTTP/1.1\r\nHost: a\r\nContent-Length : 5\r\n", false),
    ] {
        let answer = answer_to(&server, format!("{head}\r\n0\r\n\r\n{next}").as_bytes());
        assert!(answer.contains(" 400 Bad Request\r\n"), "{head}: {answer}");
        assert_eq!(answer.matches("HTTP/1.").count(), 1, "{head}: {answer}");
        assert_eq!(answer.contains("/problems/ambiguous-request"), is_ours, "{head}: {answer}");
    }
}

/// The chunks are read and nothing else, and what follows is not taken for another request.
#[test]
fn a_length_beside_chunks_ends_the_connection() {
    let server = Server::start(&[]);
    let next = "GET /healthz HTTP/1.1\r\nHost: test\r\n\r\n";
    for headers in ["Content-Length: 4\r\nTransfer-Encoding: chunked", "Transfer-Encoding: chunked\r\nContent-Length: 4"] {
        let head = format!("POST /v1/forces HTTP/1.1\r\nHost: test\r\nContent-Type: application/json\r\n{headers}\r\n\r\n");
        let answer = answer_to(&server, format!("{head}2\r\n{{}}\r\n0\r\n\r\n{next}").as_bytes());
        assert!(answer.starts_with("HTTP/1.1 422 ") && answers(&answer) == 1, "{answer}");
    }
}

#[test]
fn a_head_that_is_clear_is_taken() {
    let server = Server::start(&[]);
    for head in [
        "GET /healthz HTTP/1.0\r\n",
        "GET /healthz HTTP/1.0\r\nHost: a\r\n",
        "GET /healthz HTTP/1.1\r\nHost:\r\nConnection: close\r\n",
        "GET /healthz HTTP/1.1\r\nHost: [::1]:80\r\nConnection: close\r\n",
        "GET http://a/healthz HTTP/1.1\r\nHost: a\r\nConnection: close\r\n",
    ] {
        let answer = answer_to(&server, format!("{head}\r\n").as_bytes());
        assert!(answer.contains(" 200 OK\r\n"), "{head}: {answer}");
    }
    let head = "POST /v1/forces HTTP/1.1\r\nHost: a\r\nConnection: close\r\nContent-Type: application/json\r\nTransfer-Encoding: Chunked\r\n";
    let body = letter().to_string();
    let answer = answer_to(&server, format!("{head}\r\n{:x}\r\n{body}\r\n0\r\n\r\n", body.len()).as_bytes());
    assert!(answer.starts_with("HTTP/1.1 200 "), "{answer}");
}

fn gzip(bytes: &[u8]) -> Vec<u8> {
    let mut encoder = GzEncoder::new(Vec::new(), Compression::default());
    encoder.write_all(bytes).expect("memory");
    encoder.finish().expect("memory")
}

fn deflate(bytes: &[u8]) -> Vec<u8> {
    let mut encoder = ZlibEncoder::new(Vec::new(), Compression::default());
    encoder.write_all(bytes).expect("memory");
    encoder.finish().expect("memory")
}

fn coded(coding: &str, body: impl Into<Body>) -> Answer {
    send(request("POST", "/v1/forces", &[("content-type", "application/json"), ("content-encoding", coding)], body))
}

#[test]
fn a_packed_body_is_unpacked() {
    let body = letter().to_string();
    let plain = send(request("POST", "/v1/forces", &[("content-type", "application/json")], body.clone())).ok();
    for coding in ["gzip", "GZIP", "x-gzip"] {
        assert_eq!(coded(coding, gzip(body.as_bytes())).ok(), plain, "{coding}");
    }
    assert_eq!(coded("deflate", deflate(body.as_bytes())).ok(), plain);
    let packed = zstd::encode_all(body.as_bytes(), 3).expect("memory");
    assert_eq!(coded("zstd", packed.clone()).ok(), plain);
    coded("zstd", packed[..packed.len() - 3].to_vec()).problem(400);
    assert_eq!(coded("identity", body.clone()).ok(), plain);
    send(request("GET", "/healthz", &[("content-encoding", "br")], Body::empty())).ok(); // nothing is packed there
    let (first, second) = body.split_at(20);
    assert_eq!(coded("gzip", [gzip(first.as_bytes()), gzip(second.as_bytes())].concat()).ok(), plain, "two members");
}

/// What a window takes of the memory is bounded, however small the body is.
#[test]
fn a_zstd_body_with_a_larger_window_than_every_decoder_has_is_a_400() {
    let body = " ".repeat(100) + &letter().to_string();
    let packed = |window: u32| {
        let mut encoder = zstd::Encoder::new(Vec::new(), 3).expect("an encoder");
        encoder.window_log(window).expect("a window");
        encoder.write_all(body.as_bytes()).expect("memory");
        encoder.finish().expect("memory")
    };
    coded("zstd", packed(23)).ok();
    coded("zstd", packed(24)).problem(400);
}

#[test]
fn a_coding_that_is_not_unpacked_is_a_415_that_names_those_that_are() {
    for coding in ["br", "compress", "gzip, gzip", "deflate, gzip", "utf-8"] {
        let answer = coded(coding, letter().to_string());
        answer.problem(415);
        assert_eq!(answer.header("accept-encoding"), "gzip, deflate, zstd", "{coding}");
    }
    let twice = [("content-type", "application/json"), ("content-encoding", "gzip"), ("content-encoding", "gzip")];
    send(request("POST", "/v1/forces", &twice, gzip(&gzip(letter().to_string().as_bytes())))).problem(415);
}

#[test]
fn a_packed_body_that_is_broken_is_a_400() {
    let packed = gzip(letter().to_string().as_bytes());
    let flipped = packed.iter().enumerate().map(|(i, byte)| if i == packed.len() - 6 { byte ^ 1 } else { *byte }).collect();
    let cut = packed[..packed.len() - 3].to_vec();
    let followed = [packed.as_slice(), b"more"].concat();
    for (broken, why) in [
        (letter().to_string().into_bytes(), "not packed"),
        (deflate(b"{}"), "of another coding"),
        (flipped, "its checksum is wrong"),
        (cut, "it is cut"),
        (followed, "more follows"),
    ] {
        let problem = coded("gzip", broken).problem(400);
        assert_eq!(problem["type"], "/problems/broken-body", "{why}");
    }
}

/// The bound holds for what comes out, and no more than that is unpacked.
#[test]
fn a_body_that_swells_is_a_413() {
    let limit = 100_000;
    let swelling = gzip(&vec![b' '; 50 << 20]);
    assert!(swelling.len() < limit, "{}", swelling.len());
    let service = Service::new(Limits { body: limit, ..Limits::default() });
    let headers = [("content-type", "application/json"), ("content-encoding", "gzip")];
    send_to(service, request("POST", "/v1/forces", &headers, swelling)).problem(413);
}

#[test]
fn a_packed_series_is_unpacked_while_it_is_sent() {
    let path = "/v1/track?wheel.preset=letter&soil.preset=letter-sand&static_sinkage_m=0.02&method=explicit";
    let rows: String = (0..5000).map(|i| format!("{i},0.1\n")).collect();
    let table = format!("time_s,slip\n{rows}");
    let plain = send(request("POST", path, &[("content-type", "text/csv")], table.clone()));
    assert!(plain.text.ends_with("#end,5000\n"));
    let packed = gzip(table.as_bytes());
    let pieces: Vec<Bytes> = packed.chunks(100).map(Bytes::copy_from_slice).collect();
    for packed in [Body::from(packed.clone()), Body::new(Pieces(pieces.into_iter()))] {
        let answer = send(request("POST", path, &[("content-type", "text/csv"), ("content-encoding", "gzip")], packed));
        assert_eq!(answer.text, plain.text);
    }
    let cut = packed[..packed.len() / 2].to_vec();
    let answer = send(request("POST", path, &[("content-type", "text/csv"), ("content-encoding", "gzip")], cut));
    assert!(answer.text.lines().next_back().expect("lines").starts_with("#error,"), "{}", answer.text);
}

struct Pieces(std::vec::IntoIter<Bytes>);

impl hyper::body::Body for Pieces {
    type Data = Bytes;
    type Error = std::convert::Infallible;

    fn poll_frame(
        mut self: std::pin::Pin<&mut Self>,
        _: &mut std::task::Context<'_>,
    ) -> std::task::Poll<Option<Result<hyper::body::Frame<Bytes>, Self::Error>>> {
        std::task::Poll::Ready(self.0.next().map(|piece| Ok(hyper::body::Frame::data(piece))))
    }
}

/// Writes the whole body and reads only then, as many clients do.
fn answer_to_a_writer(server: &Server, head: &str, length: usize) -> String {
    let mut stream = server.connect();
    let head = format!("POST {head}\r\nHost: test\r\nConnection: close\r\nContent-Length: {length}\r\n\r\n");
    stream.write_all(head.as_bytes()).expect("sent");
    let piece = vec![b' '; 64 << 10];
    for _ in 0..length / piece.len() {
        stream.write_all(&piece).expect("the server takes what is sent");
    }
    // Time in which a connection that was closed early would be reset.
    std::thread::sleep(Duration::from_millis(200));
    let mut answer = String::new();
    stream.read_to_string(&mut answer).expect("the answer, not a reset");
    answer
}

#[test]
fn a_client_that_writes_all_of_its_body_first_sees_why_it_is_refused() {
    let server = Server::start(&[]);
    let length = 6 << 20;
    for (head, status) in [
        ("/v1/forces HTTP/1.1\r\nContent-Type: application/json", "413"),
        ("/v1/forces HTTP/1.1\r\nContent-Type: text/plain", "415"),
        ("/v1/forces HTTP/1.1\r\nContent-Type: application/json\r\nContent-Encoding: br", "415"),
        ("/nope HTTP/1.1", "404"),
        ("/healthz HTTP/1.1", "405"),
    ] {
        let answer = answer_to_a_writer(&server, head, length);
        assert!(answer.starts_with(&format!("HTTP/1.1 {status} ")) && answer.ends_with('}'), "{head}: {answer}");
    }
}

#[test]
fn a_body_without_end_is_not_read_for_ever() {
    let server = Server::start(&[]);
    let mut stream = server.connect();
    stream.set_write_timeout(Some(Duration::from_secs(20))).expect("a timeout");
    let head = "POST /nope HTTP/1.1\r\nHost: test\r\nContent-Length: 1000000000000\r\n\r\n";
    stream.write_all(head.as_bytes()).expect("sent");
    let piece = vec![b' '; 64 << 10];
    let taken = (0..10_000).take_while(|_| stream.write_all(&piece).is_ok()).count();
    assert!(taken < 10_000, "the connection is closed before 640 MB are read");
}

/// A client that asks before it sends is told without having sent anything.
#[test]
fn a_body_that_is_announced_is_not_asked_for_in_vain() {
    let server = Server::start(&[]);
    let head = "POST /v1/forces HTTP/1.1\r\nHost: test\r\nContent-Type: application/json\r\nContent-Length: 6000000\r\nExpect: 100-continue\r\n\r\n";
    let answer = answer_to(&server, head.as_bytes());
    assert!(answer.starts_with("HTTP/1.1 413 ") && answers(&answer) == 1, "{answer}");
    // What fits is asked for.
    let body = letter().to_string();
    let head = head.replace("6000000", &body.len().to_string()).replace("Expect", "Connection: close\r\nExpect");
    let mut stream: TcpStream = server.connect();
    stream.write_all(head.as_bytes()).expect("sent");
    let mut first = [0; 25];
    stream.read_exact(&mut first).expect("an answer");
    assert_eq!(&first, b"HTTP/1.1 100 Continue\r\n\r\n");
    stream.write_all(body.as_bytes()).expect("sent");
    let mut answer = String::new();
    stream.read_to_string(&mut answer).expect("an answer");
    assert!(answer.starts_with("HTTP/1.1 200 "), "{answer}");
}

#[test]
fn a_name_in_a_path_that_is_no_text_is_a_404() {
    for path in ["/v1/soils/%ff", "/v1/wheels/a%c3", "/v1/validation/%80", "/static/%ff", "/docs/%ff", "/%ff"] {
        get(path).problem(404);
    }
}

#[test]
fn what_is_repeated_of_a_request_is_short_and_legible() {
    let detail = |path: &str| get(path).problem(404)["detail"].as_str().expect("a detail").to_owned();
    assert!(detail(&format!("/{}", "x".repeat(10_000))).len() < 200);
    assert!(detail("/\u{202e}gnp").contains("/\\u{202e}gnp"));
    assert!(detail(&format!("/static/{}", "x".repeat(10_000))).len() < 200);
    assert!(detail("/static/a%0d%0ab%e2%80%ae%1b").contains("a\\r\\nb\\u{202e}\\u{1b}"));
    for query in ["slip=%e2%80%ae%0a%1b", "slip=%ff%00", "%e2%80%ae%0a=1"] {
        let text = get(&format!("/v1/forces?{query}")).problem(422)["errors"].to_string();
        assert!(!text.contains('\u{202e}') || query.starts_with('%'), "{text}");
        let faults: serde_json::Value = serde_json::from_str(&text).expect("JSON");
        for fault in faults.as_array().expect("faults") {
            assert!(!fault["detail"].as_str().expect("a detail").contains(char::is_control), "{text}");
        }
    }
    let long = get(&format!("/v1/forces?slip={}&{}=1", "%41".repeat(10_000), "%42".repeat(5000)));
    assert!(long.text.len() < 3000, "{}", long.text);
}
