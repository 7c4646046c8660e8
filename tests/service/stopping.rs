//! How the server stops.

use std::io::{Read, Write};
use std::net::TcpStream;
use std::time::{Duration, Instant};

use crate::asking::letter;
use crate::running::{PATIENCE, Server, chunk, long_sweep, message, rest_of, sweep, track_head};

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
        assert!(
            answer.starts_with("HTTP/1.1 200") && answer.contains("\r\nconnection: close\r\n") && answer.ends_with("]}"),
            "{}",
            &answer[..200.min(answer.len())]
        );
        assert_eq!(server.exit_code(), Some(0));
        assert!(TcpStream::connect(server.address).is_err());
    }
}

/// A connection with a stream that is answered as long as it goes on.
fn stream_to(server: &Server) -> TcpStream {
    let mut stream = server.connect();
    stream.write_all((track_head() + &chunk("time_s,slip\n0,0.1\n")).as_bytes()).expect("sent");
    stream.read_exact(&mut [0; 12]).expect("the head of the answer");
    stream
}

/// Waits until the server takes no new connections.
fn wait_until_closed(server: &Server) {
    let start = Instant::now();
    while TcpStream::connect(server.address).is_ok() {
        assert!(start.elapsed() < PATIENCE, "it stops to listen");
        std::thread::sleep(Duration::from_millis(20));
    }
}

#[test]
fn requests_that_do_not_end_in_the_grace_are_cut_off_and_said_to_be() {
    let mut server = Server::start(&["--grace", "1"]);
    let _open = stream_to(&server);
    server.signal("-TERM");
    assert_eq!(server.exit_code(), Some(1));
}

#[test]
fn a_second_signal_ends_at_once() {
    for (signal, code) in [("-TERM", 143), ("-INT", 130)] {
        let mut server = Server::start(&["--grace", "3600"]);
        let _open = stream_to(&server);
        server.signal("-TERM");
        wait_until_closed(&server);
        server.signal(signal);
        assert_eq!(server.exit_code(), Some(code));
    }
}

#[test]
fn a_reader_that_takes_nothing_does_not_outlast_the_grace() {
    let mut server = Server::start(&["--grace", "1", "--write-timeout", "3600"]);
    let mut stalled = server.connect();
    let free = server.metric("answer_memory_free_bytes");
    stalled.write_all(message("/v1/slip-sweep", Some(&sweep(10_001)), false).as_bytes()).expect("sent");
    let start = Instant::now();
    while server.metric("answer_memory_free_bytes") == free {
        assert!(start.elapsed() < PATIENCE, "the answer waits to be taken");
    }
    server.signal("-TERM");
    assert_eq!(server.exit_code(), Some(1));
}

#[test]
fn neither_idle_connections_nor_parts_of_heads_hold_the_stop_up() {
    let mut server = Server::start(&["--grace", "3600", "--read-timeout", "3600", "--keep-alive", "3600"]);
    let (silent, mut idle, mut partial) = (server.connect(), server.connect(), server.connect());
    idle.write_all(message("/healthz", None, false).as_bytes()).expect("sent");
    assert!(idle.read(&mut [0; 4096]).expect("an answer") > 0);
    partial.write_all(b"GET /healthz HTTP/1.1\r\nHos").expect("sent");
    server.wait_for("http_connections", 4);
    server.signal("-TERM");
    assert_eq!(server.exit_code(), Some(0));
    for stream in [&silent, &idle, &partial] {
        assert!(rest_of(stream).is_empty());
    }
}

#[test]
fn new_connections_are_still_answered_during_the_drain_delay() {
    let mut server = Server::start(&["--drain-delay", "2"]);
    assert!(server.ask("/readyz", None).starts_with("HTTP/1.1 200"));
    server.signal("-TERM");
    let start = Instant::now();
    while !server.ask("/readyz", None).starts_with("HTTP/1.1 503") {
        assert!(start.elapsed() < PATIENCE, "it is ready no more");
    }
    let mut stream = server.connect();
    stream.write_all(message("/v1/forces", Some(&letter().to_string()), false).as_bytes()).expect("sent");
    let answer = String::from_utf8(rest_of(&stream)).expect("text");
    assert!(answer.starts_with("HTTP/1.1 200") && answer.contains("\r\nconnection: close\r\n"), "{answer}");
    assert_eq!(server.exit_code(), Some(0));
}

#[test]
fn a_hang_up_changes_nothing() {
    let mut server = Server::start(&[]);
    server.signal("-HUP");
    assert!(server.ask("/healthz", None).starts_with("HTTP/1.1 200"));
    server.signal("-TERM");
    assert_eq!(server.exit_code(), Some(0));
}
