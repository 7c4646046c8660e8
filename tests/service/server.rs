//! The program as an operator runs it: settings, slow clients, a full house, a graceful stop.

use std::io::{BufRead, BufReader, Read, Write};
use std::net::{SocketAddr, TcpStream};
use std::process::{Child, Command, Stdio};
use std::time::{Duration, Instant};

use crate::asking::letter;

const PROGRAM: &str = env!("CARGO_BIN_EXE_terramechanics");

/// Long enough for any answer on a busy machine.
pub(crate) const PATIENCE: Duration = Duration::from_secs(20);

pub(crate) struct Server {
    pub(crate) child: Child,
    pub(crate) address: SocketAddr,
}

impl Server {
    pub(crate) fn start(settings: &[&str]) -> Self {
        Self::logging_to(Stdio::null(), settings)
    }

    pub(crate) fn logging_to(log: Stdio, settings: &[&str]) -> Self {
        let mut child = Command::new(PROGRAM)
            .args(["--listen", "127.0.0.1:0"])
            .args(settings)
            .stdout(Stdio::piped())
            .stderr(log)
            .spawn()
            .expect("the program starts");
        let mut line = String::new();
        BufReader::new(child.stdout.take().expect("its output")).read_line(&mut line).expect("a line");
        let address = line.split("http://").nth(1).and_then(|rest| rest.split('/').next()).expect("the page's address");
        Self { address: address.parse().expect("an address"), child }
    }

    pub(crate) fn connect(&self) -> TcpStream {
        let stream = TcpStream::connect(self.address).expect("a connection");
        stream.set_read_timeout(Some(PATIENCE)).expect("a timeout");
        stream
    }

    pub(crate) fn ask(&self, path: &str, body: Option<&str>) -> String {
        let mut stream = self.connect();
        stream.write_all(message(path, body, true).as_bytes()).expect("sent");
        let mut answer = String::new();
        stream.read_to_string(&mut answer).expect("an answer");
        answer
    }

    pub(crate) fn signal(&self, name: &str) {
        let id = self.child.id().to_string();
        // The shell has `kill` built in; the program of that name is missing from small systems.
        assert!(Command::new("sh").args(["-c", "kill \"$0\" \"$1\"", name, &id]).status().expect("a shell").success());
    }

    pub(crate) fn exit_code(&mut self) -> Option<i32> {
        let start = Instant::now();
        while start.elapsed() < PATIENCE {
            if let Some(status) = self.child.try_wait().expect("a status") {
                return status.code();
            }
            std::thread::sleep(Duration::from_millis(20));
        }
        panic!("the server does not end");
    }
}

impl Drop for Server {
    fn drop(&mut self) {
        let _ = self.child.kill();
        let _ = self.child.wait();
    }
}

pub(crate) fn message(path: &str, body: Option<&str>, close: bool) -> String {
    let connection = if close { "close" } else { "keep-alive" };
    match body {
        None => format!("GET {path} HTTP/1.1\r\nHost: test\r\nConnection: {connection}\r\n\r\n"),
        Some(body) => format!(
            "POST {path} HTTP/1.1\r\nHost: test\r\nConnection: {connection}\r\nContent-Type: application/json\r\nContent-Length: {}\r\n\r\n{body}",
            body.len()
        ),
    }
}

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
fn silent_and_slow_clients_are_dropped() {
    let server = Server::start(&["--read-timeout", "1"]);
    let mut silent = server.connect();
    let mut slow = server.connect();
    slow.write_all(b"GET /healthz HTTP/1.1\r\nHos").expect("sent");
    let mut waiting = server.connect();
    waiting.write_all(message("/v1/forces", Some("{}"), true).replace("Length: 2", "Length: 200").as_bytes()).expect("sent");
    for stream in [&mut silent, &mut slow] {
        let mut answer = Vec::new();
        let _ = stream.read_to_end(&mut answer);
        let text = String::from_utf8_lossy(&answer);
        assert!(text.is_empty() || text.starts_with("HTTP/1.1 408"), "{text}");
    }
    let mut answer = String::new();
    waiting.read_to_string(&mut answer).expect("an answer");
    assert!(answer.starts_with("HTTP/1.1 408") && answer.contains("problem+json"), "{answer}");
}

