//! `POST /v1/identify/shear`.

mod found;
mod reply;
mod request;

use axum::extract::State;
use axum::response::Response;
use serde_json::{Value, json};

use crate::api::responses::{InvalidBody, Limits};
use crate::api::room::{Room, answer};
use crate::compute::{Cost, Pace};
use crate::extract::{Format, Input};
use crate::problem::Problem;
use crate::state::Service;
use reply::ShearReply;
pub(crate) use request::ShearTestsCase;
use request::ShearTestsRequest;

impl Room for ShearTestsCase {
    type Reply = ShearReply;

    fn example() -> Value {
        // (500 Pa + 0.6 σ)(1 − exp(−j/10 mm)), to the nearest 10 Pa.
        json!({
            "curves": [
                {"normal_stress_pa": 2000, "columns": {"displacement_m": [0.005, 0.01, 0.02, 0.04], "shear_stress_pa": [670, 1070, 1470, 1670]}},
                {"normal_stress_pa": 8000, "columns": {"displacement_m": [0.005, 0.01, 0.02, 0.04], "shear_stress_pa": [2090, 3350, 4580, 5200]}}
            ]
        })
    }

    fn cost(&self) -> Cost {
        Cost::of_curves(self.0.iter().map(|curve| curve.shear.len()).sum())
    }

    fn reply(&self, pace: &Pace) -> Result<ShearReply, Problem> {
        Ok(found::shear(self, pace)?.into())
    }
}

/// Strength and shear modulus from shear tests
///
/// Cohesion, friction angle and shear modulus from curves of shear stress over displacement under two or more normal stresses, all
/// fitted at once, with standard errors and residuals. With `Accept: text/csv` the columns come as a table.
#[utoipa::path(
    post,
    path = "/v1/identify/shear",
    tag = "identification",
    request_body = ShearTestsRequest,
    responses((status = 200, description = "Strength and shear modulus from shear tests", content((ShearReply = "application/json"), (String = "text/csv"))), InvalidBody, Limits)
)]
pub(crate) async fn shear(
    State(service): State<Service>,
    format: Format,
    Input(case): Input<ShearTestsCase>,
) -> Result<Response, Problem> {
    answer(&service, case, format).await
}
