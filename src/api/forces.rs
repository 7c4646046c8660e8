//! `POST` and `GET /v1/forces`.

use axum::extract::State;
use axum::response::Response;

use super::responses::{InvalidBody, InvalidQuery, Limits};
use crate::answer::written;
use crate::compute::{Cost, Pace};
use crate::extract::{Asked, Format, FormatParameter, Input};
use crate::found;
use crate::problem::Problem;
use crate::reply::ForcesReply;
use crate::request::{ForcesCase, ForcesRequest};
use crate::state::Service;

/// Forces and torque of a wheel at one operating point
///
/// Drawbar pull, normal force and torque with their four parts, by the integral of the stresses or by a closed form. With
/// `Accept: text/csv` the numbers come as a table of one row.
#[utoipa::path(
    post,
    path = "/v1/forces",
    tag = "forces",
    request_body = ForcesRequest,
    responses((status = 200, description = "Forces and torque of a wheel at one operating point", content((ForcesReply = "application/json"), (String = "text/csv"))), InvalidBody, Limits)
)]
pub(crate) async fn forces(
    State(service): State<Service>,
    format: Format,
    Input(query): Input<ForcesCase>,
) -> Result<Response, Problem> {
    answer(&service, query, format).await
}

/// Forces and torque of a wheel at one operating point, asked by a query
///
/// The twin of the POST: a field is a parameter, one inside an object has the object's name and a dot before its own
/// (`soil.cohesion_pa=200`). The answer, the checks and the problems are those of the POST; their pointers
/// (`/soil/cohesion_pa`) have a slash for the dot.
#[utoipa::path(
    get,
    path = "/v1/forces",
    tag = "forces",
    params(ForcesRequest, FormatParameter),
    responses((status = 200, description = "Forces and torque of a wheel at one operating point", content((ForcesReply = "application/json"), (String = "text/csv"))), InvalidQuery, Limits)
)]
pub(crate) async fn forces_of_query(
    State(service): State<Service>,
    Asked { query, format }: Asked<ForcesCase>,
) -> Result<Response, Problem> {
    answer(&service, query, format).await
}

async fn answer(service: &Service, query: ForcesCase, format: Format) -> Result<Response, Problem> {
    let cost = Cost::of_point(&query.operation);
    let work = move |_: &Pace| written(&ForcesReply::from(found::forces(&query)?), format);
    service.pool().run(cost, work).await
}
