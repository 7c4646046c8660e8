//! The answer of a stream as it is taken.

use std::time::Duration;

use axum::body::{Body, Bytes};
use axum::http::header::CONTENT_TYPE;
use axum::http::{HeaderName, HeaderValue};
use axum::response::{IntoResponse, Response};
use http_body_util::channel;
use tokio::time::timeout;

use crate::problem::Problem;

/// An answer in pieces.
pub(super) trait Pieces: Send + 'static {
    /// The next piece of output; none at the end.
    fn next(&mut self) -> impl Future<Output = Result<Option<Bytes>, Problem>> + Send;

    /// Why the answer ends with the piece before, if it does.
    fn take_failed(&mut self) -> Option<Problem>;

    /// Whether nothing comes after the piece before.
    fn is_complete(&self) -> bool;

    /// What tells the reader of an answer that has begun why it is not complete; none where its form has no place for that, and
    /// the connection is to break.
    fn broken(&mut self, problem: &Problem) -> Option<Bytes>;
}

/// The response with these pieces; the problem where there is one before the first piece was sent.
pub(super) async fn respond<P: Pieces>(mut pieces: P, media_type: &'static str, idle: Duration) -> Result<Response, Problem> {
    let first = pieces.next().await?.unwrap_or_default();
    if let Some(problem) = pieces.take_failed() {
        return Err(problem);
    }
    let body = if pieces.is_complete() {
        Body::from(first)
    } else {
        let (sender, receiver) = channel::Channel::<Bytes, Broken>::new(1);
        tokio::spawn(pump(pieces, first, sender, idle));
        Body::new(receiver)
    };
    // nginx would otherwise collect the rows of a slow stream before it passes them on.
    let headers = [
        (CONTENT_TYPE, HeaderValue::from_static(media_type)),
        (HeaderName::from_static("x-accel-buffering"), HeaderValue::from_static("no")),
    ];
    Ok((headers, body).into_response())
}

/// The answer is not complete.
#[derive(Debug)]
struct Broken;

impl std::fmt::Display for Broken {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        f.write_str("the answer is not complete")
    }
}

impl std::error::Error for Broken {}

/// Sends the output until it is complete, or its reader has gone or takes nothing any more.
async fn pump<P: Pieces>(mut pieces: P, first: Bytes, mut sender: channel::Sender<Bytes, Broken>, idle: Duration) {
    let mut piece = first;
    loop {
        match timeout(idle, sender.send_data(piece)).await {
            Ok(Ok(())) => {}
            Ok(Err(_)) => return tracing::debug!("the reader of a stream has gone"),
            Err(_) => return tracing::debug!("the reader of a stream takes nothing"),
        }
        let next = match pieces.take_failed() {
            None => pieces.next().await,
            Some(problem) => Err(problem),
        };
        piece = match next {
            Ok(Some(piece)) => piece,
            Ok(None) => return,
            Err(problem) => match pieces.broken(&problem) {
                Some(piece) => piece,
                None => return sender.abort(Broken),
            },
        };
        if piece.is_empty() {
            return;
        }
    }
}
