//! The question of a stream as it arrives.

use axum::body::{Body, Bytes, HttpBody};
use http_body_util::BodyExt;
use tokio::time::{Instant, timeout_at};

use crate::body;
use crate::limits::Limits;
use crate::problem::Problem;

/// A body that is taken piece by piece, each within its time and all within theirs.
pub(super) struct Incoming {
    body: Body,
    /// What is there and was not used yet.
    pub(super) input: Bytes,
    /// Whether nothing comes after it.
    pub(super) last: bool,
    limits: Limits,
    deadline: Instant,
}

impl Incoming {
    pub(super) fn new(body: Body, limits: &Limits) -> Self {
        let deadline = Instant::now() + limits.stream_deadline;
        Self { body, input: Bytes::new(), last: false, limits: *limits, deadline }
    }

    /// What is there and what still comes.
    pub(super) fn into_rest(self) -> (Bytes, Body) {
        (self.input, self.body)
    }

    /// Waits for input, if there is none left and more can come. A wait that is given up loses nothing.
    ///
    /// # Errors
    /// [`Problem::Late`], [`Problem::Idle`], and what is wrong with the body.
    pub(super) async fn receive(&mut self) -> Result<(), Problem> {
        self.receive_unless(false).await
    }

    /// The same, without a wait for input where there is something to do.
    ///
    /// # Errors
    /// As [`receive`](Self::receive).
    pub(super) async fn receive_unless(&mut self, is_ready: bool) -> Result<(), Problem> {
        let late = Problem::Late(self.limits.stream_deadline);
        if self.deadline <= Instant::now() {
            return Err(late);
        }
        while self.input.is_empty() && !self.last && !is_ready {
            let idle = Instant::now() + self.limits.stream_idle;
            match timeout_at(idle.min(self.deadline), self.body.frame()).await {
                Err(_) if self.deadline <= idle => return Err(late),
                Err(_) => return Err(Problem::Idle(self.limits.stream_idle)),
                Ok(Some(Err(error))) => return Err(body::problem(&error)),
                Ok(Some(Ok(frame))) => {
                    self.input = frame.into_data().unwrap_or_default();
                    // Where the end is known with the last piece, a fault at the end of a short body is a problem still.
                    self.last = self.body.is_end_stream();
                }
                Ok(None) => self.last = true,
            }
        }
        Ok(())
    }
}
