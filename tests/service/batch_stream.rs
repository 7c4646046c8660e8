//! `/v1/batch` as a stream: the order of things, cuts, limits, and those who go.

use std::time::Duration;

use axum::body::{Body, Bytes};
use axum::http::StatusCode;
use http_body_util::{BodyExt, channel};
use terramechanics_server::{Limits, Service, app};
use tower::ServiceExt;

use crate::asking::{request, runtime, send_to};
use crate::batch::CSV;
use crate::by_hand::{self, Sender, next};

const PATH: &str = "/v1/batch?wheel.preset=letter&soil.preset=letter-sand&normal_load_n=80&method=explicit";

async fn open(service: Service) -> (Sender, axum::response::Response) {
    by_hand::open(
        service,
        PATH,
        "slip
0.1
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
        assert!(first.starts_with("slip,") && first.contains("\n0.1,") && !first.contains("#end"), "{first}");
        for slip in ["0.2", "0.3"] {
            sender.send_data(format!("{slip}\n").into()).await.expect("room");
            assert!(next(&mut body).await.starts_with(&format!("{slip},")));
        }
        drop(sender);
        let rest = body.collect().await.expect("a body").to_bytes();
        assert!(rest.ends_with(b"#end,3\n"), "{rest:?}");
    });
}

#[test]
fn a_batch_that_is_cut_lacks_the_end_and_says_why() {
    runtime().block_on(async {
        let (sender, response) = open(Service::new(Limits::default())).await;
        sender.abort(std::io::Error::other("the sender is gone"));
        let text = response.into_body().collect().await.expect("a body").to_bytes();
        let text = String::from_utf8(text.to_vec()).expect("text");
        assert!(!text.contains("#end") && text.lines().last().is_some_and(|line| line.starts_with("#error,")), "{text}");

        let (mut sender, response) = open(Service::new(Limits::default())).await;
        let mut body = response.into_body();
        next(&mut body).await;
        sender.send_data("0.2\n\"0.3\n".into()).await.expect("room");
        drop(sender);
        let text = String::from_utf8(body.collect().await.expect("a body").to_bytes().to_vec()).expect("text");
        let (row, error) = text.split_once('\n').expect("two lines");
        assert!(row.starts_with("0.2,"), "the rows before it are there: {text}");
        assert!(error.starts_with("#error,line 4") && error.contains("not closed"), "{text}");
    });
}

#[test]
fn a_batch_that_stands_still_is_ended() {
    let limits = Limits { stream_idle: Duration::from_millis(50), ..Limits::default() };
    runtime().block_on(async {
        let (sender, response) = open(Service::new(limits)).await;
        let text = response.into_body().collect().await.expect("a body").to_bytes();
        assert!(text.ends_with(b"#error,nothing was sent or taken for 0.05 s\n"), "{text:?}");
        drop(sender);
    });
    let (sender, silent) = channel::Channel::<Bytes>::new(1);
    let answer = send_to(Service::new(limits), request("POST", PATH, &[("content-type", CSV)], Body::new(silent)));
    answer.problem(408);
    drop(sender);
}

/// A reader that goes ends the work: its place, of which there is one, is free again long before all rows could have been computed.
#[test]
fn a_reader_that_goes_frees_its_place() {
    let service = Service::new(Limits { stream_places: 1, ..Limits::default() });
    runtime().block_on(async {
        // Rows without end, as long as they are taken.
        let (mut sender, body) = channel::Channel::<Bytes, std::io::Error>::new(1);
        let feeding = tokio::spawn(async move {
            let rows: Bytes = "0.1\n".repeat(4000).into();
            let mut taken = sender.send_data("slip\n".into()).await;
            while taken.is_ok() {
                taken = sender.send_data(rows.clone()).await;
            }
        });
        let asked = |body: Body| request("POST", PATH, &[("content-type", CSV)], body);
        let response = app(service.clone()).oneshot(asked(Body::new(body))).await.expect("an answer");
        let mut body = response.into_body();
        next(&mut body).await;
        let other = app(service.clone()).oneshot(asked(Body::from("slip\n0.1\n"))).await.expect("an answer");
        assert_eq!(other.status(), StatusCode::SERVICE_UNAVAILABLE);
        drop(body);
        tokio::time::timeout(Duration::from_secs(30), feeding).await.expect("nothing is taken any more").expect("no panic");
        let mut freed = false;
        for _ in 0..300 {
            let other = app(service.clone()).oneshot(asked(Body::from("slip\n0.1\n"))).await.expect("an answer");
            freed = other.status() == StatusCode::OK;
            if freed {
                break;
            }
            tokio::time::sleep(Duration::from_millis(100)).await;
        }
        assert!(freed);
    });
}
