//! `POST /v1/stress-profile`.

use axum::extract::State;
use axum::response::Response;

use super::responses::{InvalidBody, Limits};
use crate::app::Service;
use crate::compute::{Cost, written};
use crate::extract::{Format, Input};
use crate::problem::Problem;
use crate::reply::ProfileReply;
use crate::request::ProfileDto;

/// Stresses along the rim, exact and linearised
///
/// Normal and shear stress from the exit to the entry of the contact. With `Accept: text/csv` the columns come as a table.
#[utoipa::path(
    post,
    path = "/v1/stress-profile",
    tag = "forces",
    request_body = ProfileDto,
    responses((status = 200, description = "Stresses along the rim, exact and linearised", content((ProfileReply = "application/json"), (String = "text/csv"))), InvalidBody, Limits)
)]
pub(crate) async fn stress_profile(
    State(service): State<Service>,
    format: Format,
    Input(query): Input<ProfileDto>,
) -> Result<Response, Problem> {
    let cost = Cost::of_profile(&query.operation, query.points);
    let work = move || {
        let reply = ProfileReply::try_from(&query).map_err(|error| Problem::refused(&error, &query.operation.sinkage))?;
        written(&reply, format)
    };
    service.pool().run(cost, work).await
}
