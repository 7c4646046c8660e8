//! The service put together: one function makes the router that the program serves and the tests call.

use std::sync::Arc;
use std::sync::atomic::{AtomicBool, Ordering};
use std::time::Duration;

use axum::Router;
use axum::http::Uri;
use axum::middleware;
use axum::response::{IntoResponse, Response};
use tower_http::catch_panic::CatchPanicLayer;

use crate::budget::Budget;
use crate::compute::Pool;
use crate::metrics::Metrics;
use crate::problem::Problem;
use crate::{docs, observe, openapi, page, paths};

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
    /// Long computations that may run or wait.
    pub compute_places: usize,
    /// Streams that may be open.
    pub stream_places: usize,
    /// Time in which something of a stream has to arrive, and something of its answer has to be taken.
    pub stream_idle: Duration,
    /// Time in which a stream has to end.
    pub stream_deadline: Duration,
}

impl Default for Limits {
    fn default() -> Self {
        Self {
            body: 1 << 20,
            bodies: 32 << 20,
            answers: 32 << 20,
            body_deadline: Duration::from_secs(10),
            compute_deadline: Duration::from_secs(30),
            compute_places: 64,
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
        let pool = Pool::new(limits.compute_places, limits.stream_places, limits.compute_deadline);
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

/// The router of the service, with every layer on.
pub fn app(service: Service) -> Router {
    layered(openapi::documented_routes().merge(page::routes()).merge(docs::routes()), service)
}

/// `routes` with the fallbacks and layers of the service.
pub fn layered(routes: Router<Service>, service: Service) -> Router {
    routes
        .fallback(|uri: Uri| async move { nothing_at(uri.path()) })
        .method_not_allowed_fallback(|uri: Uri| async move { Problem::MethodNotAllowed(paths::methods_of(uri.path())) })
        .layer(CatchPanicLayer::custom(panicked))
        .layer(middleware::from_fn_with_state(service.clone(), observe::observe))
        .with_state(service)
}

fn nothing_at(path: &str) -> Problem {
    let meant = paths::meant_by(path).map_or_else(String::new, |meant| format!("; did you mean {meant}?"));
    Problem::NotFound(format!("no such path: {path}{meant}"))
}

fn panicked(cause: Box<dyn std::any::Any + Send>) -> Response {
    let text = cause.downcast_ref::<&str>().copied().or_else(|| cause.downcast_ref::<String>().map(String::as_str));
    tracing::error!(cause = text.unwrap_or("unknown"), "a request panicked");
    Problem::Internal.into_response()
}
