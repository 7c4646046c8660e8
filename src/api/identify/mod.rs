//! `POST /v1/identify`.

mod columns;
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
use crate::warning::{Warning, system_warnings};
use reply::IdentifyReply;
pub(crate) use request::IdentifyCase;
use request::IdentifyRequest;

impl Room for IdentifyCase {
    type Reply = IdentifyReply;

    fn example() -> Value {
        // The integrals of the letter's example, computed independently with 401 000 points.
        json!({
            "wheel": {"preset": "letter"}, "soil": {"cohesion_pa": 0},
            "fit": ["friction_angle_rad", "shear_modulus_m", "k_s", "n0"],
            "data": {
                "slip": [0.05, 0.2, 0.5, 0.05, 0.2, 0.5],
                "sinkage_m": [0.01, 0.01, 0.01, 0.02, 0.02, 0.02],
                "longitudinal_force_n": [1.031, 6.546, 9.734, 5.911, 16.906, 21.748],
                "normal_force_n": [32.203, 33.025, 33.601, 87.205, 89.716, 91.117],
                "torque_n_m": [1.2247, 2.3421, 2.9912, 5.0744, 7.3396, 8.3513]
            },
            "bounds": {"shear_modulus_m": [0.001, 0.05]}
        })
    }

    fn cost(&self) -> Cost {
        match self {
            Self::Linear(case) => Cost::of_line(case.observations.slip.len(), case.law_known),
            Self::Fit(case) => Cost::of_search(case.options.evaluations),
        }
    }

    fn reply(&self, pace: &Pace) -> Result<IdentifyReply, Problem> {
        Ok(found::identify(self, pace)?.into())
    }

    fn hints(&self) -> Vec<Warning> {
        let setup = match self {
            Self::Fit(case) => &case.setup,
            Self::Linear(case) => &case.setup,
        };
        system_warnings(&setup.wheel, &setup.soil).collect()
    }
}

/// Parameters of soil and contact from measured forces
///
/// The parameters named in `fit` that explain the measurements best by the chosen method, with standard errors, intervals,
/// correlation and residuals; and what the measurements do not tell: `identifiable` is false, with words at each parameter,
/// whenever they leave one open. With `Accept: text/csv` the columns come as a table.
#[utoipa::path(
    post,
    path = "/v1/identify",
    tag = "identification",
    request_body = IdentifyRequest,
    responses((status = 200, description = "Parameters of soil and contact from measured forces", content((IdentifyReply = "application/json"), (String = "text/csv"))), InvalidBody, Limits)
)]
pub(crate) async fn identify(
    State(service): State<Service>,
    format: Format,
    Input(case): Input<IdentifyCase>,
) -> Result<Response, Problem> {
    answer(&service, case, format).await
}
