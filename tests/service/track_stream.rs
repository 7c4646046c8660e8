//! `/v1/track` as a stream: the order of things, back-pressure, cuts and limits.

use std::time::Duration;

use axum::body::{Body, Bytes};
use axum::http::StatusCode;
use http_body_util::{BodyExt, channel};
use terramechanics_server::{Limits, Service, app};
use tower::ServiceExt;

use crate::asking::{letter, request, runtime, send_to};
use crate::by_hand::{self, Sender, next};
use crate::track::{TABLE, path, settings};

async fn open(service: Service) -> (Sender, axum::response::Response) {
    by_hand::open(
        service,
        &path(&settings()),
        "time_s,slip
0,0.1
",
    )
    .await
}

#[test]
fn the_first_row_leaves_before_the_last_arrives() {
    runtime().block_on(async {
        let (mut sender, response) = open(Service::new(Limits::default())).await;
        assert_eq!(response.status(), StatusCode::OK);
        let mut body = response.into_body();
        let first = next(&mut body).await;
        assert!(first.starts_with("time_s,slip,") && first.contains("\n0.0,0.1,") && !first.contains("#end"), "{first}");
        for i in 1..4 {
            sender.send_data(format!("{i},0.1\n").into()).await.expect("room");
            assert!(next(&mut body).await.starts_with(&format!("{i}.0,0.1,")));
        }
        drop(sender);
        assert!(next(&mut body).await.ends_with("#end,4\n"));
        assert!(body.frame().await.is_none());
    });
}

#[test]
fn a_stream_that_is_cut_lacks_the_end_and_says_why() {
    runtime().block_on(async {
        let (sender, response) = open(Service::new(Limits::default())).await;
        sender.abort(std::io::Error::other("the rover is gone"));
        let text = response.into_body().collect().await.expect("a body").to_bytes();
        let text = String::from_utf8(text.to_vec()).expect("text");
        assert!(!text.contains("#end") && text.lines().last().is_some_and(|line| line.starts_with("#error,")), "{text}");

        let (mut sender, response) = open(Service::new(Limits::default())).await;
        let mut body = response.into_body();
        next(&mut body).await;
        sender.send_data("1,0.1\n2\n3,0.1\n".into()).await.expect("room");
        let text = String::from_utf8(body.collect().await.expect("a body").to_bytes().to_vec()).expect("text");
        let (row, error) = text.split_once('\n').expect("two lines");
        assert!(row.starts_with("1.0,0.1,"), "the rows before it are there: {text}");
        assert_eq!(error, "#error,line 4, column 2: the number of cells is 1, the header has 2\n");
    });
}

#[test]
fn a_stream_that_stands_still_is_ended() {
    let limits = Limits { stream_idle: Duration::from_millis(50), ..Limits::default() };
    runtime().block_on(async {
        let (sender, response) = open(Service::new(limits)).await;
        let text = response.into_body().collect().await.expect("a body").to_bytes();
        assert!(text.ends_with(b"#error,nothing was sent or taken for 0.05 s\n"), "{text:?}");
        drop(sender);
    });
    let (sender, silent) = channel::Channel::<Bytes>::new(1);
    let answer =
        send_to(Service::new(limits), request("POST", &path(&settings()), &[("content-type", "text/csv")], Body::new(silent)));
    answer.problem(408);
    drop(sender);
}

#[test]
fn a_stream_has_a_time_in_which_it_has_to_end() {
    let limits = Limits { stream_deadline: Duration::from_millis(100), ..Limits::default() };
    runtime().block_on(async {
        let (mut sender, response) = open(Service::new(limits)).await;
        let mut body = response.into_body();
        next(&mut body).await;
        tokio::time::sleep(2 * limits.stream_deadline).await;
        let _ = sender.send_data("1,0.1\n".into()).await;
        let text = String::from_utf8(body.collect().await.expect("a body").to_bytes().to_vec()).expect("text");
        assert!(text.contains("#error,no answer within 0.1 s") && !text.contains("#end"), "{text}");
    });
}

#[test]
fn a_slow_reader_slows_the_writer_down() {
    runtime().block_on(async {
        let (mut sender, response) = open(Service::new(Limits::default())).await;
        let piece = Bytes::from("1,0.1\n".repeat(1000));
        // Nobody reads: some pieces fit into what is between the two, then no more.
        let mut taken = 0;
        while taken < 1000 {
            match tokio::time::timeout(Duration::from_millis(500), sender.send_data(piece.clone())).await {
                Ok(sent) => sent.expect("the service still listens"),
                Err(_) => break,
            }
            taken += 1;
        }
        assert!(taken < 10, "{taken} pieces were taken though nobody reads");
        // Once somebody does, all comes through.
        let reader = tokio::spawn(response.into_body().collect());
        for _ in taken..12 {
            sender.send_data(piece.clone()).await.expect("room");
        }
        drop(sender);
        let text = reader.await.expect("no panic").expect("a body").to_bytes();
        let rows = text.split(|byte| *byte == b'\n').filter(|line| line.starts_with(b"1.0,")).count();
        assert!(rows == 12_000 || rows == 13_000, "{rows}"); // the piece that timed out may have been taken
        assert!(text.ends_with(format!("#end,{}\n", rows + 1).as_bytes()));
    });
}

#[test]
fn an_open_stream_has_a_place_of_its_own_kind_and_a_full_house_is_told_before_the_start() {
    let service = Service::new(Limits { stream_places: 1, compute_places: 1, ..Limits::default() });
    runtime().block_on(async {
        let (sender, response) = open(service.clone()).await;
        let refused = request("POST", &path(&settings()), &[("content-type", "text/csv")], TABLE);
        let busy = app(service.clone()).oneshot(refused).await.expect("an answer");
        assert_eq!(busy.status(), StatusCode::SERVICE_UNAVAILABLE);
        assert!(busy.headers().contains_key("retry-after"));
        let mut sweep = letter();
        sweep["slip"] = serde_json::json!({"from": 0, "to": 1, "points": 101});
        let long = request("POST", "/v1/slip-sweep", &[("content-type", "application/json")], sweep.to_string());
        let computed = app(service.clone()).oneshot(long).await.expect("an answer");
        assert_eq!(computed.status(), StatusCode::OK, "computations have places of their own");
        drop(sender);
        response.into_body().collect().await.expect("a body");
        let (sender, response) = open(service).await;
        assert_eq!(response.status(), StatusCode::OK, "the place is free again");
        drop((sender, response));
    });
}
