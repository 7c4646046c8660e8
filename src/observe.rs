//! What is noted of every request: an id, a count, a duration, a line in the log.

use std::collections::hash_map::RandomState;
use std::hash::{BuildHasher, Hasher};
use std::sync::LazyLock;
use std::sync::atomic::{AtomicU64, Ordering};
use std::time::Instant;

use axum::extract::{MatchedPath, Request};
use axum::http::header::X_CONTENT_TYPE_OPTIONS;
use axum::http::{HeaderName, HeaderValue, Method, StatusCode};
use axum::response::{IntoResponse, Response};

use crate::accepted::Accepted;
use crate::pure::Source;
use crate::state::Service;
use crate::{answer, catalogue, packing};

pub(crate) const REQUEST_ID: HeaderName = HeaderName::from_static("x-request-id");

/// The version of the model that answers, on every answer of the API.
pub(crate) const MODEL_VERSION: HeaderName = HeaderName::from_static("x-model-version");

/// The version of the catalogue that it takes presets from, beside it: a word that changes with any record.
pub(crate) const CATALOGUE_VERSION: HeaderName = HeaderName::from_static("x-catalogue-version");

/// Longest request id taken over from a client (bytes).
const LONGEST_ID: usize = 128;

/// Longest method that a line of the log shows (bytes).
const LONGEST_METHOD: usize = 20;

/// A request that is under way.
pub(crate) struct Noted {
    start: Instant,
    id: HeaderValue,
    method: Method,
    route: Option<MatchedPath>,
    is_of_api: bool,
    coding: Option<Accepted>,
    source: Option<Source>,
}

impl Noted {
    /// Notes a request that has arrived.
    pub(crate) fn of(request: &Request, service: &Service) -> Self {
        let start = Instant::now();
        let id = request.headers().get(REQUEST_ID).filter(|id| is_harmless(id)).cloned().unwrap_or_else(new_id);
        let method = request.method().clone();
        let route = request.extensions().get::<MatchedPath>().cloned();
        let is_of_api = request.uri().path().starts_with("/v1/");
        let coding = packing::wanted(request.headers());
        let source = Source::of(request, service.settings());
        Self { start, id, method, route, is_of_api, coding, source }
    }

    /// The answer to a client that has the answer already.
    pub(crate) fn known(&self, request: &Request) -> Option<Response> {
        self.source.as_ref()?.known(request.headers())
    }

    /// Its answer as it is sent, once it is noted, too.
    pub(crate) fn answered(self, response: Response, service: &Service) -> Response {
        let mut response = answer::admitted(response, service.answers()).unwrap_or_else(IntoResponse::into_response);
        let duration = self.start.elapsed();
        let status = response.status();
        let route = self.route.as_ref().map_or("none", MatchedPath::as_str);
        service.metrics().request(&self.method, route, status.as_u16(), duration);
        log(&self.id, &self.method, route, status, duration.as_micros());
        let coding = self.coding.and_then(|coding| packing::pack(&mut response, coding, service.packers()));
        if let Some(source) = self.source {
            source.tag(&mut response, coding);
        }
        let headers = response.headers_mut();
        headers.insert(REQUEST_ID, self.id);
        headers.insert(X_CONTENT_TYPE_OPTIONS, HeaderValue::from_static("nosniff"));
        if self.is_of_api {
            headers.insert(MODEL_VERSION, HeaderValue::from_static(terramechanics::VERSION));
            headers.insert(CATALOGUE_VERSION, HeaderValue::from_static(catalogue::VERSION));
        }
        response
    }
}

/// One line per request: failures of the service as errors, what it has no room or time for as warnings, failures of clients as
/// information, the rest for those who debug.
fn log(id: &HeaderValue, method: &Method, route: &str, status: StatusCode, micros: u128) {
    let id = id.to_str().unwrap_or("");
    // A method is any word that a client makes up, as long as the head may be.
    let method = method.as_str().get(..LONGEST_METHOD).unwrap_or(method.as_str());
    let status = status.as_u16();
    match status {
        503 => tracing::warn!(request_id = id, method, route, status, micros, "answered"),
        500.. => tracing::error!(request_id = id, method, route, status, micros, "answered"),
        400.. => tracing::info!(request_id = id, method, route, status, micros, "answered"),
        _ => tracing::debug!(request_id = id, method, route, status, micros, "answered"),
    }
}

/// Whether a client's id may stand in a log and a header.
fn is_harmless(id: &HeaderValue) -> bool {
    let id = id.as_bytes();
    (1..=LONGEST_ID).contains(&id.len()) && id.iter().all(|byte| byte.is_ascii_alphanumeric() || b"-_.:/+=".contains(byte))
}

/// An id that is unique within the process and, by its random start, most likely beyond it.
fn new_id() -> HeaderValue {
    static NEXT: LazyLock<AtomicU64> = LazyLock::new(|| AtomicU64::new(RandomState::new().build_hasher().finish()));
    const DIGITS: &[u8; 16] = b"0123456789abcdef";
    let id = NEXT.fetch_add(1, Ordering::Relaxed);
    let text: [u8; 16] = std::array::from_fn(|i| DIGITS[(id >> (60 - 4 * i) & 15) as usize]);
    HeaderValue::from_bytes(&text).unwrap_or_else(|_| HeaderValue::from_static("none"))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn ids_differ_and_are_harmless() {
        let (a, b) = (new_id(), new_id());
        assert!(a != b && is_harmless(&a) && a.len() == 16);
    }

    #[test]
    fn a_clients_id_is_taken_only_if_it_is_harmless() {
        assert!(is_harmless(&HeaderValue::from_static("trace-1:2/3")));
        for bad in ["", "a b", "a\"b", "{x}"] {
            assert!(!is_harmless(&HeaderValue::from_str(bad).expect("a header")), "{bad}");
        }
        assert!(!is_harmless(&HeaderValue::from_str(&"a".repeat(129)).expect("a header")));
    }
}
