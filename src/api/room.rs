//! What the rooms of the API have in common: one request, one reply, and an example of both.

use axum::response::Response;
use serde_json::Value;

use crate::answer::written;
use crate::compute::{Cost, Pace};
use crate::extract::Format;
use crate::problem::Problem;
use crate::reply::{Assuming, Reply};
use crate::request::{Accepted, Request};
use crate::state::Service;

/// A checked request that has one reply.
pub(crate) trait Room: Request {
    type Reply: Reply;

    /// A request as a user would send it, for the contract.
    fn example() -> Value;

    /// What the reply costs.
    fn cost(&self) -> Cost;

    /// The reply.
    ///
    /// # Errors
    /// What the model or the data do not allow, or why the work is to end.
    fn reply(&self, pace: &Pace) -> Result<Self::Reply, Problem>;
}

/// The reply to a request in the format asked for, computed where its cost has it.
pub(super) async fn answer<R: Room>(service: &Service, asked: Accepted<R>, format: Format) -> Result<Response, Problem> {
    let Accepted { case, assumed } = asked;
    let cost = case.cost();
    let work = move |pace: &Pace| {
        let reply = case.reply(pace)?;
        match assumed {
            None => written(&reply, format),
            Some(assumed) => written(&Assuming::of(reply, assumed), format),
        }
    };
    service.pool().run(cost, work).await
}
