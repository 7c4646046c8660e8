//! `POST /v1/sweep`.

mod blocks;
mod example;
mod found;
mod grid;
mod reply;
pub(crate) mod request;

use axum::body::Body;
use axum::extract::State;
use axum::http::HeaderMap;
use axum::response::Response;

use super::responses::{InvalidBody, Limits};
use crate::answer::json;
use crate::compute::{Cost, Pace, Stop};
use crate::extract::{Format, Input, RowsForm};
use crate::problem::Problem;
use crate::request::Accepted;
use crate::state::Service;
use crate::stream;
use blocks::GridBlocks;
pub(crate) use example::example;
use found::Running;
use reply::GridReply;
use request::{GridCase, GridRequest};

impl GridCase {
    fn cost(&self) -> Cost {
        match self {
            Self::Forces(sweep) => sweep.cost(),
            Self::Vehicle(sweep) => sweep.cost(),
        }
    }

    /// The answer as columns.
    ///
    /// # Errors
    /// [`Stop`], where the work is to end.
    pub(crate) fn reply(&self, pace: &Pace) -> Result<GridReply, Stop> {
        match self {
            Self::Forces(sweep) => GridReply::of(Running::of(sweep), pace),
            Self::Vehicle(sweep) => GridReply::of(Running::of(sweep), pace),
        }
    }
}

/// Forces, or a rover, over a grid of any fields
///
/// A request is asked at every point of a grid of one to three of its numeric fields, which need not stand in it: a field of a
/// preset varies by its name. The rows are all combinations, the last axis fastest. A row without an answer is null, `status` says
/// how it went, and a warning why; the fields that warnings name are those of `request`.
///
/// With `Accept: text/csv`, `application/x-ndjson` or `application/vnd.apache.arrow.stream` the rows come as they are computed, up
/// to a million of them, in constant memory; in JSON, which is also sent where `Accept` names no form that is there, an answer has at
/// most 100000. Behind the rows of a CSV stand comments:
/// `#warning,<code>,<detail>` for each warning, and `#end,<rows>` as the last line of a whole answer. In NDJSON the last line is an
/// object with `end`, `rows` and `warnings`. An answer without that line was cut; where the reason is known the last line is
/// `#error,<detail>`, or an object with `error`. The last record batch of a whole Arrow stream has no rows, and its metadata have
/// `rows`, `warnings` and `assumed`; a stream that cannot be completed breaks off, and the connection with it. One axis over `/slip` gives the numbers of /v1/slip-sweep, save that a sinkage that is solved for a load may differ in
/// the twelfth digit, because every point is solved by itself here.
#[utoipa::path(
    post,
    path = "/v1/sweep",
    tag = "forces",
    request_body = GridRequest,
    responses((status = 200, description = "Forces, or a rover, over a grid", content((GridReply = "application/json"), (String = "text/csv"), (String = "application/x-ndjson"), (String = "application/vnd.apache.arrow.stream"))), InvalidBody, Limits)
)]
pub(crate) async fn sweep(
    State(service): State<Service>,
    headers: HeaderMap,
    _: Format,
    Input(Accepted { case, .. }): Input<GridCase>,
) -> Result<Response, Problem> {
    let cost = case.cost();
    let Some(form) = RowsForm::preferred_to_json(&headers) else {
        case.fits_in_columns()?;
        return service.pool().run(cost, move |pace| json(&case.reply(pace)?)).await;
    };
    let limits = *service.limits();
    let place = service.pool().stream_place_for(cost, limits.stream_deadline)?;
    match case {
        GridCase::Forces(sweep) => {
            stream::answer_in_blocks(GridBlocks::of(Running::of(&sweep), form), Body::empty(), place, &limits).await
        }
        GridCase::Vehicle(sweep) => {
            stream::answer_in_blocks(GridBlocks::of(Running::of(&sweep), form), Body::empty(), place, &limits).await
        }
    }
}
