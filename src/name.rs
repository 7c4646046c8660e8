//! The name in a path, as a handler takes it.

use axum::extract::{FromRequestParts, Path};
use axum::http::request::Parts;

use crate::problem::Problem;

/// A name in a path.
pub(crate) struct Name(pub(crate) String);

impl<S: Sync> FromRequestParts<S> for Name {
    type Rejection = Problem;

    async fn from_request_parts(parts: &mut Parts, _: &S) -> Result<Self, Problem> {
        match Path::<String>::from_request_parts(parts, &()).await {
            Ok(Path(name)) => Ok(Self(name)),
            Err(_) => Err(Problem::NotFound("nothing has that name, which is not UTF-8".into())),
        }
    }
}
