//! `POST /v1/vehicle`, and its twin for wheels that are alike.

mod found;
mod refusal;
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
use crate::state::Service;
use crate::warning::Warning;
use reply::VehicleReply;
pub(crate) use request::VehicleCase;
use request::VehicleRequest;
pub(crate) use row::rover_columns;

impl Room for VehicleCase {
    type Reply = VehicleReply;

    fn example() -> Value {
        json!({
            "mass_kg": 20, "gravity_m_s2": 1.625, "slope_rad": 0.1,
            "wheels": {"count": 4, "wheel": {"radius_m": 0.1, "width_m": 0.06}},
            "soil": {
                "cohesion_pa": 1000, "friction_angle_rad": 0.785, "shear_modulus_m": 0.018,
                "pressure_sinkage": {"law": "bekker", "k_c": 1400, "k_phi": 820e3, "n0": 1}
            },
            "contact": {"rule": "wong_reece", "c1": 0.4, "c2": 0.2}
        })
    }

    fn cost(&self) -> Cost {
        Cost::of_vehicle(&self.vehicle, self.slopes.len())
    }

    fn reply(&self, pace: &Pace) -> Result<VehicleReply, Problem> {
        Ok(found::vehicle(self, pace)?.into())
    }

    fn hints(&self) -> Vec<Warning> {
        found::of_systems(&self.vehicle)
    }
}

/// A rover on a slope
///
/// The slip at which all wheels together give the pull that slope and hitch need, at one slip or at equal torques; loads, forces and torque of each wheel; the energy
/// for a metre of way; and the largest slope that the rover climbs. For several slopes the answer has columns. With
/// `Accept: text/csv` the columns come as a table, of one row for one slope.
#[utoipa::path(
    post,
    path = "/v1/vehicle",
    tag = "forces",
    request_body = VehicleRequest,
    responses((status = 200, description = "A rover on a slope", content((VehicleReply = "application/json"), (String = "text/csv"))), InvalidBody, Limits)
)]
pub(crate) async fn vehicle(
    State(service): State<Service>,
    format: Format,
    Input(case): Input<VehicleCase>,
) -> Result<Response, Problem> {
    answer(&service, case, format).await
}

#[utoipa::path(
    get,
    path = "/v1/vehicle",
    tag = "forces",
    params(VehicleRequest, FormatParameter),
    responses(InvalidQuery, Limits)
)]
pub(crate) async fn vehicle_of_query(
    State(service): State<Service>,
    Asked { case, format }: Asked<VehicleCase>,
) -> Result<Response, Problem> {
    answer(&service, case, format).await
}
