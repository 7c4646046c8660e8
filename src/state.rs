//! What all requests share: the limits, the pool for computations, the counters.

use std::hash::{DefaultHasher, Hash, Hasher};
use std::sync::Arc;
use std::sync::atomic::{AtomicBool, Ordering};

use crate::budget::Budget;
use crate::compute::Pool;
use crate::limits::Limits;
use crate::metrics::Metrics;
use crate::outside::Outside;

/// The part of the memory for large answers that may be used beside it to pack them: one of so many.
const PACKERS: usize = 4;

/// What all requests share.
#[derive(Debug, Clone)]
pub struct Service(Arc<Shared>);

#[derive(Debug)]
struct Shared {
    limits: Limits,
    outside: Outside,
    pool: Pool,
    bodies: Budget,
    answers: Budget,
    packers: Budget,
    spool: Budget,
    settings: u64,
    metrics: Metrics,
    stopping: AtomicBool,
}

impl Service {
    /// A service with these limits.
    #[must_use]
    pub fn new(limits: Limits) -> Self {
        Self::seen_as(limits, Outside::default())
    }

    /// A service with these limits that is seen so from outside.
    #[must_use]
    pub fn seen_as(limits: Limits, outside: Outside) -> Self {
        let pool = Pool::new(&limits.pool());
        let (bodies, answers) = (Budget::new(limits.bodies), Budget::new(limits.answers));
        let (packers, spool) = (Budget::new(limits.answers / PACKERS), Budget::new(limits.spool));
        let mut settings = DefaultHasher::new();
        format!("{limits:?}").hash(&mut settings);
        let settings = settings.finish();
        let metrics = Metrics::new(&pool, &bodies, &answers);
        Self(Arc::new(Shared {
            limits,
            outside,
            pool,
            bodies,
            answers,
            packers,
            spool,
            settings,
            metrics,
            stopping: AtomicBool::new(false),
        }))
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

    /// Memory for packing answers on their way.
    pub(crate) fn packers(&self) -> &Budget {
        &self.0.packers
    }

    /// A number that is another one where a limit is.
    pub(crate) fn settings(&self) -> u64 {
        self.0.settings
    }

    /// Room for streams that are kept until they have ended.
    pub(crate) fn spool(&self) -> &Budget {
        &self.0.spool
    }

    /// How the service is seen from outside.
    pub(crate) fn outside(&self) -> &Outside {
        &self.0.outside
    }

    /// The counters of the service.
    #[must_use]
    pub fn metrics(&self) -> &Metrics {
        &self.0.metrics
    }
}
