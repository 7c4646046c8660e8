//! Requests whose bodies are sent piece by piece, and answers that are taken piece by piece.

use axum::body::{Body, Bytes};
use axum::response::Response;
use http_body_util::{BodyExt, channel};
use terramechanics_server::{Service, app};
use tower::ServiceExt;

use crate::asking::request;

pub(crate) type Sender = channel::Sender<Bytes, std::io::Error>;

/// A table whose pieces after the first are sent by hand, and the answer to it.
pub(crate) async fn open(service: Service, path: &str, first: &'static str) -> (Sender, Response) {
    let (mut sender, body) = channel::Channel::<Bytes, std::io::Error>::new(1);
    sender.send_data(first.into()).await.expect("room");
    let request = request("POST", path, &[("content-type", "text/csv")], Body::new(body));
    (sender, app(service).oneshot(request).await.expect("an answer"))
}

/// The next piece of an answer.
pub(crate) async fn next(body: &mut Body) -> String {
    let frame = body.frame().await.expect("more").expect("no error");
    String::from_utf8(frame.into_data().expect("data").to_vec()).expect("text")
}
