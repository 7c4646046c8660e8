//! `POST /v1/towed`.

use axum::extract::State;
use axum::response::Response;

use super::responses::{InvalidBody, Limits};
use crate::answer::written;
use crate::compute::{Cost, Pace};
use crate::extract::{Format, Input};
use crate::found;
use crate::problem::Problem;
use crate::reply::TowedReply;
use crate::request::{TowedCase, TowedRequest};
use crate::state::Service;

/// Skid, sinkage and resistance of a towed wheel
///
/// The wheel rolls freely: the soil alone turns it (T = 0) while it carries the load. With `Accept: text/csv` the numbers come as
/// a table of one row.
#[utoipa::path(
    post,
    path = "/v1/towed",
    tag = "forces",
    request_body = TowedRequest,
    responses((status = 200, description = "Skid, sinkage and resistance of a towed wheel", content((TowedReply = "application/json"), (String = "text/csv"))), InvalidBody, Limits)
)]
pub(crate) async fn towed(
    State(service): State<Service>,
    format: Format,
    Input(query): Input<TowedCase>,
) -> Result<Response, Problem> {
    let cost = Cost::of_towed();
    let work = move |_: &Pace| written(&TowedReply::from(found::towed(&query)?), format);
    service.pool().run(cost, work).await
}
