//! Work that takes long: what it may cost, when it ends, and that what is short goes before it.

use std::io::{Read, Write};
use std::net::TcpStream;
use std::time::{Duration, Instant};

use serde_json::{Value, json};

use crate::asking::letter;
use crate::running::{PATIENCE, Server, message};

/// A contact so stiff that one load balance of the braking wheel takes half a millisecond: nearly every pressure is reached at once,
/// and shear within micrometres. A random search over requests found it.
pub(crate) fn stiff(points: usize) -> Value {
    json!({
        "wheel": {"radius_m": 0.0707, "width_m": 0.0133, "lug_height_m": 0.00274, "lug_coefficient": 0.958},
        "soil": {
            "cohesion_pa": 6.57, "friction_angle_rad": 0.0607, "shear_modulus_m": 4.93e-6,
            "pressure_sinkage": {"law": "direct", "k_s": 71_622, "n0": 0.01325}
        },
        "slip": {"from": -0.9, "to": -0.3, "points": points}, "normal_load_n": 20_000
    })
}

fn under_way(server: &Server, count: usize) -> bool {
    server.ask("/metrics", None).contains(&format!("compute_places_free {}\n", 64 - count))
}

fn wait_until(server: &Server, count: usize) {
    let start = Instant::now();
    while !under_way(server, count) {
        assert!(start.elapsed() < PATIENCE, "never {count} computations under way");
        std::thread::sleep(Duration::from_millis(5));
    }
}

fn send(server: &Server, path: &str, body: &Value) -> TcpStream {
    let mut stream = server.connect();
    stream.write_all(message(path, Some(&body.to_string()), true).as_bytes()).expect("sent");
    stream
}

#[test]
fn work_ends_when_its_client_goes() {
    let server = Server::start(&[]);
    let comparison = json!({"methods": ["quadrature", "linearised"]});
    let body = crate::asking::with(&stiff(10_001), comparison);
    let clients = [send(&server, "/v1/slip-sweep", &stiff(10_001)), send(&server, "/v1/compare", &body)];
    wait_until(&server, clients.len());
    drop(clients);
    wait_until(&server, 0);
}

#[test]
fn a_price_above_the_limit_is_refused_before_the_work() {
    let server = Server::start(&["--price-limit", "1"]);
    let answer = server.ask("/v1/slip-sweep", Some(&stiff(2).to_string()));
    assert!(answer.starts_with("HTTP/1.1 422 ") && answer.contains("/problems/too-costly"), "{answer}");
    // It is the price that is published.
    let published = server.ask("/v1/limits", None);
    let published: Value = serde_json::from_str(published.split("\r\n\r\n").nth(1).expect("a body")).expect("JSON");
    let price = &published["price"];
    assert_eq!(price["limit_s"], 1.0);
    let points = price["points"].as_array().expect("a list");
    let point = points.iter().find(|point| point["work"] == "the quadrature under a load").expect("its price");
    let number = |value: &Value| value.as_f64().expect("a number");
    let told = answer.split("is priced at ").nth(1).and_then(|rest| rest.split(' ').next()).expect("the price");
    let told: f64 = told.parse().expect("a number");
    assert!((told - number(&price["allowance_s"]) - 2.0 * number(&point["price_s"])).abs() < 1e-6, "{told} {price}");
    assert!(server.ask("/v1/forces", Some(&letter().to_string())).starts_with("HTTP/1.1 200 "));
}

#[test]
fn short_work_goes_before_long_work() {
    let server = Server::start(&["--compute-threads", "1"]);
    let greedy: Vec<TcpStream> = (0..8).map(|_| send(&server, "/v1/slip-sweep", &stiff(10_001))).collect();
    wait_until(&server, greedy.len());
    let mut loaded = letter();
    loaded.as_object_mut().expect("an object").remove("sinkage_m");
    loaded["normal_load_n"] = 80.into();
    for _ in 0..5 {
        let answer = server.ask("/v1/forces", Some(&loaded.to_string()));
        assert!(answer.starts_with("HTTP/1.1 200 "), "{answer}");
    }
    assert!(under_way(&server, greedy.len()), "all of the long work goes on");
}

#[test]
fn short_work_has_places_where_long_work_has_none_left() {
    let server = Server::start(&["--compute-threads", "1", "--compute-places", "1"]);
    let _greedy = send(&server, "/v1/slip-sweep", &stiff(10_001));
    let start = Instant::now();
    while !server.ask("/metrics", None).contains("compute_places_free 0\n") {
        assert!(start.elapsed() < PATIENCE, "it never begins");
    }
    let refused = server.ask("/v1/slip-sweep", Some(&stiff(10_001).to_string()));
    assert!(refused.starts_with("HTTP/1.1 503 ") && refused.contains("retry-after"), "{refused}");
    let mut loaded = letter();
    loaded.as_object_mut().expect("an object").remove("sinkage_m");
    loaded["normal_load_n"] = 80.into();
    assert!(server.ask("/v1/forces", Some(&loaded.to_string())).starts_with("HTTP/1.1 200 "));
}

#[test]
fn a_late_answer_is_a_problem_and_its_work_ends() {
    let server = Server::start(&["--compute-timeout", "1"]);
    let mut stream = send(&server, "/v1/slip-sweep", &stiff(10_001));
    let mut answer = String::new();
    stream.read_to_string(&mut answer).expect("an answer");
    assert!(answer.starts_with("HTTP/1.1 503 ") && answer.contains("/problems/late"), "{answer}");
    wait_until(&server, 0);
}
