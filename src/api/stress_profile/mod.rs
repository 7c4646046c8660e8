//! `POST` and `GET /v1/stress-profile`.

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
use reply::ProfileReply;
pub(crate) use request::ProfileCase;
use request::ProfileRequest;

impl Room for ProfileCase {
    type Reply = ProfileReply;

    fn example() -> Value {
        json!({
            "wheel": {"radius_m": 0.2, "width_m": 0.1},
            "soil": {
                "cohesion_pa": 0, "friction_angle_rad": 0.478, "shear_modulus_m": 0.005,
                "pressure_sinkage": {"law": "bekker", "k_c": -660, "k_phi": 754_130, "n0": 0.91}
            },
            "contact": {"rule": "midpoint"}, "slip": 0.2, "sinkage_m": 0.02, "points": 5
        })
    }

    fn cost(&self) -> Cost {
        Cost::of_profile(&self.operation, self.points)
    }

    fn reply(&self, _: &Pace) -> Result<ProfileReply, Problem> {
        Ok(found::profile(self)?.into())
    }

    fn hints(&self) -> Vec<Warning> {
        of_system(&self.operation.system).collect()
    }
}

/// Stresses along the rim, exact and linearised
///
/// Normal and shear stress from the exit to the entry of the contact. With `Accept: text/csv` the columns come as a table.
#[utoipa::path(
    post,
    path = "/v1/stress-profile",
    tag = "forces",
    request_body = ProfileRequest,
    responses((status = 200, description = "Stresses along the rim, exact and linearised", content((ProfileReply = "application/json"), (String = "text/csv"))), InvalidBody, Limits)
)]
pub(crate) async fn stress_profile(
    State(service): State<Service>,
    format: Format,
    Input(case): Input<ProfileCase>,
) -> Result<Response, Problem> {
    answer(&service, case, format).await
}

#[utoipa::path(
    get,
    path = "/v1/stress-profile",
    tag = "forces",
    params(ProfileRequest, FormatParameter),
    responses(InvalidQuery, Limits)
)]
pub(crate) async fn stress_profile_of_query(
    State(service): State<Service>,
    Asked { case, format }: Asked<ProfileCase>,
) -> Result<Response, Problem> {
    answer(&service, case, format).await
}
