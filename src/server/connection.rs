//! One connection from its first byte to its close.

use std::convert::Infallible;
use std::pin::{Pin, pin};
use std::sync::Arc;
use std::task::{Context, Poll};

use axum::Router;
use axum::body::{Body, Bytes, HttpBody};
use axum::http::header::CONNECTION;
use axum::http::{HeaderValue, Request, Response};
use axum::response::IntoResponse;
use hyper::body::{Frame, Incoming, SizeHint};
use hyper::server::conn::http1;
use hyper::service::service_fn;
use hyper_util::rt::TokioIo;
use tokio::net::TcpStream;
use tokio::sync::watch;
use tokio::time::{Instant, sleep_until};
use tower::Service as _;

use super::Reason;
use super::link::Link;
use super::transport::Transport;
use super::upload::Upload;
use crate::problem::Problem;
use crate::state::Service;

/// The paths that are answered when all places are taken.
const OF_OPERATORS: [&str; 3] = ["/healthz", "/readyz", "/metrics"];

/// What all connections share.
#[derive(Clone)]
pub(super) struct Shared {
    pub(super) builder: http1::Builder,
    pub(super) app: Router,
    pub(super) service: Service,
    /// True once the server takes no new connections.
    pub(super) stopping: watch::Receiver<bool>,
}

/// Serves a connection until it is closed, and says why it was.
pub(super) async fn serve(stream: TcpStream, link: Arc<Link>, mut shared: Shared) -> Reason {
    let answering = service_fn(|request: Request<Incoming>| {
        let busy = Busy::new(&link);
        answer(request, busy, shared.app.clone(), shared.service.clone())
    });
    let connection = shared.builder.serve_connection(TokioIo::new(Transport::new(stream, link.clone())), answering);
    let mut connection = pin!(connection);
    let mut stopping = pin!(shared.stopping.wait_for(|is_stopping| *is_stopping));
    let mut is_stopping = false;
    let mut timer = pin!(sleep_until(link.deadline().unwrap_or_else(Instant::now)));
    std::future::poll_fn(|context| {
        // What the link waits for changes only in here, so that one look at its deadline afterwards is enough.
        if let Poll::Ready(result) = connection.as_mut().poll(context) {
            return Poll::Ready(ended(result));
        }
        if !is_stopping && stopping.as_mut().poll(context).is_ready() {
            is_stopping = true;
            link.stopping();
            // A request that has just come was read above: it is answered, and the connection then closed.
            connection.as_mut().graceful_shutdown();
            if let Poll::Ready(result) = connection.as_mut().poll(context) {
                return Poll::Ready(ended(result));
            }
        }
        loop {
            let Some(deadline) = link.deadline() else { return Poll::Pending };
            // Mostly a deadline moves on. The timer is then left as it is, to look again when it is over.
            if timer.is_elapsed() || deadline < timer.deadline() {
                timer.as_mut().reset(deadline);
            }
            std::task::ready!(timer.as_mut().poll(context));
            if let Some(reason) = link.overdue(Instant::now()) {
                return Poll::Ready(reason);
            }
        }
    })
    .await
}

fn ended(result: hyper::Result<()>) -> Reason {
    match result {
        Ok(()) => Reason::Done,
        Err(error) => {
            tracing::debug!(%error, "a connection broke");
            Reason::Broken
        }
    }
}

/// The answer to a request, as long as the connection may ask for it.
async fn answer(
    request: Request<Incoming>,
    busy: Busy,
    mut app: Router,
    service: Service,
) -> Result<Response<Answer>, Infallible> {
    let is_refused = busy.0.is_reserve && !OF_OPERATORS.contains(&request.uri().path());
    let mut response = if is_refused {
        busy.0.close_for(Reason::NoPlace);
        Problem::Crowded.into_response()
    } else {
        app.call(request.map(|body| Upload::new(body, busy.0.clone()))).await?
    };
    if busy.0.is_reserve || service.is_stopping() {
        response.headers_mut().insert(CONNECTION, HeaderValue::from_static("close"));
    }
    Ok(response.map(|body| Answer { body, _busy: busy }))
}

/// While this is there, a request of the connection is being answered.
struct Busy(Arc<Link>);

impl Busy {
    fn new(link: &Arc<Link>) -> Self {
        link.asked();
        Self(link.clone())
    }
}

impl Drop for Busy {
    fn drop(&mut self) {
        self.0.answered();
    }
}

/// The body of an answer, which ends the request when it is dropped.
struct Answer {
    body: Body,
    _busy: Busy,
}

impl HttpBody for Answer {
    type Data = Bytes;
    type Error = axum::Error;

    fn poll_frame(mut self: Pin<&mut Self>, context: &mut Context<'_>) -> Poll<Option<Result<Frame<Bytes>, axum::Error>>> {
        Pin::new(&mut self.body).poll_frame(context)
    }

    fn is_end_stream(&self) -> bool {
        self.body.is_end_stream()
    }

    fn size_hint(&self) -> SizeHint {
        self.body.size_hint()
    }
}
