//! What all requests share: the limits, the pool for computations, the counters.

use std::sync::Arc;
use std::sync::atomic::{AtomicBool, Ordering};
use std::time::Duration;

use crate::budget::Budget;
use crate::compute::{Pool, PoolBounds};
use crate::metrics::Metrics;

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
}

impl Limits {
    fn pool(&self) -> PoolBounds {
        PoolBounds {
            threads: self.compute_threads,
            places: self.compute_places,
            stream_places: self.stream_places,
            deadline: self.compute_deadline,
            price_limit: self.price,
        }
    }

    /// Threads of the runtime that computations may hold at once, at the most.
    #[must_use]
    pub fn blocking_threads(&self) -> usize {
        self.pool().blocking_threads()
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
        }
    }
}

/// What all requests share.
#[derive(Debug, Clone)]
pub struct Service(Arc<Shared>);

#[derive(Debug)]
struct Shared {
    limits: Limits,
    pool: Pool,
    bodies: Budget,
    answers: Budget,
    metrics: Metrics,
    stopping: AtomicBool,
}

impl Service {
    /// A service with these limits.
    #[must_use]
    pub fn new(limits: Limits) -> Self {
        let pool = Pool::new(&limits.pool());
        let (bodies, answers) = (Budget::new(limits.bodies), Budget::new(limits.answers));
        let metrics = Metrics::new(&pool, &bodies, &answers);
        Self(Arc::new(Shared { limits, pool, bodies, answers, metrics, stopping: AtomicBool::new(false) }))
    }

    /// From now on the service is not ready.
    pub fn stop(&self) {
        self.0.stopping.store(true, Ordering::Relaxed);
    }

    pub(crate) fn is_stopping(&self) -> bool {
        self.0.stopping.load(Ordering::Relaxed)
    }

    pub(crate) fn limits(&self) -> &Limits {
        &self.0.limits
    }

    pub(crate) fn pool(&self) -> &Pool {
        &self.0.pool
    }

    /// Memory for bodies that are read whole.
    pub(crate) fn bodies(&self) -> &Budget {
        &self.0.bodies
    }

    /// Memory for large answers.
    pub(crate) fn answers(&self) -> &Budget {
        &self.0.answers
    }

    /// The counters of the service.
    #[must_use]
    pub fn metrics(&self) -> &Metrics {
        &self.0.metrics
    }
}
