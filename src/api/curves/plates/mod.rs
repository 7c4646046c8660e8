//! `POST /v1/identify/plates`.

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
use reply::PlatesReply;
pub(crate) use request::PlatesCase;
use request::PlatesRequest;

impl Room for PlatesCase {
    type Reply = PlatesReply;

    fn example() -> Value {
        // Dry sand under two plates, every other point: Yoshida et al. 2003, Annual Conference of the Robotics Society of Japan, 3G12.
        json!({
            "plates": [
                {"width_m": 0.06, "columns": {"sinkage_m": [0.00071, 0.001116, 0.001829, 0.002538], "pressure_pa": [247, 438, 885, 1291]}},
                {"width_m": 0.116, "columns": {"sinkage_m": [0.000813, 0.001219, 0.00193, 0.002538], "pressure_pa": [469, 974, 1744, 2465]}}
            ]
        })
    }

    fn cost(&self) -> Cost {
        Cost::of_curves(self.curves.iter().map(|curve| curve.sinkage.len()).sum())
    }

    fn reply(&self, pace: &Pace) -> Result<PlatesReply, Problem> {
        Ok(found::plates(self, pace)?.into())
    }
}

/// Bekker's parameters from plate tests
///
/// k_c, k_phi and n0 from curves of pressure over sinkage under plates of two or more widths, by Wong's weighted fit, with standard
/// errors and residuals. With `Accept: text/csv` the columns come as a table.
#[utoipa::path(
    post,
    path = "/v1/identify/plates",
    tag = "identification",
    request_body = PlatesRequest,
    responses((status = 200, description = "Bekker's parameters from plate tests", content((PlatesReply = "application/json"), (String = "text/csv"))), InvalidBody, Limits)
)]
pub(crate) async fn plates(
    State(service): State<Service>,
    format: Format,
    Input(case): Input<PlatesCase>,
) -> Result<Response, Problem> {
    answer(&service, case, format).await
}
