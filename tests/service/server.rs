//! The program as an operator runs it: settings, answers, a full pool.

use std::io::{BufRead, BufReader, Read, Write};
use std::net::{SocketAddr, TcpStream};
use std::process::Command;
use std::time::Instant;

use crate::asking::letter;
use crate::running::{PATIENCE, PROGRAM, Server, TRACK, chunk, long_sweep, message};

#[test]
fn it_serves_and_counts() {
    let server = Server::start(&[]);
    assert!(server.ask("/v1/forces", Some(&letter().to_string())).starts_with("HTTP/1.1 200 "));
    assert!(server.ask("/healthz", None).contains("\"status\":\"ok\""));
    assert!(server.ask("/readyz", None).contains("\"status\":\"ready\""));
    let metrics = server.ask("/metrics", None);
    assert!(metrics.contains("http_requests_total{method=\"POST\",route=\"/v1/forces\",status=\"200\"} 1"), "{metrics}");
    // Only the connection that asks is open, once those before are closed.
    let start = Instant::now();
    while !server.ask("/metrics", None).contains("http_connections 1") {
        assert!(start.elapsed() < PATIENCE, "connections are counted down");
    }
}

/// The metrics that the queries of the dashboard name.
fn metrics_of_the_dashboard() -> Vec<String> {
    let text =
        std::fs::read_to_string(concat!(env!("CARGO_MANIFEST_DIR"), "/deploy/grafana/terramechanics.json")).expect("a file");
    let dashboard: serde_json::Value = serde_json::from_str(&text).expect("JSON");
    let panels = dashboard["panels"].as_array().expect("panels");
    let targets = panels.iter().flat_map(|panel| panel["targets"].as_array().expect("targets"));
    let queries = targets.map(|target| target["expr"].as_str().expect("a query"));
    let names = queries.flat_map(|query| {
        let named = query.split('{').map(|before| before.rsplit(|c: char| !c.is_alphanumeric() && c != '_').next().unwrap_or(""));
        named.filter(|name| name.contains('_')).map(str::to_owned).collect::<Vec<_>>()
    });
    names.collect()
}

#[test]
fn the_dashboard_shows_metrics_that_there_are() {
    let server = Server::start(&[]);
    server.ask("/healthz", None);
    let metrics = server.ask("/metrics", None);
    let named = metrics_of_the_dashboard();
    assert!(named.len() >= 17, "{named:?}");
    for name in named {
        let is_there = metrics.lines().any(|line| line.strip_prefix(&name).is_some_and(|rest| rest.starts_with(['{', ' '])));
        assert!(is_there, "{name} in {metrics}");
    }
    let descriptions: Vec<&str> = metrics.lines().filter(|line| line.starts_with("# TYPE ")).collect();
    let distinct: std::collections::BTreeSet<&str> = descriptions.iter().copied().collect();
    assert_eq!(distinct.len(), descriptions.len(), "a metric is described once");
}

#[test]
fn work_that_was_refused_is_counted_by_its_reason() {
    let server = Server::start(&["--price-limit", "1"]);
    let refused = server.ask("/v1/slip-sweep", Some(&crate::heavy::stiff(10_001).to_string()));
    assert!(refused.starts_with("HTTP/1.1 422 "), "{refused}");
    assert!(server.ask("/metrics", None).contains("compute_failures_total{reason=\"too_costly\"} 1"));
}

#[test]
fn healthcheck_tells_by_its_exit_code() {
    let mut server = Server::start(&[]);
    let check = |address: SocketAddr| {
        let output = Command::new(PROGRAM).args(["healthcheck", "--listen", &address.to_string(), "--timeout", "5"]).output();
        output.expect("the program runs").status.code()
    };
    assert_eq!(check(server.address), Some(0));
    server.signal("-TERM");
    assert_eq!(server.exit_code(), Some(0));
    assert_eq!(check(server.address), Some(1));
}

