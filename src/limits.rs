//! The limits of the service.

use std::time::Duration;

use clap::ValueEnum;

use crate::compute::PoolBounds;

/// When the answer to a stream begins.
#[derive(Debug, Clone, Copy, Default, PartialEq, Eq, ValueEnum)]
pub enum Begin {
    /// When the body has ended, if its length was declared or it came by a proxy; else with the first row.
    #[default]
    Auto,
    /// With the first row.
    Early,
    /// When the body has ended.
    AfterBody,
}

/// Threads that read and write files.
const FILE_THREADS: usize = 4;

/// Limits of the service.
#[derive(Debug, Clone, Copy)]
pub struct Limits {
    /// Largest request body (bytes).
    pub body: usize,
    /// Memory for the bodies of all requests that arrive (bytes).
    pub bodies: usize,
    /// Memory for all answers that wait to be taken (bytes).
    pub answers: usize,
    /// Time in which a request body has to arrive.
    pub body_deadline: Duration,
    /// Time in which a long computation has to end.
    pub compute_deadline: Duration,
    /// Computations that run at once.
    pub compute_threads: usize,
    /// Long computations that may run or wait.
    pub compute_places: usize,
    /// Highest price of one computation (processor time).
    pub price: Duration,
    /// Streams that may be open.
    pub stream_places: usize,
    /// Time in which something of a stream has to arrive, and something of its answer has to be taken.
    pub stream_idle: Duration,
    /// Time in which a stream has to end.
    pub stream_deadline: Duration,
    /// When the answer to a stream begins.
    pub stream_begin: Begin,
    /// Room for all streams that are kept until they have ended, and for one of them (bytes of files).
    pub spool: usize,
}

impl Limits {
    pub(crate) fn pool(&self) -> PoolBounds {
        PoolBounds {
            threads: self.compute_threads,
            places: self.compute_places,
            stream_places: self.stream_places,
            deadline: self.compute_deadline,
            price_limit: self.price,
        }
    }

    /// Threads of the runtime that computations and files may hold at once, at the most.
    #[must_use]
    pub fn blocking_threads(&self) -> usize {
        self.pool().blocking_threads() + FILE_THREADS
    }
}

impl Default for Limits {
    fn default() -> Self {
        Self {
            body: 1 << 20,
            bodies: 32 << 20,
            answers: 32 << 20,
            body_deadline: Duration::from_secs(10),
            compute_deadline: Duration::from_secs(30),
            compute_threads: std::thread::available_parallelism().map_or(1, usize::from),
            compute_places: 64,
            price: Duration::from_secs(60),
            stream_places: 64,
            stream_idle: Duration::from_secs(30),
            stream_deadline: Duration::from_secs(3600),
            stream_begin: Begin::default(),
            spool: 1 << 30,
        }
    }
}
