//! `POST /v1/coupled`.

use axum::extract::State;
use axum::response::Response;

use super::responses::{InvalidBody, Limits};
use crate::answer::written;
use crate::compute::{Cost, Pace};
use crate::extract::{Format, Input};
use crate::found;
use crate::problem::Problem;
use crate::reply::CoupledReply;
use crate::request::{CoupledCase, CoupledRequest};
use crate::state::Service;

/// Torque and pull from a load that is measured
///
/// Ding's coupled forms of the linear stresses: torque from the load, and longitudinal force from load and torque, without the
/// pressure–sinkage law. With `Accept: text/csv` the numbers come as a table of one row.
#[utoipa::path(
    post,
    path = "/v1/coupled",
    tag = "forces",
    request_body = CoupledRequest,
    responses((status = 200, description = "Torque and pull from a load that is measured", content((CoupledReply = "application/json"), (String = "text/csv"))), InvalidBody, Limits)
)]
pub(crate) async fn coupled(
    State(service): State<Service>,
    format: Format,
    Input(query): Input<CoupledCase>,
) -> Result<Response, Problem> {
    let work = move |_: &Pace| written(&CoupledReply::from(found::coupled(&query)?), format);
    service.pool().run(Cost::of_closed_forms(), work).await
}
