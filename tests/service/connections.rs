//! Clients that are slow, silent or many, and how they are told apart from the others.

use std::io::{BufRead, BufReader, Read, Write};
use std::net::TcpStream;
use std::time::{Duration, Instant};

use crate::asking::letter;
use crate::heavy::stiff;
use crate::running::{PATIENCE, Server, TRACK, chunk, message, rest_of, sweep, track_head};

fn closed(reason: &str) -> String {
    format!("http_connections_closed_total{{reason=\"{reason}\"}}")
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
fn a_reader_that_does_not_read_fills_no_memory() {
    let server = Server::start(&[]);
    let memory = || {
        let status = std::fs::read_to_string(format!("/proc/{}/status", server.child.id())).expect("the state of a process");
        let line = status.lines().find(|line| line.starts_with("VmRSS:")).expect("its memory");
        line.split_whitespace().nth(1).and_then(|kilobytes| kilobytes.parse::<u64>().ok()).expect("a number")
    };
    let mut stream = server.connect();
    stream.set_write_timeout(Some(Duration::from_millis(500))).expect("a timeout");
    let head = format!(
        "POST {TRACK} HTTP/1.1\r\nHost: test\r\nContent-Type: text/csv\r\nContent-Length: 1000000000\r\n\r\ntime_s,slip\n"
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

#[test]
fn a_reader_that_takes_nothing_is_reset_and_gives_its_memory_back() {
    let server = Server::start(&["--write-timeout", "1", "--answer-memory", "65536"]);
    let free = server.metric("answer_memory_free_bytes");
    let mut stalled = server.connect();
    stalled.write_all(message("/v1/slip-sweep", Some(&sweep(10_001)), false).as_bytes()).expect("sent");
    server.wait_for("answer_memory_free_bytes", 0);
    let refused = server.ask("/v1/slip-sweep", Some(&sweep(2001)));
    assert!(
        refused.starts_with("HTTP/1.1 503") && refused.contains("retry-after") && refused.contains("problem+json"),
        "{refused}"
    );
    assert!(server.ask("/v1/forces", Some(&letter().to_string())).starts_with("HTTP/1.1 200"), "a small answer needs no share");
    server.wait_for(&closed("stalled"), 1);
    server.wait_for("answer_memory_free_bytes", free);
    assert!(rest_of(&stalled).len() < 1 << 20, "the rest of the answer was given up");
    let whole = server.ask("/v1/slip-sweep", Some(&sweep(10_001)));
    assert!(whole.starts_with("HTTP/1.1 200") && whole.len() > 1 << 20 && whole.ends_with('}'));
}

#[test]
fn a_reader_that_is_slow_but_steady_gets_all() {
    let server = Server::start(&["--write-timeout", "1", "--rate-window", "1"]);
    let mut stream = server.connect();
    stream.write_all(message("/v1/slip-sweep", Some(&sweep(10_001)), true).as_bytes()).expect("sent");
    let (mut answer, mut piece) = (Vec::new(), vec![0; 64 << 10]);
    loop {
        std::thread::sleep(Duration::from_millis(100));
        match stream.read(&mut piece).expect("a piece") {
            0 => break,
            length => answer.extend_from_slice(&piece[..length]),
        }
    }
    assert!(answer.len() > 1 << 20 && answer.ends_with(b"}"), "{} bytes", answer.len());
}

#[test]
fn an_answer_taken_below_the_slowest_rate_is_given_up() {
    let server = Server::start(&["--write-timeout", "60", "--rate-window", "1", "--min-download-rate", "4000000000"]);
    let mut stream = server.connect();
    stream.write_all(message("/v1/slip-sweep", Some(&sweep(10_001)), true).as_bytes()).expect("sent");
    server.wait_for(&closed("slow_reader"), 1);
    assert!(rest_of(&stream).len() < 1 << 20);
}

/// What a stream is answered whose rest comes in bits of these bytes, one each 300 ms.
fn answer_to_bits(server: &Server, bits: &[&str]) -> String {
    let mut stream = server.connect();
    stream.write_all((track_head() + &chunk("time_s,slip\n0,0.1\n")).as_bytes()).expect("sent");
    for bit in bits {
        std::thread::sleep(Duration::from_millis(300));
        if stream.write_all(chunk(bit).as_bytes()).is_err() {
            break;
        }
    }
    let _ = stream.write_all(b"0\r\n\r\n");
    let mut answer = String::new();
    let mut reader = BufReader::new(stream);
    while !answer.ends_with("0\r\n\r\n") && reader.read_line(&mut answer).is_ok_and(|length| length > 0) {}
    answer
}

#[test]
fn a_stream_that_drips_is_ended_and_one_that_is_slow_is_not() {
    let server = Server::start(&["--rate-window", "1", "--min-upload-rate", "10"]);
    let live: Vec<String> = (1..10).map(|second| format!("{second},0.1\n")).collect();
    let slow = answer_to_bits(&server, &live.iter().map(String::as_str).collect::<Vec<_>>());
    assert!(slow.contains("#end,10\n"), "{slow}");
    let dripping = answer_to_bits(&server, &["1"; 12]);
    assert!(dripping.contains("#error,the body came at less than 10 bytes a second") && !dripping.contains("#end"), "{dripping}");
    server.wait_for(&closed("slow_body"), 1);
    server.wait_for("stream_places_free", 64);
}

#[test]
fn who_waits_longest_makes_room_for_one_more() {
    let server = Server::start(&["--max-connections", "2", "--max-connections-per-peer", "2"]);
    let (first, mut second) = (server.connect(), server.connect());
    second.write_all(b"GET /healthz HTTP/1.1\r\nHost: te").expect("a part of a head");
    assert!(server.ask("/v1/forces", Some(&letter().to_string())).starts_with("HTTP/1.1 200"));
    assert!(rest_of(&first).is_empty());
    second.write_all(b"st\r\nConnection: close\r\n\r\n").expect("the rest of the head");
    assert!(rest_of(&second).starts_with(b"HTTP/1.1 200"), "it had a place until now");
    server.wait_for(&closed("made_room"), 1);
}

#[test]
fn a_peer_beyond_its_limit_gives_up_its_own_connections() {
    let server = Server::start(&["--max-connections", "100", "--max-connections-per-peer", "1"]);
    let first = server.connect();
    assert!(server.ask("/v1/forces", Some(&letter().to_string())).starts_with("HTTP/1.1 200"));
    assert!(rest_of(&first).is_empty());
}

#[test]
fn operators_are_answered_while_all_places_are_busy() {
    let server = Server::start(&["--max-connections", "1"]);
    let mut busy = server.connect();
    // Until it is asked for its body, it might be silent and give way.
    let request =
        message("/v1/slip-sweep", Some(&stiff(10_001).to_string()), true).replace("Host", "Expect: 100-continue\r\nHost");
    let (head, body) = request.split_once("\r\n\r\n").expect("a head and a body");
    busy.write_all(format!("{head}\r\n\r\n").as_bytes()).expect("sent");
    busy.read_exact(&mut [0; 12]).expect("100 Continue");
    busy.write_all(body.as_bytes()).expect("sent");
    server.wait_for("compute_places_free", 63);
    for path in ["/healthz", "/readyz", "/metrics"] {
        assert!(server.ask(path, None).starts_with("HTTP/1.1 200"), "{path}");
    }
    let mut other = server.connect();
    other.write_all(message("/v1/forces", Some(&letter().to_string()), false).as_bytes()).expect("sent");
    let refused = String::from_utf8(rest_of(&other)).expect("text");
    assert!(
        refused.starts_with("HTTP/1.1 503") && refused.contains("retry-after: 1") && refused.contains("connection: close"),
        "{refused}"
    );
    server.wait_for(&closed("no_place"), 1);
    drop(busy);
    let start = Instant::now();
    while !server.ask("/v1/forces", Some(&letter().to_string())).starts_with("HTTP/1.1 200") {
        assert!(start.elapsed() < PATIENCE, "the place is free again");
    }
}

#[test]
fn an_idle_connection_is_kept_longer_than_a_head_may_take() {
    let server = Server::start(&["--read-timeout", "1", "--keep-alive", "60"]);
    let mut stream = server.connect();
    let healthz = message("/healthz", None, false);
    let ask = |stream: &mut TcpStream| {
        stream.write_all(healthz.as_bytes()).expect("sent");
        let mut answer = [0; 4096];
        let length = stream.read(&mut answer).expect("an answer");
        assert!(answer[..length].starts_with(b"HTTP/1.1 200"));
    };
    ask(&mut stream);
    std::thread::sleep(Duration::from_millis(2500));
    ask(&mut stream);
    stream.write_all(&healthz.as_bytes()[..20]).expect("sent");
    assert!(rest_of(&stream).is_empty());
    server.wait_for(&closed("slow_head"), 1);
    let idle = Server::start(&["--keep-alive", "1"]);
    let mut stream = idle.connect();
    ask(&mut stream);
    assert!(rest_of(&stream).is_empty());
    idle.wait_for(&closed("idle"), 1);
}

#[test]
fn large_bodies_share_a_memory_and_small_ones_need_none() {
    let server = Server::start(&["--body-limit", "1048576", "--body-memory", "65536", "--read-timeout", "3"]);
    let free = server.metric("body_memory_free_bytes");
    let begun = || {
        let mut stream = server.connect();
        let head = message("/v1/forces", Some(""), false).replace("Length: 0", "Length: 1048576");
        stream.write_all(head.as_bytes()).expect("sent");
        // The server takes no more of it than it has memory for.
        stream.set_write_timeout(Some(Duration::from_millis(100))).expect("a timeout");
        let _ = stream.write_all(&vec![b' '; 900_000]);
        stream
    };
    let bodies: Vec<TcpStream> = (0..5).map(|_| begun()).collect();
    let start = Instant::now();
    while server.metric("body_memory_free_bytes") > free / 5 {
        assert!(start.elapsed() < PATIENCE, "one of them takes its share");
    }
    assert!(server.ask("/v1/forces", Some(&letter().to_string())).starts_with("HTTP/1.1 200"));
    // One of them has the memory until its time is over, the next one after it, and the others wait in vain.
    let answers: Vec<String> = bodies.iter().map(|body| String::from_utf8(rest_of(body)).expect("text")).collect();
    assert!(answers.iter().all(|answer| answer.contains("problem+json")), "{answers:?}");
    let with_status = |status: &str| answers.iter().filter(|answer| answer.starts_with(status)).count();
    assert!(with_status("HTTP/1.1 408") >= 1 && with_status("HTTP/1.1 503") >= 1, "{answers:?}");
    server.wait_for("body_memory_free_bytes", free);
}
