//! Counters for operators, in the OpenMetrics format.

mod system;

use std::fmt;
use std::time::Duration;

use prometheus_client::encoding::{EncodeLabelSet, text::encode};
use prometheus_client::metrics::counter::Counter;
use prometheus_client::metrics::family::Family;
use prometheus_client::metrics::gauge::Gauge;
use prometheus_client::metrics::histogram::{Histogram, exponential_buckets};
use prometheus_client::registry::{Registry, Unit};

use self::system::System;
use crate::budget::Budget;
use crate::compute::Pool;
use crate::log;
use crate::server::Reason;

#[derive(Debug, Clone, PartialEq, Eq, Hash, EncodeLabelSet)]
struct RequestLabels {
    method: &'static str,
    route: String,
    status: u16,
}

#[derive(Debug, Clone, PartialEq, Eq, Hash, EncodeLabelSet)]
struct RouteLabels {
    route: String,
}

#[derive(Debug, Clone, PartialEq, Eq, Hash, EncodeLabelSet)]
struct ClosedLabels {
    reason: &'static str,
}

#[derive(Debug, Clone, PartialEq, Eq, Hash, EncodeLabelSet)]
struct ClassLabels {
    class: &'static str,
}

/// The counters of the service.
pub struct Metrics {
    registry: Registry,
    requests: Family<RequestLabels, Counter>,
    durations: Family<RouteLabels, Histogram, fn() -> Histogram>,
    system: System,
    connections: Gauge,
    closed: Family<ClosedLabels, Counter>,
    places: Gauge,
    stream_places: Gauge,
    waiting: Family<ClassLabels, Gauge>,
    body_memory: Gauge,
    answer_memory: Gauge,
    pool: Pool,
    bodies: Budget,
    answers: Budget,
}

impl fmt::Debug for Metrics {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.debug_struct("Metrics").finish_non_exhaustive()
    }
}

impl Metrics {
    pub(crate) fn new(pool: &Pool, bodies: &Budget, answers: &Budget) -> Self {
        let mut registry = Registry::default();
        let requests = Family::default();
        // 20 µs to 21 s
        let durations: Family<_, _, fn() -> Histogram> =
            Family::new_with_constructor(|| Histogram::new(exponential_buckets(20e-6, 4.0, 11)));
        let (connections, places, stream_places) = (Gauge::default(), Gauge::default(), Gauge::default());
        let (body_memory, answer_memory) = (Gauge::default(), Gauge::default());
        let closed = Family::default();
        for reason in Reason::ALL {
            drop(closed.get_or_create(&ClosedLabels { reason: reason.name() }));
        }
        registry.register("http_requests", "Requests answered", requests.clone());
        registry.register_with_unit(
            "http_request_duration",
            "Time to the beginning of an answer",
            Unit::Seconds,
            durations.clone(),
        );
        registry.register("http_connections", "Open connections", connections.clone());
        registry.register("log_lines_dropped", "Lines of the log that could not be written in time", log::dropped());
        registry.register("http_connections_closed", "Connections closed, by the reason", closed.clone());
        registry.register_with_unit("body_memory_free", "Free memory for bodies", Unit::Bytes, body_memory.clone());
        registry.register_with_unit("answer_memory_free", "Free memory for large answers", Unit::Bytes, answer_memory.clone());
        registry.register("compute_places_free", "Free places for long computations", places.clone());
        registry.register("stream_places_free", "Free places for streams", stream_places.clone());
        let waiting = Family::default();
        registry.register("compute_waiting", "Computations that wait for a thread", waiting.clone());
        let tally = pool.tally();
        registry.register_with_unit("compute_price", "Prices of long computations", Unit::Seconds, tally.prices.clone());
        registry.register("compute_failures", "Computations without a result, by the reason", tally.failed.clone());
        let system = System::registered(&mut registry);
        Self {
            registry,
            requests,
            durations,
            connections,
            closed,
            places,
            stream_places,
            waiting,
            system,
            body_memory,
            answer_memory,
            pool: pool.clone(),
            bodies: bodies.clone(),
            answers: answers.clone(),
        }
    }

    /// A request was answered.
    pub(crate) fn request(&self, method: &axum::http::Method, route: &str, status: u16, duration: Duration) {
        let method = ["GET", "POST", "HEAD"].into_iter().find(|known| method.as_str() == *known).unwrap_or("other");
        let labels = RequestLabels { method, route: route.to_owned(), status };
        self.requests.get_or_create(&labels).inc();
        let labels = RouteLabels { route: labels.route };
        self.durations.get_or_create(&labels).observe(duration.as_secs_f64());
    }

    /// A connection was opened.
    pub(crate) fn connected(&self) {
        self.connections.inc();
    }

    /// A connection was closed.
    pub(crate) fn disconnected(&self, reason: Reason) {
        self.connections.dec();
        self.closed.get_or_create(&ClosedLabels { reason: reason.name() }).inc();
    }

    /// All metrics as text.
    pub(crate) fn text(&self) -> Result<String, fmt::Error> {
        for (gauge, free) in [
            (&self.places, self.pool.free_places()),
            (&self.stream_places, self.pool.free_stream_places()),
            (&self.body_memory, self.bodies.free()),
            (&self.answer_memory, self.answers.free()),
        ] {
            gauge.set(i64::try_from(free).unwrap_or(i64::MAX));
        }
        for (class, waiting) in ["short", "long"].into_iter().zip(self.pool.waiting()) {
            self.waiting.get_or_create(&ClassLabels { class }).set(i64::try_from(waiting).unwrap_or(i64::MAX));
        }
        self.system.read();
        let mut text = String::new();
        encode(&mut text, &self.registry)?;
        Ok(text)
    }
}
