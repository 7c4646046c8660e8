//! `POST /v1/identify`.

use axum::extract::State;
use axum::response::Response;

use super::responses::{InvalidBody, Limits};
use crate::app::Service;
use crate::compute::{Cost, written};
use crate::extract::{Format, Input};
use crate::problem::Problem;
use crate::reply::IdentifyReply;
use crate::request::IdentifyDto;

/// Parameters of soil and contact from measured forces
///
/// The parameters named in `fit` that explain the measurements best by the chosen method, with standard errors, intervals,
/// correlation and residuals; and what the measurements do not tell: `identifiable` is false, with words at each parameter,
/// whenever they leave one open. With `Accept: text/csv` the columns come as a table.
#[utoipa::path(
    post,
    path = "/v1/identify",
    tag = "identification",
    request_body = IdentifyDto,
    responses((status = 200, description = "Parameters of soil and contact from measured forces", content((IdentifyReply = "application/json"), (String = "text/csv"))), InvalidBody, Limits)
)]
pub(crate) async fn identify(
    State(service): State<Service>,
    format: Format,
    Input(query): Input<IdentifyDto>,
) -> Result<Response, Problem> {
    let cost = Cost::of_identification(&query);
    let work = move || {
        let reply = IdentifyReply::try_from(&query).map_err(Problem::Invalid)?;
        written(&reply, format)
    };
    service.pool().run(cost, work).await
}
