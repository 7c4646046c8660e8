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
    public_url: Option<String>,
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
        Self::known_as(limits, None)
    }

    /// A service with these limits that those outside find at this address.
    #[must_use]
    pub fn known_as(limits: Limits, public_url: Option<String>) -> Self {
        let pool = Pool::new(&limits.pool());
        let (bodies, answers) = (Budget::new(limits.bodies), Budget::new(limits.answers));
        let spool = Budget::new(limits.spool);
        let metrics = Metrics::new(&pool, &bodies, &answers);
        Self(Arc::new(Shared { limits, public_url, pool, bodies, answers, spool, metrics, stopping: AtomicBool::new(false) }))
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

    /// Where those outside find the service, if it was said.
    pub(crate) fn public_url(&self) -> Option<&str> {
        self.0.public_url.as_deref()
    }

    /// The counters of the service.
    #[must_use]
    pub fn metrics(&self) -> &Metrics {
        &self.0.metrics
    }
}
