//! `POST /v1/towed`.

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
use reply::TowedReply;
pub(crate) use request::TowedCase;
use request::TowedRequest;

impl Room for TowedCase {
    type Reply = TowedReply;

    fn example() -> Value {
        json!({"wheel": {"preset": "letter"}, "soil": {"preset": "letter-sand"}, "normal_load_n": 80})
    }

    fn cost(&self) -> Cost {
        Cost::of_towed()
    }

    fn reply(&self, _: &Pace) -> Result<TowedReply, Problem> {
        Ok(found::towed(self)?.into())
    }

    fn hints(&self) -> Vec<Warning> {
        of_system(&self.operation.system).collect()
    }
}

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
    Input(case): Input<TowedCase>,
) -> Result<Response, Problem> {
    answer(&service, case, format).await
}