#[test]
fn openapi_is_printed() {
    let output = Command::new(PROGRAM).arg("openapi").output().expect("the program runs");
    assert_eq!(String::from_utf8(output.stdout).expect("text"), include_str!("../../openapi/openapi.json"));
}

#[test]
fn wrong_and_unknown_settings_refuse_to_start_and_say_why() {
    let refuses = |arguments: &[&str], variables: &[(&str, &str)], hint: &str| {
        let output = Command::new(PROGRAM).args(arguments).envs(variables.iter().copied()).output().expect("the program runs");
        let message = String::from_utf8_lossy(&output.stderr).into_owned();
        assert!(!output.status.success() && message.contains(hint), "{arguments:?} {variables:?}: {message}");
    };
    refuses(&["--listen", "localhost"], &[], "--listen");
    refuses(&["--listn", "127.0.0.1:0"], &[], "--listen");
    refuses(&["--log", "a=b=c", "--listen", "127.0.0.1:0"], &[], "--log");
    refuses(&[], &[("TERRAMECHANICS_LISTEN", "nowhere")], "listen");
    refuses(&[], &[("TERRAMECHANICS_LISTN", "127.0.0.1:0")], "TERRAMECHANICS_LISTEN");
    let taken = Server::start(&[]);
    refuses(&["--listen", &taken.address.to_string()], &[], "cannot listen");
}

#[test]
fn a_full_pool_is_a_503_while_health_and_short_work_go_on() {
    let server = Server::start(&["--compute-places", "1", "--compute-threads", "1", "--workers", "1"]);
    let body = long_sweep();
    let mut streams: Vec<TcpStream> = (0..6)
        .map(|_| {
            let mut stream = server.connect();
            stream.write_all(message("/v1/slip-sweep", Some(&body), true).as_bytes()).expect("sent");
            stream
        })
        .collect();
    assert!(server.ask("/healthz", None).starts_with("HTTP/1.1 200"));
    assert!(server.ask("/v1/forces", Some(&letter().to_string())).starts_with("HTTP/1.1 200"));
    let answers: Vec<String> = streams
        .iter_mut()
        .map(|stream| {
            let mut answer = String::new();
            stream.read_to_string(&mut answer).expect("an answer");
            answer
        })
        .collect();
    let with_status = |status: &str| answers.iter().filter(|answer| answer.starts_with(status)).count();
    assert!(with_status("HTTP/1.1 200") >= 1);
    let busy: Vec<&String> = answers.iter().filter(|answer| answer.starts_with("HTTP/1.1 503")).collect();
    assert!(!busy.is_empty() && busy.iter().all(|answer| answer.contains("retry-after: 1") && answer.contains("problem+json")));
    assert!(server.ask("/v1/slip-sweep", Some(&body)).starts_with("HTTP/1.1 200"), "the place is free again");
}

#[test]
fn a_track_is_answered_over_the_wire_while_it_is_sent() {
    let server = Server::start(&["--compute-threads", "1"]);
    let mut stream = server.connect();
    let head = format!(
        "POST {TRACK} HTTP/1.1\r\nHost: test\r\nConnection: close\r\nContent-Type: text/csv\r\nTransfer-Encoding: chunked\r\n\r\n"
    );
    stream.write_all((head + &chunk("time_s,slip\n0,0.1\n")).as_bytes()).expect("sent");
    let mut answer = String::new();
    let mut reader = BufReader::new(stream.try_clone().expect("the other half"));
    while !answer.contains("\n0.0,0.1,") {
        assert!(reader.read_line(&mut answer).expect("a line") > 0, "{answer}");
    }
    assert!(answer.starts_with("HTTP/1.1 200 "), "{answer}");
    stream.write_all((chunk("1,0.1\n") + "0\r\n\r\n").as_bytes()).expect("sent");
    reader.read_to_string(&mut answer).expect("the rest");
    assert!(answer.contains("\n1.0,0.1,") && answer.contains("#end,2\n") && answer.ends_with("0\r\n\r\n"), "{answer}");
}
