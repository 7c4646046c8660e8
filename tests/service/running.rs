//! A running server, as a process of its own.

use std::io::{BufRead, BufReader, Read, Write};
use std::net::{SocketAddr, TcpStream};
use std::process::{Child, Command, Stdio};
use std::time::{Duration, Instant};

pub(crate) const PROGRAM: &str = env!("CARGO_BIN_EXE_terramechanics");

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

    /// The server's own count of something.
    pub(crate) fn metric(&self, name: &str) -> u64 {
        let metrics = self.ask("/metrics", None);
        let line = metrics.lines().find_map(|line| line.strip_prefix(name)?.strip_prefix(' '));
        line.and_then(|value| value.trim().parse().ok()).unwrap_or_else(|| panic!("no {name} in {metrics}"))
    }

    /// Waits until the server counts something so.
    pub(crate) fn wait_for(&self, name: &str, value: u64) {
        let start = Instant::now();
        while self.metric(name) != value {
            assert!(start.elapsed() < PATIENCE, "{name} is {}, not {value}", self.metric(name));
            std::thread::sleep(Duration::from_millis(20));
        }
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

/// All that still comes on a connection, until it is closed or reset.
pub(crate) fn rest_of(mut stream: &TcpStream) -> Vec<u8> {
    let mut rest = Vec::new();
    if let Err(error) = stream.read_to_end(&mut rest) {
        assert_ne!(error.kind(), std::io::ErrorKind::WouldBlock, "the connection is still open");
    }
    rest
}

/// A sweep by the explicit method, whose answer is long and soon made.
pub(crate) fn sweep(points: u32) -> String {
    let mut body = crate::asking::letter();
    body["slip"] = serde_json::json!({"from": 0, "to": 1, "points": points});
    body["method"] = "explicit".into();
    body.to_string()
}

/// The path of a track with its settings, for a table of times and slips.
pub(crate) const TRACK: &str = "/v1/track?wheel.preset=letter&soil.preset=letter-sand&static_sinkage_m=0.02&method=explicit";

/// The head of a table in chunks, sent to be followed.
pub(crate) fn track_head() -> String {
    format!("POST {TRACK} HTTP/1.1\r\nHost: test\r\nContent-Type: text/csv\r\nTransfer-Encoding: chunked\r\n\r\n")
}

pub(crate) fn chunk(text: &str) -> String {
    format!("{:x}\r\n{text}\r\n", text.len())
}

/// A sweep that keeps one thread busy for a good while.
pub(crate) fn long_sweep() -> String {
    let mut body = crate::asking::letter();
    body["slip"] = serde_json::json!({"from": -1, "to": 1, "points": 10_001});
    body["soil"]["shear_modulus_m"] = 1e-5.into();
    body.as_object_mut().expect("an object").remove("sinkage_m");
    body["normal_load_n"] = 50.into();
    body.to_string()
}
