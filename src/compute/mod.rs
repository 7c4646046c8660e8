//! Where computations run: what costs next to nothing at once, the rest on a bounded pool apart from the threads that serve
//! connections.

mod cost;
mod pace;
mod pool;
mod turns;

pub(crate) use cost::Cost;
pub(crate) use pace::{Pace, SLICE, Stop};
pub(crate) use pool::{Place, Pool, PoolBounds};

use axum::http::HeaderValue;
use axum::http::header::CONTENT_TYPE;
use axum::response::{IntoResponse, Response};

use crate::extract::Format;
use crate::problem::Problem;
use crate::quantity::csv;
use crate::reply::Reply;

/// A reply in the format that was asked for.
pub(crate) fn written<R: Reply>(reply: &R, format: Format) -> Result<Response, Problem> {
    match format {
        Format::Json => json(reply),
        Format::Csv => {
            let mut response = csv_text(csv(&reply.columns()));
            let headers = response.headers_mut();
            // A table has no place for warnings, so their codes travel beside it, each once.
            let mut codes: Vec<&str> = Vec::new();
            for warning in reply.warnings() {
                if !codes.contains(&warning.code()) {
                    codes.push(warning.code());
                }
            }
            if let Ok(codes) = HeaderValue::from_str(&codes.join(", "))
                && !codes.is_empty()
            {
                headers.insert("x-warnings", codes);
            }
            Ok(response)
        }
    }
}

/// A value as JSON.
pub(crate) fn json<T: serde::Serialize>(value: &T) -> Result<Response, Problem> {
    let mut text = Vec::with_capacity(1024);
    serde_json::to_writer(&mut text, value).map_err(|error| {
        tracing::error!(%error, "a reply could not be written");
        Problem::Internal
    })?;
    Ok(json_text(text))
}

/// A text that is a table.
pub(crate) fn csv_text(text: impl IntoResponse) -> Response {
    ([(CONTENT_TYPE, HeaderValue::from_static("text/csv; charset=utf-8; header=present"))], text).into_response()
}

/// A text that is JSON.
pub(crate) fn json_text(text: impl IntoResponse) -> Response {
    ([(CONTENT_TYPE, HeaderValue::from_static("application/json"))], text).into_response()
}
