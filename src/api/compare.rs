//! `POST /v1/compare`.

use axum::extract::State;
use axum::response::Response;

use super::responses::{InvalidBody, Limits};
use crate::app::Service;
use crate::compute::{Cost, written};
use crate::extract::{Format, Input};
use crate::problem::Problem;
use crate::reply::CompareReply;
use crate::request::CompareDto;

/// Several methods side by side over slip, with the gap between them
///
/// Each method's columns, and the root mean square and the largest of its difference from the first method, by quantity. With
/// `Accept: text/csv` the columns come as a table, named `method.column`.
#[utoipa::path(
    post,
    path = "/v1/compare",
    tag = "forces",
    request_body = CompareDto,
    responses((status = 200, description = "Several methods side by side over slip, with the gap between them", content((CompareReply = "application/json"), (String = "text/csv"))), InvalidBody, Limits)
)]
pub(crate) async fn compare(
    State(service): State<Service>,
    format: Format,
    Input(query): Input<CompareDto>,
) -> Result<Response, Problem> {
    let cost = Cost::of_comparison(&query.operations, query.slips.len());
    let work = move || {
        let reply = CompareReply::from(&query);
        written(&reply, format)
    };
    service.pool().run(cost, work).await
}
