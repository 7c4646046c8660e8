//! Answers that are written while the question still arrives.
//!
//! A stream has a place of its own kind on the pool and at most one piece of input and one of output in memory. The next input is taken only
//! when the output before it was, so a slow reader slows the writer down.

use axum::body::{Body, Bytes, HttpBody};
use axum::http::HeaderValue;
use axum::http::header::CONTENT_TYPE;
use axum::response::{IntoResponse, Response};
use http_body_util::{BodyExt, channel};
use tokio::time::{Instant, timeout, timeout_at};

use crate::body;
use crate::compute::Place;
use crate::limits::Limits;
use crate::problem::Problem;

/// Output after which a slice ends (bytes). A slice is handed to another thread and back, which takes as long as a hundred cheap rows.
pub(crate) const PIECE: usize = 64 << 10;

/// Room for the row that goes beyond the end of a piece (bytes).
const OVERHANG: usize = 1 << 10;

/// How far a slice of work came.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum Progress {
    /// All of the input is used.
    NeedsInput,
    /// The slice is over; there is input left.
    Paused,
    /// The answer is complete.
    Complete,
}

/// Work that turns pieces of input into pieces of output.
pub(crate) trait Work: Send + 'static {
    /// The media type of the output.
    fn media_type(&self) -> &'static str;

    /// Does a slice: takes what it uses off `input` and adds to `output`. With `last` nothing comes after `input`.
    ///
    /// # Errors
    /// Why the answer ends here.
    fn slice(&mut self, input: &mut Bytes, last: bool, output: &mut Vec<u8>) -> Result<Progress, Problem>;

    /// Tells the reader of an answer that has begun why it is not complete.
    fn broken(&self, problem: &Problem, output: &mut Vec<u8>);
}

/// The answer that `work` makes of `body`. What goes wrong before the first output is a problem; afterwards it is told at the
/// end of the answer.
pub(crate) async fn answer<W: Work>(work: W, body: Body, place: Place, limits: &Limits) -> Result<Response, Problem> {
    let media_type = HeaderValue::from_static(work.media_type());
    let mut stream = Stream::new(work, body, place, limits);
    let first = stream.next().await?.unwrap_or_default();
    if let Some(problem) = stream.failed {
        return Err(problem);
    }
    let body = if stream.work.is_none() {
        Body::from(first)
    } else {
        let (sender, receiver) = channel::Channel::<Bytes>::new(1);
        tokio::spawn(stream.pump(first, sender));
        Body::new(receiver)
    };
    Ok(([(CONTENT_TYPE, media_type)], body).into_response())
}

struct Stream<W> {
    /// None when the answer is complete.
    work: Option<Box<W>>,
    body: Body,
    input: Bytes,
    last: bool,
    place: Place,
    limits: Limits,
    deadline: Instant,
    /// Why the answer ends with the piece before.
    failed: Option<Problem>,
}

impl<W: Work> Stream<W> {
    fn new(work: W, body: Body, place: Place, limits: &Limits) -> Self {
        let deadline = Instant::now() + limits.stream_deadline;
        Self {
            work: Some(Box::new(work)),
            body,
            input: Bytes::new(),
            last: false,
            place,
            limits: *limits,
            deadline,
            failed: None,
        }
    }

    /// The next piece of output; none at the end. After a problem the work is still there, to tell of it; one behind a piece of
    /// output waits in `failed`.
    async fn next(&mut self) -> Result<Option<Bytes>, Problem> {
        let mut output = Vec::new();
        while let Some(mut work) = self.work.take() {
            if let Err(problem) = self.receive().await {
                self.work = Some(work);
                return Err(problem);
            }
            // What is large is allocated and freed on this side of the pool, for blocks that another thread frees are kept longer.
            let whole = std::mem::take(&mut self.input);
            let (mut input, last) = (whole.clone(), self.last);
            output = Vec::with_capacity(PIECE + OVERHANG);
            let slice = move || {
                let progress = work.slice(&mut input, last, &mut output);
                (work, input, output, progress)
            };
            let (work, progress);
            (work, self.input, output, progress) = self.place.run(slice).await?;
            drop(whole);
            match progress {
                Ok(Progress::Complete) => {}
                Ok(_) => self.work = Some(work),
                Err(problem) => {
                    self.work = Some(work);
                    if output.is_empty() {
                        return Err(problem);
                    }
                    self.failed = Some(problem);
                }
            }
            if !output.is_empty() {
                break;
            }
        }
        Ok((!output.is_empty()).then(|| output.into()))
    }

    /// Waits for input, if there is none left and more can come.
    async fn receive(&mut self) -> Result<(), Problem> {
        let late = Problem::Late(self.limits.stream_deadline);
        if self.deadline <= Instant::now() {
            return Err(late);
        }
        while self.input.is_empty() && !self.last {
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

    /// Sends the output until it is complete, or its reader has gone or takes nothing any more.
    async fn pump(mut self, first: Bytes, mut sender: channel::Sender<Bytes>) {
        let mut piece = first;
        loop {
            match timeout(self.limits.stream_idle, sender.send_data(piece)).await {
                Ok(Ok(())) => {}
                Ok(Err(_)) => return tracing::debug!("the reader of a stream has gone"),
                Err(_) => return tracing::debug!("the reader of a stream takes nothing"),
            }
            let next = match self.failed.take() {
                None => self.next().await,
                Some(problem) => Err(problem),
            };
            piece = match next {
                Ok(Some(piece)) => piece,
                Ok(None) => return,
                Err(problem) => {
                    let mut output = Vec::new();
                    if let Some(work) = self.work.take() {
                        work.broken(&problem, &mut output);
                    }
                    output.into()
                }
            };
            if piece.is_empty() {
                return;
            }
        }
    }
}
