//! The log under readers of stderr that are stuck, gone or full, and what stands in it.

use std::fs::File;
use std::io::{BufRead, BufReader, Read, Write};
use std::process::{ChildStderr, Stdio};
use std::time::Instant;

use serde_json::Value;

use crate::running::{PATIENCE, Server, message};

/// Answers that write more lines than a pipe and the queue of the log hold.
const MANY: usize = 8000;

/// Asks for `count` paths that are not there, each of which is a line of the log, and takes the answers.
fn ask_for_nothing(server: &Server, count: usize) {
    let mut stream = server.connect();
    let mut answers = BufReader::new(stream.try_clone().expect("the other half"));
    let question = message("/nope", None, false).replace("\r\n\r\n", &format!("\r\nX-Request-Id: {}\r\n\r\n", "i".repeat(128)));
    let mut left = count;
    while left > 0 {
        let now = left.min(100);
        stream.write_all(question.repeat(now).as_bytes()).expect("sent");
        let (mut seen, mut line) = (0, String::new());
        while seen < now {
            line.clear();
            assert!(answers.read_line(&mut line).expect("an answer") > 0, "the connection ended");
            seen += usize::from(line.contains("HTTP/1.1 404 ")); // behind the body of the answer before
        }
        left -= now;
    }
}

fn dropped(server: &Server) -> u64 {
    let metrics = server.ask("/metrics", None);
    let line = metrics.lines().find(|line| line.starts_with("log_lines_dropped_total ")).expect("the counter");
    line.split(' ').nth(1).and_then(|count| count.parse().ok()).expect("a count")
}

fn log_of(server: &mut Server) -> ChildStderr {
    server.child.stderr.take().expect("a pipe")
}

#[test]
fn a_log_that_nobody_reads_holds_nothing_up_and_tells_what_it_lost() {
    let mut server = Server::logging_to(Stdio::piped(), &["--log-format", "json"]);
    let log = log_of(&mut server);
    ask_for_nothing(&server, MANY);
    let lost = dropped(&server);
    assert!(lost > 0, "a pipe and the queue hold less than {MANY} lines");
    // Now somebody reads.
    let reader = std::thread::spawn(move || BufReader::new(log).lines().map(|line| line.expect("text")).collect::<Vec<_>>());
    let start = std::time::Instant::now();
    let flows = || {
        ask_for_nothing(&server, 1);
        std::thread::sleep(std::time::Duration::from_millis(50));
        start.elapsed().as_secs() < 1
    };
    while flows() {}
    server.signal("-TERM");
    assert_eq!(server.exit_code(), Some(0));
    let lines = reader.join().expect("the lines");
    let events: Vec<Value> = lines.iter().map(|line| serde_json::from_str(line).expect("each line is a whole object")).collect();
    let told = events.iter().rfind(|event| event["message"] == "lines of the log were dropped").expect("told");
    assert!(told["total"].as_u64() >= Some(lost), "{told}");
    assert_eq!(events.last().expect("lines")["message"], "stopped");
}

#[test]
fn a_log_that_is_closed_or_full_costs_its_lines_only() {
    let mut closed = Server::logging_to(Stdio::piped(), &["--log", "debug"]);
    drop(log_of(&mut closed));
    let full = File::options().write(true).open("/dev/full").expect("a device that takes nothing");
    let full = Server::logging_to(full.into(), &["--log", "debug"]);
    for mut server in [closed, full] {
        ask_for_nothing(&server, 100);
        assert!(server.ask("/healthz", None).starts_with("HTTP/1.1 200 "));
        // The thread that writes may still be at it.
        let start = Instant::now();
        while dropped(&server) < 100 {
            assert!(start.elapsed() < PATIENCE, "{} lines", dropped(&server));
        }
        server.signal("-TERM");
        assert_eq!(server.exit_code(), Some(0));
    }
}

#[test]
fn all_lines_are_there_after_a_stop() {
    let mut server = Server::logging_to(Stdio::piped(), &["--log-format", "json"]);
    let mut log = log_of(&mut server);
    ask_for_nothing(&server, 50);
    server.signal("-TERM");
    assert_eq!(server.exit_code(), Some(0));
    let mut text = String::new();
    log.read_to_string(&mut text).expect("text");
    assert_eq!(text.lines().filter(|line| line.contains("\"status\":404")).count(), 50);
    assert!(text.lines().next_back().expect("lines").contains("\"stopped\""), "{text}");
}

#[test]
fn a_client_cannot_forge_or_swell_a_line() {
    let mut server = Server::logging_to(Stdio::piped(), &["--log", "debug", "--log-format", "json"]);
    let mut log = log_of(&mut server);
    let forged = "\",\"level\":\"ERROR\",\"x\":\"";
    let long = "M".repeat(10_000);
    for head in [
        format!("GET /%22%0a{{%22level%22:%22ERROR%22}}\u{202e}{} HTTP/1.1\r\n", "/x".repeat(5000)),
        format!("GET /nope HTTP/1.1\r\nX-Request-Id: a{forged}\r\n"),
        format!("GET /nope HTTP/1.1\r\nUser-Agent: {forged}\r\n"),
        format!("{long} / HTTP/1.1\r\n"),
    ] {
        let mut stream = server.connect();
        stream.write_all((head + "Host: test\r\nConnection: close\r\n\r\n").as_bytes()).expect("sent");
        let mut answer = String::new();
        stream.read_to_string(&mut answer).expect("an answer");
        assert!(answer.starts_with("HTTP/1.1 4"), "{answer}");
        assert!(answer.len() < 2000, "{answer}");
    }
    server.signal("-TERM");
    assert_eq!(server.exit_code(), Some(0));
    let mut text = String::new();
    log.read_to_string(&mut text).expect("text");
    let answered = |line: &str| {
        let event: Value = serde_json::from_str(line).expect("each line is a whole object");
        assert_ne!(event["level"], "ERROR", "{line}");
        assert!(line.len() < 500, "{line}");
        event["message"] == "answered"
    };
    assert_eq!(text.lines().filter(|line| answered(line)).count(), 4, "{text}");
}
