//! `POST` and `GET /v1/stress-profile`.

use axum::extract::State;
use axum::response::Response;

use super::responses::{InvalidBody, InvalidQuery, Limits};
use crate::answer::written;
use crate::compute::{Cost, Pace};
use crate::extract::{Asked, Format, FormatParameter, Input};
use crate::found;
use crate::problem::Problem;
use crate::reply::ProfileReply;
use crate::request::{ProfileCase, ProfileRequest};
use crate::state::Service;

/// Stresses along the rim, exact and linearised
///
/// Normal and shear stress from the exit to the entry of the contact. With `Accept: text/csv` the columns come as a table.
#[utoipa::path(
    post,
    path = "/v1/stress-profile",
    tag = "forces",
    request_body = ProfileRequest,
    responses((status = 200, description = "Stresses along the rim, exact and linearised", content((ProfileReply = "application/json"), (String = "text/csv"))), InvalidBody, Limits)
)]
pub(crate) async fn stress_profile(
    State(service): State<Service>,
    format: Format,
    Input(query): Input<ProfileCase>,
) -> Result<Response, Problem> {
    answer(&service, query, format).await
}

/// Stresses along the rim, exact and linearised, asked by a query
///
/// The twin of the POST: a field is a parameter, one inside an object has the object's name and a dot before its own
/// (`soil.cohesion_pa=200`). The answer, the checks and the problems are those of the POST; their pointers
/// (`/soil/cohesion_pa`) have a slash for the dot.
#[utoipa::path(
    get,
    path = "/v1/stress-profile",
    tag = "forces",
    params(ProfileRequest, FormatParameter),
    responses((status = 200, description = "Stresses along the rim, exact and linearised", content((ProfileReply = "application/json"), (String = "text/csv"))), InvalidQuery, Limits)
)]
pub(crate) async fn stress_profile_of_query(
    State(service): State<Service>,
    Asked { query, format }: Asked<ProfileCase>,
) -> Result<Response, Problem> {
    answer(&service, query, format).await
}

async fn answer(service: &Service, query: ProfileCase, format: Format) -> Result<Response, Problem> {
    let cost = Cost::of_profile(&query.operation, query.points);
    let work = move |_: &Pace| written(&ProfileReply::from(found::profile(&query)?), format);
    service.pool().run(cost, work).await
}
