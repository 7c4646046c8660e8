//! `POST /v1/optimum`.

mod columns;
mod found;
mod reply;
mod request;
mod stop;

use axum::extract::State;
use axum::response::Response;
use serde_json::{Value, json};

use super::responses::{InvalidBody, Limits};
use super::room::{Room, answer};
use crate::compute::{Cost, Pace};
use crate::extract::{Format, Input};
use crate::problem::Problem;
use crate::state::Service;
use crate::varied::Varied;
use reply::OptimumReply;
pub(crate) use request::OptimumCase;
use request::OptimumRequest;

impl Room for OptimumCase {
    type Reply = OptimumReply;

    fn example() -> Value {
        json!({
            "of": "forces",
            "request": {
                "wheel": {"radius_m": 0.1, "width_m": 0.1}, "soil": {"preset": "letter-sand"}, "slip": 0.2, "normal_load_n": 60
            },
            "variables": [
                {"field": "/wheel/radius_m", "from": 0.05, "to": 0.2},
                {"field": "/wheel/width_m", "from": 0.03, "to": 0.2}
            ],
            "minimise": "2700 * 0.002 * 2 * pi * radius_m * width_m",
            "constraints": [
                {"quantity": "longitudinal_force_n", "at_least": 12},
                {"quantity": "sinkage_m", "at_most": 0.03}
            ]
        })
    }

    fn cost(&self) -> Cost {
        match self {
            Self::Forces(sought) => sought.sample.cost_of_rows(sought.evaluations as usize),
            Self::Vehicle(sought) => sought.sample.cost_of_rows(sought.evaluations as usize),
        }
    }

    fn reply(&self, pace: &Pace) -> Result<OptimumReply, Problem> {
        match self {
            Self::Forces(sought) => Ok(found::found(sought, pace)?.into()),
            Self::Vehicle(sought) => Ok(found::found(sought, pace)?.into()),
        }
    }
}

/// The best wheel or operating point under constraints
///
/// Seeks one to six numeric fields of a request within their bounds, so that a quantity, or a formula of several, becomes as small or
/// as large as the constraints allow. A survey of the whole range gives the starts of several searches (Powell's COBYLA); a point at
/// which the operation has no answer counts as one that is not allowed. The answer names the constraints and bounds that hold the
/// optimum. Where no point keeps all constraints, it has the point that misses them least and says which cannot be met.
///
/// With `against` it is the trade-off of two goals. With `Accept: text/csv` the points come as a table.
#[utoipa::path(
    post,
    path = "/v1/optimum",
    tag = "forces",
    request_body = OptimumRequest,
    responses((status = 200, description = "The best point, or the trade-off of two goals", content((OptimumReply = "application/json"), (String = "text/csv"))), InvalidBody, Limits)
)]
pub(crate) async fn optimum(
    State(service): State<Service>,
    format: Format,
    Input(case): Input<OptimumCase>,
) -> Result<Response, Problem> {
    answer(&service, case, format).await
}
