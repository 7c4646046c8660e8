//! `POST /v1/coupled`.

mod found;
mod reply;
mod request;

use axum::extract::State;
use axum::response::Response;
use serde_json::{Value, json};

use super::responses::{InvalidBody, Limits};
use super::room::{Room, answer};
use crate::compute::{Cost, Pace};
use crate::extract::{Format, Input};
use crate::problem::Problem;
use crate::state::Service;
use crate::warning::{Warning, of_system};
use reply::CoupledReply;
pub(crate) use request::CoupledCase;
use request::CoupledRequest;

impl Room for CoupledCase {
    type Reply = CoupledReply;

    fn example() -> Value {
        json!({
            "wheel": {"preset": "letter"}, "soil": {"preset": "letter-sand"}, "slip": 0.2, "sinkage_m": 0.02, "normal_load_n": 80
        })
    }

    fn cost(&self) -> Cost {
        Cost::of_closed_forms()
    }

    fn reply(&self, _: &Pace) -> Result<CoupledReply, Problem> {
        Ok(found::coupled(self)?.into())
    }

    fn hints(&self) -> Vec<Warning> {
        of_system(&self.system).collect()
    }
}

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
    Input(case): Input<CoupledCase>,
) -> Result<Response, Problem> {
    answer(&service, case, format).await
}
