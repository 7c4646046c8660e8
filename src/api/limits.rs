//! `GET /v1/limits`.

use axum::extract::State;
use axum::response::Response;
use serde::Serialize;
use utoipa::ToSchema;

use super::responses::{InvalidQuery, Limits};
use crate::answer::json;
use crate::compute::{OVERDRAFT, Point, allowance};
use crate::extract::NoQuery;
use crate::problem::Problem;
use crate::state::Service;

/// What the service takes, and what a computation may cost.
#[derive(Debug, Serialize, ToSchema)]
#[schema(as = ServiceLimits)]
pub(crate) struct LimitsReply {
    /// Largest request body (bytes), after it is unpacked; streams have no limit.
    body_bytes: usize,
    /// Time in which a request body has to arrive (s).
    body_time_s: f64,
    /// Time in which a computation has to end (s); it waits for others in that time as well.
    compute_time_s: f64,
    /// Long computations that may run or wait.
    compute_places: usize,
    /// Streams that may be open.
    stream_places: usize,
    /// Time in which a stream has to end (s).
    stream_time_s: f64,
    /// Memory for large answers that wait to be taken (bytes), over all connections.
    answer_bytes: usize,
    price: PriceReply,
}

/// What a computation may cost, in seconds of processor time. The price of a sweep or a comparison is the sum over its points, series
/// by series, plus the allowance. Work that is answered as a whole is ended where it takes `overdraft` times its price, a stream at
/// `stream_time_s`.
#[derive(Debug, Serialize, ToSchema)]
#[schema(as = Price)]
struct PriceReply {
    /// Highest price of a request that is answered as a whole (s).
    limit_s: f64,
    /// Highest price of a sweep that is answered as a stream, row by row (s): it may take as long as a stream may.
    stream_limit_s: f64,
    /// Allowance on top of the price of several points (s), for contacts that are stiffer than most.
    allowance_s: f64,
    /// How many times its price a computation may take (–).
    overdraft: u32,
    /// One for each kind of operating point.
    points: Vec<PointPrice>,
}

/// The price of one operating point among several.
#[derive(Debug, Serialize, ToSchema)]
struct PointPrice {
    /// The kind of operating point.
    work: &'static str,
    /// Its price (s).
    price_s: f64,
}

/// What the service takes, and what a computation may cost
///
/// The bounds that hold for every request, and how its price follows from its input. A price above the limit is refused before the
/// work begins (422, `too-costly`). A batch or a track that streams has no price, because nobody knows its rows before they arrive: it
/// ends at `stream_time_s`.
#[utoipa::path(get, path = "/v1/limits", tag = "operations", responses((status = 200, description = "The limits", body = LimitsReply), InvalidQuery, Limits))]
pub(crate) async fn limits(State(service): State<Service>, _: NoQuery) -> Result<Response, Problem> {
    let limits = service.limits();
    json(&LimitsReply {
        body_bytes: limits.body,
        body_time_s: limits.body_deadline.as_secs_f64(),
        compute_time_s: limits.compute_deadline.as_secs_f64(),
        compute_places: limits.compute_places,
        stream_places: limits.stream_places,
        stream_time_s: limits.stream_deadline.as_secs_f64(),
        answer_bytes: limits.answers,
        price: PriceReply {
            limit_s: limits.price.as_secs_f64(),
            stream_limit_s: limits.stream_deadline.as_secs_f64(),
            allowance_s: allowance().as_secs_f64(),
            overdraft: OVERDRAFT,
            points: Point::all().map(|point| PointPrice { work: point.work, price_s: point.price().as_secs_f64() }).collect(),
        },
    })
}
