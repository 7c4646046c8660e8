//! `POST /v1/compare`.

mod difference;
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
use reply::CompareReply;
pub(crate) use request::CompareCase;
use request::CompareRequest;

impl Room for CompareCase {
    type Reply = CompareReply;

    fn example() -> Value {
        json!({
            "wheel": {"preset": "letter"}, "soil": {"preset": "letter-sand"}, "slip": [0.1, 0.3], "sinkage_m": 0.02,
            "methods": ["quadrature", "explicit"],
            "variants": [{"name": "half sinkage", "contact": {"rule": "half_sinkage"}}]
        })
    }

    fn cost(&self) -> Cost {
        Cost::of_points(self.operations(), self.slips.len())
    }

    fn reply(&self, pace: &Pace) -> Result<CompareReply, Problem> {
        Ok(found::compare(self, pace)?.into())
    }
}

/// Several methods and laws side by side, with the gap to the integral
///
/// The request as it stands and each of its variants, by every method, at one slip or over several. By quantity: how far each
/// series is from the first and from the quadrature with the same laws, and the spread of all. With `Accept: text/csv` the
/// columns come as a table, named `method.column`, or `variant.method.column`; differences and spread come with JSON only.
#[utoipa::path(
    post,
    path = "/v1/compare",
    tag = "forces",
    request_body = CompareRequest,
    responses((status = 200, description = "Several methods and laws side by side, with the gap to the integral", content((CompareReply = "application/json"), (String = "text/csv"))), InvalidBody, Limits)
)]
pub(crate) async fn compare(
    State(service): State<Service>,
    format: Format,
    Input(case): Input<CompareCase>,
) -> Result<Response, Problem> {
    answer(&service, case, format).await
}
