//! Answers that are written while the question still arrives.
//!
//! A stream has a place of its own kind on the pool and at most one piece of input and one of output in memory. The next input is taken only
//! when the output before it was, so a slow reader slows the writer down.

mod blocks;
mod incoming;
mod outgoing;
mod whole;

pub(crate) use blocks::{BlockWork, Job, Taken, answer_in_blocks};
pub(crate) use whole::ready;

use axum::body::{Body, Bytes};
use axum::response::Response;

use crate::compute::Place;
use crate::limits::Limits;
use crate::problem::Problem;
use incoming::Incoming;
use outgoing::{Pieces, respond};

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
    let media_type = work.media_type();
    let incoming = Incoming::new(body, limits);
    let stream = Stream { work: Some(Box::new(work)), incoming, place, failed: None };
    respond(stream, media_type, limits.stream_idle).await
}

struct Stream<W> {
    /// None when the answer is complete.
    work: Option<Box<W>>,
    incoming: Incoming,
    place: Place,
    /// Why the answer ends with the piece before.
    failed: Option<Problem>,
}

impl<W: Work> Pieces for Stream<W> {
    /// After a problem the work is still there, to tell of it; one behind a piece of output waits in `failed`.
    async fn next(&mut self) -> Result<Option<Bytes>, Problem> {
        let mut output = Vec::new();
        while let Some(mut work) = self.work.take() {
            if let Err(problem) = self.incoming.receive().await {
                self.work = Some(work);
                return Err(problem);
            }
            // What is large is allocated and freed on this side of the pool, for blocks that another thread frees are kept longer.
            let whole = std::mem::take(&mut self.incoming.input);
            let (mut input, last) = (whole.clone(), self.incoming.last);
            output = Vec::with_capacity(PIECE + OVERHANG);
            let slice = move || {
                let progress = work.slice(&mut input, last, &mut output);
                (work, input, output, progress)
            };
            let (work, progress);
            (work, self.incoming.input, output, progress) = self.place.run(slice).await?;
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

    fn take_failed(&mut self) -> Option<Problem> {
        self.failed.take()
    }

    fn is_complete(&self) -> bool {
        self.work.is_none()
    }

    fn broken(&mut self, problem: &Problem) -> Option<Bytes> {
        let mut output = Vec::new();
        if let Some(work) = self.work.take() {
            work.broken(problem, &mut output);
        }
        Some(output.into())
    }
}
