//! `POST /v1/compare`.

use axum::extract::State;
use axum::response::Response;

use super::responses::{InvalidBody, Limits};
use crate::answer::written;
use crate::compute::{Cost, Pace};
use crate::extract::{Format, Input};
use crate::found;
use crate::problem::Problem;
use crate::reply::CompareReply;
use crate::request::{CompareCase, CompareRequest};
use crate::state::Service;

/// Several methods and laws side by side, with the gap to the integral
///
/// The request as it stands and each of its variants, by every method, at one slip or over several. By quantity: how far each
/// series is from the first and from the quadrature with the same laws, and the spread of all. With `Accept: text/csv` the
/// columns come as a table, named `method.column`, or `variant.method.column`; differences and spread come with JSON only.
#[utoipa::path(
    post,
    path = "/v1/compare",
    tag = "forces",
    request_body = CompareRequest,
    responses((status = 200, description = "Several methods and laws side by side, with the gap to the integral", content((CompareReply = "application/json"), (String = "text/csv"))), InvalidBody, Limits)
)]
pub(crate) async fn compare(
    State(service): State<Service>,
    format: Format,
    Input(query): Input<CompareCase>,
) -> Result<Response, Problem> {
    let cost = Cost::of_points(query.operations(), query.slips.len());
    let work = move |pace: &Pace| written(&CompareReply::from(found::compare(&query, pace)?), format);
    service.pool().run(cost, work).await
}
