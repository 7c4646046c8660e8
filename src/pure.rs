//! Answers of the API that follow from the address and the headers of a GET alone. They are tagged by what they follow from, not by
//! what they say: who has one already is told so before anything is computed.

use std::hash::{DefaultHasher, Hash, Hasher};

use axum::extract::Request;
use axum::http::header::{ACCEPT, CACHE_CONTROL, ETAG, VARY};
use axum::http::{HeaderMap, HeaderName, HeaderValue, Method, StatusCode};
use axum::response::{IntoResponse, Response};

use crate::accepted::Accepted;
use crate::fixed::{ASKED_ANEW, has, tag};

/// The code and the data that the program was built of, as one word.
const BUILD: &str = env!("VERSION_OF_BUILD");

/// What the answer to a request follows from, as one word.
pub(crate) struct Source(String);

impl Source {
    /// That of a request, if its answer is pure. `settings` is a number that other settings of the service change.
    pub(crate) fn of(request: &Request, settings: u64) -> Option<Self> {
        let is_pure = matches!(*request.method(), Method::GET | Method::HEAD) && request.uri().path().starts_with("/v1/");
        is_pure.then(|| {
            let mut hash = DefaultHasher::new();
            (BUILD, settings).hash(&mut hash);
            request.uri().path().hash(&mut hash);
            request.uri().query().hash(&mut hash);
            // Which form is wanted; what else the header says makes another word of it, and no harm.
            request.headers().get_all(ACCEPT).into_iter().for_each(|value| value.as_bytes().hash(&mut hash));
            Self(format!("{:016x}", hash.finish()))
        })
    }

    /// The answer to a client that has the answer already, in whatever coding.
    pub(crate) fn known(&self, request: &HeaderMap) -> Option<Response> {
        [None, Some(Accepted::Zstd), Some(Accepted::Gzip)].into_iter().find_map(|coding| {
            let tag = tag(&self.0, coding)?;
            has(request, |known| known.as_bytes() == tag.as_bytes())
                .then(|| (StatusCode::NOT_MODIFIED, headers(tag)).into_response())
        })
    }

    /// Tags an answer that has no tag of its own.
    pub(crate) fn tag(&self, response: &mut Response, coding: Option<Accepted>) {
        if response.status() == StatusCode::OK
            && !response.headers().contains_key(ETAG)
            && let Some(tag) = tag(&self.0, coding)
        {
            for (name, value) in headers(tag) {
                response.headers_mut().append(name, value);
            }
        }
    }
}

fn headers(tag: HeaderValue) -> [(HeaderName, HeaderValue); 3] {
    [(ETAG, tag), (CACHE_CONTROL, ASKED_ANEW), (VARY, HeaderValue::from_static("accept, accept-encoding"))]
}
