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
use crate::warning::Warning;

/// A checked request that has one reply.
pub(crate) trait Room: Request {
    type Reply: Reply;

    /// A request as a user would send it, for the contract.
    fn example() -> Value;

    /// What the reply costs.
    fn cost(&self) -> Cost;

    /// The reply where it takes next to no time although others of its cost may take long; none where only the work itself can tell.
    fn reply_at_once(&self) -> Option<Self::Reply> {
        None
    }

    /// The reply.
    ///
    /// # Errors
    /// What the model or the data do not allow, or why the work is to end.
    fn reply(&self, pace: &Pace) -> Result<Self::Reply, Problem>;

    /// What of the request may be meant otherwise, such as values in another unit; a failure to reply carries it.
    fn hints(&self) -> Vec<Warning> {
        Vec::new()
    }

    /// The reply, or why there is none with the hints.
    ///
    /// # Errors
    /// Those of [`reply`](Self::reply).
    fn reply_or_hints(&self, pace: &Pace) -> Result<Self::Reply, Problem> {
        self.reply(pace).map_err(|problem| problem.hinting(|| self.hints()))
    }
}

/// The reply to a request in the format asked for, computed where its cost has it.
pub(super) async fn answer<R: Room>(service: &Service, asked: Accepted<R>, format: Format) -> Result<Response, Problem> {
    let Accepted { case, assumed } = asked;
    let in_words = move |reply: R::Reply| match assumed {
        None => written(&reply, format),
        Some(assumed) => written(&Assuming::of(reply, assumed), format),
    };
    if let Some(reply) = case.reply_at_once() {
        return in_words(reply);
    }
    let cost = case.cost();
    service.pool().run(cost, move |pace: &Pace| in_words(case.reply_or_hints(pace)?)).await
}
