//! `POST` and `GET /v1/slip-sweep`.

use axum::extract::State;
use axum::response::Response;

use super::responses::{InvalidBody, InvalidQuery, Limits};
use crate::answer::written;
use crate::compute::{Cost, Pace};
use crate::extract::{Asked, Format, FormatParameter, Input};
use crate::found;
use crate::problem::Problem;
use crate::reply::SweepReply;
use crate::request::{SweepCase, SweepRequest};
use crate::state::Service;

/// Forces and torque of a wheel over slip
///
/// A point without a solution is null in every solved column, and a warning says why. With `Accept: text/csv` the columns come
/// as a table.
#[utoipa::path(
    post,
    path = "/v1/slip-sweep",
    tag = "forces",
    request_body = SweepRequest,
    responses((status = 200, description = "Forces and torque of a wheel over slip", content((SweepReply = "application/json"), (String = "text/csv"))), InvalidBody, Limits)
)]
pub(crate) async fn slip_sweep(
    State(service): State<Service>,
    format: Format,
    Input(query): Input<SweepCase>,
) -> Result<Response, Problem> {
    answer(&service, query, format).await
}

/// Forces and torque of a wheel over slip, asked by a query
///
/// The twin of the POST: a field is a parameter, one inside an object has the object's name and a dot before its own
/// (`soil.cohesion_pa=200`). The slips are `slip.from`, `slip.to` and `slip.points`. The answer, the checks and the problems are those of the POST; their pointers
/// (`/soil/cohesion_pa`) have a slash for the dot.
#[utoipa::path(
    get,
    path = "/v1/slip-sweep",
    tag = "forces",
    params(SweepRequest, FormatParameter),
    responses((status = 200, description = "Forces and torque of a wheel over slip", content((SweepReply = "application/json"), (String = "text/csv"))), InvalidQuery, Limits)
)]
pub(crate) async fn slip_sweep_of_query(
    State(service): State<Service>,
    Asked { query, format }: Asked<SweepCase>,
) -> Result<Response, Problem> {
    answer(&service, query, format).await
}

async fn answer(service: &Service, query: SweepCase, format: Format) -> Result<Response, Problem> {
    let cost = Cost::of_points([query.operation], query.slips.len());
    let work = move |pace: &Pace| written(&SweepReply::from(found::sweep(&query, pace)?), format);
    service.pool().run(cost, work).await
}
