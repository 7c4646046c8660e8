//! `POST /v1/resistances`.

use axum::extract::State;
use axum::response::Response;
use terramechanics::Sinkage;

use super::responses::{InvalidBody, Limits};
use crate::app::Service;
use crate::compute::{Cost, written};
use crate::extract::{Format, Input};
use crate::problem::Problem;
use crate::reply::ResistancesReply;
use crate::request::ResistancesDto;

/// Bekker's estimates of sinkage, resistances and thrust
///
/// The classical estimates for a load, to be set beside the forces: sinkage of a rigid wheel, compaction and bulldozing
/// resistance, thrust. With `Accept: text/csv` the numbers come as a table of one row.
#[utoipa::path(
    post,
    path = "/v1/resistances",
    tag = "forces",
    request_body = ResistancesDto,
    responses((status = 200, description = "Bekker's estimates of sinkage, resistances and thrust", content((ResistancesReply = "application/json"), (String = "text/csv"))), InvalidBody, Limits)
)]
pub(crate) async fn resistances(
    State(service): State<Service>,
    format: Format,
    Input(query): Input<ResistancesDto>,
) -> Result<Response, Problem> {
    let work = move || {
        let sinkage = Sinkage::CarryingLoad(query.normal_load);
        let reply = ResistancesReply::try_from(&query).map_err(|error| Problem::refused(&error, &sinkage))?;
        written(&reply, format)
    };
    service.pool().run(Cost::of_closed_forms(), work).await
}
