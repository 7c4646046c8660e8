//! What operators ask: health, readiness, metrics.

use std::time::Duration;

use axum::extract::State;
use axum::http::header::CONTENT_TYPE;
use axum::response::{IntoResponse, Response};
use serde::Serialize;
use utoipa::ToSchema;

use super::responses::Limits;
use crate::answer::json;
use crate::problem::Problem;
use crate::state::Service;

/// State of the service.
#[derive(Serialize, ToSchema)]
struct Health {
    /// `ok`, or `ready`.
    #[schema(example = "ok")]
    status: &'static str,
    /// Version of the service.
    #[schema(example = "0.1.0")]
    version: &'static str,
}

/// Whether the process is alive
///
/// Answers as long as the process serves connections at all.
#[utoipa::path(get, path = "/healthz", tag = "operations", responses((status = 200, description = "It is alive", body = Health), Limits))]
pub(crate) async fn healthz() -> Result<Response, Problem> {
    json(&Health { status: "ok", version: env!("CARGO_PKG_VERSION") })
}

/// Whether the service takes requests
///
/// 503 from the moment the service was told to stop, so that a load balancer sends no more.
#[utoipa::path(get, path = "/readyz", tag = "operations", responses((status = 200, description = "It takes requests", body = Health), Limits))]
pub(crate) async fn readyz(State(service): State<Service>) -> Result<Response, Problem> {
    if service.is_stopping() {
        Err(Problem::Busy(Duration::ZERO))
    } else {
        json(&Health { status: "ready", version: env!("CARGO_PKG_VERSION") })
    }
}

/// Metrics for Prometheus
///
/// Requests by method, route and status, their durations, and the state of the pool for long computations.
#[utoipa::path(
    get,
    path = "/metrics",
    tag = "operations",
    responses((status = 200, description = "The metrics, in the OpenMetrics text format", body = String, content_type = "application/openmetrics-text"), Limits)
)]
pub(crate) async fn metrics(State(service): State<Service>) -> Result<Response, Problem> {
    let text = service.metrics().text().map_err(|error| {
        tracing::error!(%error, "the metrics could not be written");
        Problem::Internal
    })?;
    Ok(([(CONTENT_TYPE, "application/openmetrics-text; version=1.0.0; charset=utf-8")], text).into_response())
}
