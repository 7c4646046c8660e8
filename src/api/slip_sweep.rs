//! `POST /v1/slip-sweep`.

use axum::extract::State;
use axum::response::Response;

use super::responses::{InvalidBody, Limits};
use crate::app::Service;
use crate::compute::{Cost, written};
use crate::extract::{Format, Input};
use crate::problem::Problem;
use crate::reply::SweepReply;
use crate::request::SweepDto;

/// Forces and torque of a wheel over slip
///
/// A point without a solution is null in every solved column, and a warning says why. With `Accept: text/csv` the columns come
/// as a table.
#[utoipa::path(
    post,
    path = "/v1/slip-sweep",
    tag = "forces",
    request_body = SweepDto,
    responses((status = 200, description = "Forces and torque of a wheel over slip", content((SweepReply = "application/json"), (String = "text/csv"))), InvalidBody, Limits)
)]
pub(crate) async fn slip_sweep(
    State(service): State<Service>,
    format: Format,
    Input(query): Input<SweepDto>,
) -> Result<Response, Problem> {
    let cost = Cost::of_points(&query.operation, query.slips.len());
    let work = move || {
        let reply = SweepReply::from(&query);
        written(&reply, format)
    };
    service.pool().run(cost, work).await
}
