//! What all requests share: the limits, the pool for computations, the counters.

use std::sync::Arc;
use std::sync::atomic::{AtomicBool, Ordering};

use crate::budget::Budget;
use crate::compute::Pool;
use crate::limits::Limits;
use crate::metrics::Metrics;

/// What all requests share.
#[derive(Debug, Clone)]
pub struct Service(Arc<Shared>);

#[derive(Debug)]
struct Shared {
    limits: Limits,
    pool: Pool,
    bodies: Budget,
    answers: Budget,
    spool: Budget,
    metrics: Metrics,
    stopping: AtomicBool,
}

impl Service {
    /// A service with these limits.
    #[must_use]
    pub fn new(limits: Limits) -> Self {
        let pool = Pool::new(&limits.pool());
        let (bodies, answers) = (Budget::new(limits.bodies), Budget::new(limits.answers));
        let spool = Budget::new(limits.spool);
        let metrics = Metrics::new(&pool, &bodies, &answers);
        Self(Arc::new(Shared { limits, pool, bodies, answers, spool, metrics, stopping: AtomicBool::new(false) }))
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

    /// Room for streams that are kept until they have ended.
    pub(crate) fn spool(&self) -> &Budget {
        &self.0.spool
    }

    /// The counters of the service.
    #[must_use]
    pub fn metrics(&self) -> &Metrics {
        &self.0.metrics
    }
}
