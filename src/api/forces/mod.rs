//! `POST` and `GET /v1/forces`.

mod direct;
mod found;
mod reply;
mod request;
mod row;

use axum::extract::State;
use axum::response::Response;
use serde_json::{Value, json};

use super::responses::{InvalidBody, InvalidQuery, Limits};
use super::room::{Room, answer};
use crate::compute::{Cost, Pace};
use crate::extract::{Asked, Format, FormatParameter, Input};
use crate::problem::Problem;
use crate::request::pull::SlipFrom;
use crate::state::Service;
use crate::warning::{Warning, of_system};
pub(crate) use reply::ForcesReply;
pub(crate) use request::ForcesCase;
use request::ForcesRequest;

impl Room for ForcesCase {
    type Reply = ForcesReply;

    fn example() -> Value {
        json!({
            "wheel": {"preset": "letter"}, "soil": {"preset": "letter-sand"}, "slip": 0.2, "sinkage_m": 0.02
        })
    }

    fn cost(&self) -> Cost {
        match self.slip {
            SlipFrom::Motion(_) => Cost::of_point(&self.operation),
            SlipFrom::Pull(_) => Cost::of_solved_slip(&self.operation),
        }
    }

    fn reply_at_once(&self) -> Option<ForcesReply> {
        found::forces_in_few_steps(self).map(ForcesReply::from)
    }

    fn reply(&self, _: &Pace) -> Result<ForcesReply, Problem> {
        Ok(found::forces(self)?.into())
    }

    fn hints(&self) -> Vec<Warning> {
        of_system(&self.operation.system).collect()
    }
}

/// Forces and torque of a wheel at one operating point
///
/// Drawbar pull, normal force and torque with their four parts, by the integral of the stresses or by a closed form. With
/// `Accept: text/csv` the numbers come as a table of one row.
#[utoipa::path(
    post,
    path = "/v1/forces",
    tag = "forces",
    request_body = ForcesRequest,
    responses((status = 200, description = "Forces and torque of a wheel at one operating point", content((ForcesReply = "application/json"), (String = "text/csv"))), InvalidBody, Limits)
)]
pub(crate) async fn forces(
    State(service): State<Service>,
    format: Format,
    Input(case): Input<ForcesCase>,
) -> Result<Response, Problem> {
    answer(&service, case, format).await
}

#[utoipa::path(get, path = "/v1/forces", tag = "forces", params(ForcesRequest, FormatParameter), responses(InvalidQuery, Limits))]
pub(crate) async fn forces_of_query(
    State(service): State<Service>,
    Asked { case, format }: Asked<ForcesCase>,
) -> Result<Response, Problem> {
    answer(&service, case, format).await
}
