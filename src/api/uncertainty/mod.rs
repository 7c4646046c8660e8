//! `POST /v1/uncertainty`.

mod columns;
mod found;
mod reply;
mod request;

use axum::extract::State;
use axum::response::Response;
use serde_json::{Value, json};

use super::responses::{InvalidBody, Limits};
use super::room::Room;
use crate::answer::written;
use crate::compute::{Cost, Pace};
use crate::extract::{Format, Input};
use crate::problem::Problem;
use crate::request::Accepted;
use crate::state::Service;
use crate::varied::Varied;
use reply::UncertaintyReply;
pub(crate) use request::UncertaintyCase;
use request::{Uncertainty, UncertaintyRequest};

impl<R: Varied> Uncertainty<R> {
    fn cost(&self) -> Cost {
        self.sample.cost_of_rows(self.evaluations())
    }

    fn reply(&self, pace: &Pace) -> Result<UncertaintyReply, Problem> {
        Ok(UncertaintyReply::of(self, found::bands(self, pace)?))
    }
}

impl Room for UncertaintyCase {
    type Reply = UncertaintyReply;

    fn example() -> Value {
        json!({
            "of": "forces",
            "request": {
                "wheel": {"preset": "letter"}, "soil": {"preset": "letter-sand"}, "slip": 0.2, "normal_load_n": 80,
                "method": "linearised"
            },
            "inputs": [
                {"field": "/soil/friction_angle_rad", "distribution": "normal", "relative": 0.08},
                {"field": "/soil/cohesion_pa", "distribution": "uniform", "low": 0, "high": 400},
                {"field": "/soil/shear_modulus_m", "distribution": "lognormal", "mean": 0.006, "standard_deviation": 0.002}
            ],
            "samples": 256,
            "conditions": [{"quantity": "longitudinal_force_n", "below": 10}],
            "sensitivity_of": "longitudinal_force_n"
        })
    }

    fn cost(&self) -> Cost {
        match self {
            Self::Forces(uncertainty) => uncertainty.cost(),
            Self::Vehicle(uncertainty) => uncertainty.cost(),
        }
    }

    fn reply(&self, pace: &Pace) -> Result<UncertaintyReply, Problem> {
        match self {
            Self::Forces(uncertainty) => uncertainty.reply(pace),
            Self::Vehicle(uncertainty) => uncertainty.reply(pace),
        }
    }
}

/// Bands and sensitivities of forces, or of a rover, whose inputs are uncertain
///
/// A request of which some fields have distributions, at a point or over one axis. For every quantity the answer has mean, standard
/// deviation and the quantiles at 5, 25, 50, 75 and 95 %; for each condition its probability; and the shares of the variance that
/// each input decides, by itself (`first_order`) and together with others (`total`). Every number has its own standard error.
///
/// A sample without an answer is counted under `status`; `answered` tells how many samples each band has, and a probability has bounds
/// for the others, `least` and `most`. A
/// distribution without ends is cut off at the bounds of its field, which `share_cut` and a warning tell. Inputs that are correlated
/// have one sensitivity together. The fields that warnings name are those of `request`, their rows are samples, value of the axis by
/// value of the axis. With `Accept: text/csv` the columns come as a table with a row for each value of the axis.
#[utoipa::path(
    post,
    path = "/v1/uncertainty",
    tag = "forces",
    request_body = UncertaintyRequest,
    responses((status = 200, description = "Bands and sensitivities", content((UncertaintyReply = "application/json"), (String = "text/csv"))), InvalidBody, Limits)
)]
pub(crate) async fn uncertainty(
    State(service): State<Service>,
    format: Format,
    Input(Accepted { case, .. }): Input<UncertaintyCase>,
) -> Result<Response, Problem> {
    let cost = case.cost();
    service.pool().run(cost, move |pace| written(&case.reply(pace)?, format)).await
}
