//! Answers whose rows are independent of each other: several blocks of them are computed at once, and sent in their order.

use std::collections::VecDeque;
use std::sync::Arc;

use axum::body::{Body, Bytes};
use axum::response::Response;
use tokio::task::JoinHandle;

use super::incoming::Incoming;
use super::outgoing::{Pieces, respond};
use crate::compute::Place;
use crate::limits::Limits;
use crate::problem::Problem;

/// A block of rows under way.
pub(crate) trait Job: Send + 'static {
    /// Does a slice of the work; true when all is done.
    fn slice(&mut self) -> bool;
}

/// What comes of a piece of input.
pub(crate) enum Taken<J> {
    /// All of the input is used, and no block is full.
    NeedsInput,
    /// A block is full.
    Block(Box<J>),
    /// The input is at its end; the last block, if it has rows.
    End(Option<Box<J>>),
}

/// Work that makes blocks of its input.
pub(crate) trait BlockWork: Send + 'static {
    /// What is done for a block, apart from the other blocks.
    type Job: Job;

    /// The media type of the output.
    fn media_type(&self) -> &'static str;

    /// Whether there are more rows without further input.
    fn holds_input(&self) -> bool;

    /// Takes what makes a block off `input`. With `last` nothing comes after it.
    ///
    /// # Errors
    /// Why there are no more blocks.
    fn take(&mut self, input: &mut Bytes, last: bool) -> Result<Taken<Self::Job>, Problem>;

    /// The block that is not full yet, if it has rows.
    fn flush(&mut self) -> Option<Box<Self::Job>>;

    /// The output of a block that is done; blocks come in their order.
    ///
    /// # Errors
    /// Why the answer ends here.
    fn give(&mut self, job: Box<Self::Job>) -> Result<Bytes, Problem>;

    /// The output after all blocks.
    fn end(&mut self) -> Bytes;

    /// Tells the reader of an answer that has begun why it is not complete; none where the form has no place for that.
    fn broken(&self, problem: &Problem) -> Option<Bytes>;
}

/// The answer that `work` makes of `body`, with so many blocks at once as the pool has threads, and one that is ready.
pub(crate) async fn answer_in_blocks<W: BlockWork>(
    work: W,
    body: Body,
    place: Place,
    limits: &Limits,
) -> Result<Response, Problem> {
    let media_type = work.media_type();
    let blocks = Blocks {
        work: Some(Box::new(work)),
        incoming: Incoming::new(body, limits),
        place: Arc::new(place),
        width: limits.compute_threads + 1,
        under_way: VecDeque::new(),
        has_all: false,
        failed: None,
    };
    respond(blocks, media_type, limits.stream_idle).await
}

struct Blocks<W: BlockWork> {
    /// None when the answer is complete.
    work: Option<Box<W>>,
    incoming: Incoming,
    place: Arc<Place>,
    /// Blocks that may be under way.
    width: usize,
    under_way: VecDeque<UnderWay<W::Job>>,
    /// Whether no more blocks come.
    has_all: bool,
    /// Why no more blocks come, to be told behind those that are under way.
    failed: Option<Problem>,
}

/// A block under way; it ends with its slice when nobody waits for it any more.
struct UnderWay<J>(JoinHandle<Result<Box<J>, Problem>>);

impl<J> Drop for UnderWay<J> {
    fn drop(&mut self) {
        self.0.abort();
    }
}

/// Does a job in slices, so that other work has its turns.
async fn done<J: Job>(place: Arc<Place>, mut job: Box<J>) -> Result<Box<J>, Problem> {
    loop {
        let is_done;
        (job, is_done) = place
            .run(move || {
                let is_done = job.slice();
                (job, is_done)
            })
            .await?;
        if is_done {
            return Ok(job);
        }
    }
}

impl<W: BlockWork> Blocks<W> {
    fn start(&mut self, job: Box<W::Job>) {
        self.under_way.push_back(UnderWay(tokio::spawn(done(self.place.clone(), job))));
    }

    fn stop(&mut self, problem: Problem) {
        self.has_all = true;
        self.failed = Some(problem);
    }

    /// Makes blocks of the input that is there.
    async fn take(&mut self) -> Result<(), Problem> {
        let Some(mut work) = self.work.take() else { return Ok(()) };
        let whole = std::mem::take(&mut self.incoming.input);
        let (mut input, last) = (whole.clone(), self.incoming.last);
        let take = move || {
            let taken = work.take(&mut input, last);
            (work, input, taken)
        };
        let (work, input, taken) = self.place.run(take).await?;
        drop(whole); // on this side of the pool
        (self.work, self.incoming.input) = (Some(work), input);
        match taken {
            Ok(Taken::NeedsInput) => {}
            Ok(Taken::Block(job)) => self.start(job),
            Ok(Taken::End(job)) => {
                self.has_all = true;
                job.into_iter().for_each(|job| self.start(job));
            }
            Err(problem) => {
                let rest = self.work.as_mut().and_then(|work| work.flush());
                rest.into_iter().for_each(|job| self.start(job));
                self.stop(problem);
            }
        }
        Ok(())
    }

    /// Waits for input or for the first block, whichever comes first; the block, if it was that.
    async fn wait(&mut self) -> Result<Option<Box<W::Job>>, Problem> {
        let takes = !self.has_all && self.under_way.len() < self.width;
        let is_ready = self.work.as_ref().is_some_and(|work| work.holds_input());
        let received = match self.under_way.front_mut() {
            None if takes => {
                // Rows that are there are not kept back for others that may come late.
                tokio::select! {
                    biased;
                    received = self.incoming.receive_unless(is_ready) => received,
                    () = std::future::ready(()) => {
                        match self.work.as_mut().and_then(|work| work.flush()) {
                            Some(job) => return { self.start(job); Ok(None) },
                            None => self.incoming.receive_unless(is_ready).await,
                        }
                    }
                }
            }
            None => return Ok(None),
            Some(UnderWay(first)) => tokio::select! {
                biased;
                received = self.incoming.receive_unless(is_ready), if takes => received,
                job = first => {
                    self.under_way.pop_front();
                    return job.map_err(|error| {
                        tracing::error!(%error, "a block was lost");
                        Problem::Internal
                    })?.map(Some);
                }
            },
        };
        match received {
            Ok(()) => self.take().await?,
            Err(problem) => self.stop(problem),
        }
        Ok(None)
    }
}

impl<W: BlockWork> Pieces for Blocks<W> {
    async fn next(&mut self) -> Result<Option<Bytes>, Problem> {
        while let Some(work) = &mut self.work {
            if self.has_all && self.under_way.is_empty() {
                if let Some(problem) = self.failed.take() {
                    return Err(problem);
                }
                let end = work.end();
                self.work = None;
                return Ok(Some(end));
            }
            if let Some(job) = self.wait().await?
                && let Some(work) = &mut self.work
            {
                return work.give(job).map(Some);
            }
        }
        Ok(None)
    }

    fn take_failed(&mut self) -> Option<Problem> {
        if self.under_way.is_empty() { self.failed.take() } else { None }
    }

    fn is_complete(&self) -> bool {
        self.work.is_none()
    }

    fn broken(&mut self, problem: &Problem) -> Option<Bytes> {
        self.work.take()?.broken(problem)
    }
}
