//! The body of a request, watched: a client that sends one keeps a pace while the server waits for it.

use std::pin::Pin;
use std::sync::Arc;
use std::task::{Context, Poll, ready};

use axum::body::{Bytes, HttpBody};
use hyper::body::{Frame, Incoming, SizeHint};
use tokio::time::{Instant, Sleep, sleep_until};

use super::Reason;
use super::link::Link;
use super::pace::{Pace, Slowest};

/// A body that came slower than this.
#[derive(Debug)]
pub(crate) struct TooSlow(pub(crate) Slowest);

impl std::fmt::Display for TooSlow {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        write!(f, "the body came at less than {} bytes a second over {} s", self.0.rate, self.0.window.as_secs_f64())
    }
}

impl std::error::Error for TooSlow {}

pub(super) struct Upload {
    body: Incoming,
    pace: Pace,
    timer: Option<Pin<Box<Sleep>>>,
    is_complete: bool,
    link: Arc<Link>,
}

impl Upload {
    pub(super) fn new(body: Incoming, link: Arc<Link>) -> Self {
        let is_complete = body.is_end_stream();
        Self { body, pace: Pace::new(link.bounds().slowest_upload), timer: None, is_complete, link }
    }

    /// Whether the client is too slow; the body waits for this.
    fn poll_too_slow(&mut self, context: &mut Context<'_>) -> Poll<()> {
        if self.pace.since().is_none() {
            self.pace.wait(Instant::now);
            self.link.awaits_body(self.pace.since());
        }
        while let Some(judged) = self.pace.judged_at() {
            let timer = self.timer.get_or_insert_with(|| Box::pin(sleep_until(judged)));
            if timer.deadline() != judged {
                timer.as_mut().reset(judged);
            }
            ready!(timer.as_mut().poll(context));
            if self.pace.is_too_slow(Instant::now()) {
                return Poll::Ready(());
            }
        }
        Poll::Pending
    }
}

impl HttpBody for Upload {
    type Data = Bytes;
    type Error = Box<dyn std::error::Error + Send + Sync>;

    fn poll_frame(mut self: Pin<&mut Self>, context: &mut Context<'_>) -> Poll<Option<Result<Frame<Bytes>, Self::Error>>> {
        match Pin::new(&mut self.body).poll_frame(context) {
            Poll::Pending => {
                ready!(self.poll_too_slow(context));
                self.link.close_for(Reason::SlowBody);
                Poll::Ready(Some(Err(TooSlow(self.link.bounds().slowest_upload).into())))
            }
            Poll::Ready(frame) => {
                if self.pace.since().is_some() {
                    self.link.awaits_body(None);
                }
                let bytes = frame.as_ref().and_then(|frame| frame.as_ref().ok()?.data_ref().map(Bytes::len)).unwrap_or(0);
                self.pace.moved(bytes, Instant::now);
                self.is_complete |= frame.is_none() || self.body.is_end_stream();
                Poll::Ready(frame.map(|frame| frame.map_err(Into::into)))
            }
        }
    }

    fn is_end_stream(&self) -> bool {
        self.body.is_end_stream()
    }

    fn size_hint(&self) -> SizeHint {
        self.body.size_hint()
    }
}

impl Drop for Upload {
    fn drop(&mut self) {
        self.link.awaits_body(None);
        if !self.is_complete {
            self.link.left_unread();
        }
    }
}