#[test]
fn connections_beyond_the_limit_wait_for_a_place() {
    let server = Server::start(&["--max-connections", "2"]);
    let first = server.connect();
    let _second = server.connect();
    std::thread::sleep(Duration::from_millis(100));
    let mut third = server.connect();
    third.write_all(message("/healthz", None, true).as_bytes()).expect("sent");
    third.set_read_timeout(Some(Duration::from_millis(200))).expect("a timeout");
    assert!(third.read(&mut [0; 1]).is_err(), "the third has no place yet");
    drop(first);
    third.set_read_timeout(Some(PATIENCE)).expect("a timeout");
    let mut answer = String::new();
    third.read_to_string(&mut answer).expect("an answer");
    assert!(answer.starts_with("HTTP/1.1 200"));
}

/// A sweep that keeps one thread busy for a good while.
fn long_sweep() -> String {
    let mut body = letter();
    body["slip"] = serde_json::json!({"from": -1, "to": 1, "points": 10_001});
    body["soil"]["shear_modulus_m"] = 1e-5.into();
    body.as_object_mut().expect("an object").remove("sinkage_m");
    body["normal_load_n"] = 50.into();
    body.to_string()
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
fn open_requests_end_before_the_server_stops() {
    for signal in ["-TERM", "-INT"] {
        let mut server = Server::start(&["--grace", "20"]);
        let mut open = server.connect();
        open.write_all(message("/v1/slip-sweep", Some(&long_sweep()), false).as_bytes()).expect("sent");
        // The request is being worked on once its place is taken.
        let start = Instant::now();
        while !server.ask("/metrics", None).contains("compute_places_free 63") && start.elapsed() < PATIENCE {}
        server.signal(signal);
        let mut answer = String::new();
        open.read_to_string(&mut answer).expect("the whole answer, then the end");
        assert!(answer.starts_with("HTTP/1.1 200") && answer.ends_with("]}"), "{}", &answer[..200.min(answer.len())]);
        assert_eq!(server.exit_code(), Some(0));
        assert!(TcpStream::connect(server.address).is_err());
    }
}

#[test]
fn a_track_is_answered_over_the_wire_while_it_is_sent() {
    let server = Server::start(&["--compute-threads", "1"]);
    let mut stream = server.connect();
    let settings = "wheel.preset=letter&soil.preset=letter-sand&static_sinkage_m=0.02&method=explicit";
    let head = format!(
        "POST /v1/track?{settings} HTTP/1.1\r\nHost: test\r\nConnection: close\r\nContent-Type: text/csv\r\nTransfer-Encoding: chunked\r\n\r\n"
    );
    let chunk = |text: &str| format!("{:x}\r\n{text}\r\n", text.len());
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

#[test]
fn a_reader_that_does_not_read_fills_no_memory() {
    let server = Server::start(&[]);
    let memory = || {
        let status = std::fs::read_to_string(format!("/proc/{}/status", server.child.id())).expect("the state of a process");
        let line = status.lines().find(|line| line.starts_with("VmRSS:")).expect("its memory");
        line.split_whitespace().nth(1).and_then(|kilobytes| kilobytes.parse::<u64>().ok()).expect("a number")
    };
    let mut stream = server.connect();
    stream.set_write_timeout(Some(Duration::from_millis(500))).expect("a timeout");
    let settings = "wheel.preset=letter&soil.preset=letter-sand&static_sinkage_m=0.02&method=explicit";
    let head = format!(
        "POST /v1/track?{settings} HTTP/1.1\r\nHost: test\r\nContent-Type: text/csv\r\nContent-Length: 1000000000\r\n\r\ntime_s,slip\n"
    );
    stream.write_all(head.as_bytes()).expect("sent");
    let rows = "1,0.1\n".repeat(1000);
    std::thread::sleep(Duration::from_millis(200));
    let (before, start) = (memory(), Instant::now());
    // Answers are twenty times as long as the question: what the sockets hold is full long before this ends.
    while start.elapsed() < Duration::from_secs(4) && stream.write_all(rows.as_bytes()).is_ok() {}
    std::thread::sleep(Duration::from_millis(500));
    let growth = memory().saturating_sub(before);
    assert!(growth < 8 << 10, "memory grew by {growth} kB");
}
