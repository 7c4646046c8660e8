//! `POST /v1/sweep`.

mod found;
mod grid;
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
use found::Running;
use reply::GridReply;
pub(crate) use request::GridCase;
use request::GridRequest;

impl Room for GridCase {
    type Reply = GridReply;

    fn example() -> Value {
        json!({
            "of": "forces",
            "request": {
                "wheel": {"preset": "letter"}, "soil": {"preset": "letter-sand"}, "slip": 0.2, "normal_load_n": 80,
                "method": "linearised"
            },
            "axes": [
                {"field": "/wheel/radius_m", "from": 0.1, "to": 0.3, "points": 3},
                {"field": "/soil/cohesion_pa", "values": [0, 200]}
            ]
        })
    }

    fn cost(&self) -> Cost {
        match self {
            Self::Forces(sweep) => sweep.sample.cost_of_rows(sweep.grid.len()),
        }
    }

    fn reply(&self, pace: &Pace) -> Result<GridReply, Problem> {
        match self {
            Self::Forces(sweep) => Ok(GridReply::of(Running::of(sweep), pace)?),
        }
    }
}

/// Forces over a grid of any fields
///
/// A request is asked at every point of a grid of one to three of its numeric fields.
#[utoipa::path(
    post,
    path = "/v1/sweep",
    tag = "forces",
    request_body = GridRequest,
    responses((status = 200, description = "Forces over a grid", content((GridReply = "application/json"), (String = "text/csv"))), InvalidBody, Limits)
)]
pub(crate) async fn sweep(
    State(service): State<Service>,
    format: Format,
    Input(Accepted { case, .. }): Input<GridCase>,
) -> Result<Response, Problem> {
    let cost = case.cost();
    service.pool().run(cost, move |pace| written(&case.reply(pace)?, format)).await
}
