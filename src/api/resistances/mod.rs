//! `POST` and `GET /v1/resistances`.

mod found;
mod reply;
mod request;

use axum::extract::State;
use axum::response::Response;
use serde_json::{Value, json};

use super::responses::{InvalidBody, InvalidQuery, Limits};
use super::room::{Room, answer};
use crate::compute::{Cost, Pace};
use crate::extract::{Asked, Format, FormatParameter, Input};
use crate::problem::Problem;
use crate::state::Service;
use crate::warning::{Warning, of_system};
use reply::ResistancesReply;
pub(crate) use request::ResistancesCase;
use request::ResistancesRequest;

impl Room for ResistancesCase {
    type Reply = ResistancesReply;

    fn example() -> Value {
        json!({
            "wheel": {"radius_m": 0.4065, "width_m": 0.229},
            "soil": {"preset": "lunar-apollo-nominal", "friction_angle_rad": 0.576, "unit_weight_n_m3": 2472},
            "normal_load_n": 259, "slip": 0.05
        })
    }

    fn cost(&self) -> Cost {
        Cost::of_closed_forms()
    }

    fn reply(&self, _: &Pace) -> Result<ResistancesReply, Problem> {
        Ok(found::resistances(self)?.into())
    }

    fn hints(&self) -> Vec<Warning> {
        of_system(&self.system).collect()
    }
}

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
    Input(case): Input<ResistancesCase>,
) -> Result<Response, Problem> {
    answer(&service, case, format).await
}

#[utoipa::path(
    get,
    path = "/v1/resistances",
    tag = "forces",
    params(ResistancesRequest, FormatParameter),
    responses(InvalidQuery, Limits)
)]
pub(crate) async fn resistances_of_query(
    State(service): State<Service>,
    Asked { case, format }: Asked<ResistancesCase>,
) -> Result<Response, Problem> {
    answer(&service, case, format).await
}
