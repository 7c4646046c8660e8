//! `GET /problems` and its single kinds: what the `type` of a problem document means.

use axum::response::Response;
use serde::Serialize;
use utoipa::ToSchema;

use super::responses::{InvalidQuery, Limits, UnknownName};
use crate::answer::json;
use crate::extract::NoQuery;
use crate::name::Name;
use crate::problem::{Kind, Problem};
use crate::words::nearest;

/// The kinds of failures.
#[derive(Serialize, ToSchema)]
#[schema(as = ProblemKinds)]
struct KindsReply {
    problems: Vec<Kind>,
}

/// The kinds of failures
///
/// The last part of the `type` of a problem document is the `name` of its kind.
#[utoipa::path(get, path = "/problems", tag = "operations", responses((status = 200, description = "The kinds", body = KindsReply), InvalidQuery, Limits))]
pub(crate) async fn problems(_: NoQuery) -> Result<Response, Problem> {
    json(&KindsReply { problems: Kind::ALL.into_iter().copied().collect() })
}

/// One kind of failure
///
/// The address that a problem document has for its `type`.
#[utoipa::path(
    get,
    path = "/problems/{name}",
    tag = "operations",
    params(("name" = String, Path, description = "Name of the kind", example = "too-costly")),
    responses((status = 200, description = "The kind", body = Kind), InvalidQuery, UnknownName, Limits)
)]
pub(crate) async fn problem(Name(name): Name, _: NoQuery) -> Result<Response, Problem> {
    let names = || Kind::ALL.map(|kind| kind.name);
    let hint = || {
        nearest(&name, &names())
            .map_or_else(|| format!("known are {}", names().join(", ")), |near| format!("did you mean `{near}`?"))
    };
    json(Kind::named(&name).ok_or_else(|| Problem::NotFound(format!("there is no such kind of problem; {}", hint())))?)
}
