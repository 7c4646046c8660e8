//! A request that stands in a body.

use axum::body::Body;
use axum::extract::FromRequest;
use axum::http::Request;
use axum::http::header::CONTENT_LENGTH;
use terramechanics_reading::{FieldFault, Unread, fault_in_words, json};

use super::media::is_json;
use crate::body;
use crate::compute::Cost;
use crate::problem::Problem;
use crate::request::{self, Accepted, accepted};
use crate::state::Service;

/// A request body that was read and checked.
pub(crate) struct Input<R>(pub(crate) Accepted<R>);

impl<R: request::Request> FromRequest<Service> for Input<R> {
    type Rejection = Problem;

    async fn from_request(request: Request<Body>, service: &Service) -> Result<Self, Problem> {
        if !is_json(request.headers()) {
            return Err(Problem::NotJsonType);
        }
        let declared = request.headers().get(CONTENT_LENGTH).and_then(|length| length.to_str().ok()?.parse::<usize>().ok());
        let body = body::read(request.into_body(), declared, service).await?;
        service.pool().run(Cost::of_body(body.bytes.len()), move |_| read::<R>(&body.bytes)).await.map(Self)
    }
}

/// Reads and checks a body.
///
/// # Errors
/// [`Problem::NotJson`], and [`Problem::Invalid`] with all faults.
pub(crate) fn read<R: request::Request>(body: &[u8]) -> Result<Accepted<R>, Problem> {
    let node = json(body).map_err(|unread| match unread {
        Unread::NotJson(error) => {
            let (line, column) = (error.line(), error.column());
            Problem::NotJson { detail: fault_in_words(body, &error), line, column }
        }
        Unread::TooMuch => Problem::Invalid(vec![FieldFault::new("", unread)]),
    })?;
    accepted(&node).map_err(Problem::Invalid)
}
