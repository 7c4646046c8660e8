//! `POST` and `GET /v1/slip-sweep`.

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
pub(crate) use found::{FoundSweep, sweep};
use reply::SweepReply;
pub(crate) use request::SweepCase;
use request::SweepRequest;

impl Room for SweepCase {
    type Reply = SweepReply;

    fn example() -> Value {
        json!({
            "wheel": {"preset": "letter", "lug_height_m": 0.01}, "soil": {"preset": "letter-sand"},
            "slip": {"from": 0, "to": 1, "points": 6}, "normal_load_n": 80, "method": "linearised"
        })
    }

    fn cost(&self) -> Cost {
        Cost::of_points([self.operation], self.slips.len())
    }

    fn reply(&self, pace: &Pace) -> Result<SweepReply, Problem> {
        Ok(found::sweep(self, pace)?.into())
    }
}

/// Forces and torque of a wheel over slip
///
/// A point without a solution is null in every solved column, and a warning says why. With `Accept: text/csv` the columns come
/// as a table.
#[utoipa::path(
    post,
    path = "/v1/slip-sweep",
    tag = "forces",
    request_body = SweepRequest,
    responses((status = 200, description = "Forces and torque of a wheel over slip", content((SweepReply = "application/json"), (String = "text/csv"))), InvalidBody, Limits)
)]
pub(crate) async fn slip_sweep(
    State(service): State<Service>,
    format: Format,
    Input(case): Input<SweepCase>,
) -> Result<Response, Problem> {
    answer(&service, case, format).await
}

#[utoipa::path(
    get,
    path = "/v1/slip-sweep",
    tag = "forces",
    params(SweepRequest, FormatParameter),
    responses(InvalidQuery, Limits)
)]
pub(crate) async fn slip_sweep_of_query(
    State(service): State<Service>,
    Asked { case, format }: Asked<SweepCase>,
) -> Result<Response, Problem> {
    answer(&service, case, format).await
}
