//! `POST` and `GET /v1/resistances`.

use axum::extract::State;
use axum::response::Response;

use super::responses::{InvalidBody, InvalidQuery, Limits};
use crate::answer::written;
use crate::compute::{Cost, Pace};
use crate::extract::{Asked, Format, FormatParameter, Input};
use crate::found;
use crate::problem::Problem;
use crate::reply::ResistancesReply;
use crate::request::{ResistancesCase, ResistancesRequest};
use crate::state::Service;

/// Bekker's estimates of sinkage, resistances and thrust
///
/// The classical estimates for a load, to be set beside the forces: sinkage of a rigid wheel, compaction and bulldozing
/// resistance, thrust. With `Accept: text/csv` the numbers come as a table of one row.
#[utoipa::path(
    post,
    path = "/v1/resistances",
    tag = "forces",
    request_body = ResistancesRequest,
    responses((status = 200, description = "Bekker's estimates of sinkage, resistances and thrust", content((ResistancesReply = "application/json"), (String = "text/csv"))), InvalidBody, Limits)
)]
pub(crate) async fn resistances(
    State(service): State<Service>,
    format: Format,
    Input(query): Input<ResistancesCase>,
) -> Result<Response, Problem> {
    answer(&service, query, format).await
}

/// Bekker's estimates of sinkage, resistances and thrust, asked by a query
///
/// The twin of the POST: a field is a parameter, one inside an object has the object's name and a dot before its own
/// (`soil.unit_weight_n_m3=15000`). The answer, the checks and the problems are those of the POST.
#[utoipa::path(
    get,
    path = "/v1/resistances",
    tag = "forces",
    params(ResistancesRequest, FormatParameter),
    responses((status = 200, description = "Bekker's estimates of sinkage, resistances and thrust", content((ResistancesReply = "application/json"), (String = "text/csv"))), InvalidQuery, Limits)
)]
pub(crate) async fn resistances_of_query(
    State(service): State<Service>,
    Asked { query, format }: Asked<ResistancesCase>,
) -> Result<Response, Problem> {
    answer(&service, query, format).await
}

async fn answer(service: &Service, query: ResistancesCase, format: Format) -> Result<Response, Problem> {
    let work = move |_: &Pace| written(&ResistancesReply::from(found::resistances(&query)?), format);
    service.pool().run(Cost::of_closed_forms(), work).await
}
