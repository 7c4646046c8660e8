//! `POST /v1/forces`.

use axum::extract::State;
use axum::response::Response;

use super::responses::{InvalidBody, Limits};
use crate::app::Service;
use crate::compute::{Cost, written};
use crate::extract::{Format, Input};
use crate::problem::Problem;
use crate::reply::ForcesReply;
use crate::request::ForcesDto;

/// Forces and torque of a wheel at one operating point
///
/// Drawbar pull, normal force and torque with their four parts, by the integral of the stresses or by a closed form. With
/// `Accept: text/csv` the numbers come as a table of one row.
#[utoipa::path(
    post,
    path = "/v1/forces",
    tag = "forces",
    request_body = ForcesDto,
    responses((status = 200, description = "Forces and torque of a wheel at one operating point", content((ForcesReply = "application/json"), (String = "text/csv"))), InvalidBody, Limits)
)]
pub(crate) async fn forces(
    State(service): State<Service>,
    format: Format,
    Input(query): Input<ForcesDto>,
) -> Result<Response, Problem> {
    let cost = Cost::of_points(&query.operation, 1);
    let work = move || {
        let reply = ForcesReply::try_from(&query).map_err(|error| Problem::refused(&error, &query.operation.sinkage))?;
        written(&reply, format)
    };
    service.pool().run(cost, work).await
}
