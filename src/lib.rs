//! The terramechanics service: HTTP/JSON over the model crate, its OpenAPI contract and its plotting page.
//!
//! The way of a request: bytes → `extract` → a request object of `request`, which checks everything and reports every
//! fault → the model → a reply of `reply` → bytes. Physics live in the crate `terramechanics`, HTTP here.

mod api;
mod app;
mod catalogue;
mod compute;
pub mod config;
mod docs;
mod examples;
mod extract;
mod metrics;
mod observe;
mod openapi;
mod page;
mod paths;
mod problem;
mod reply;
mod request;
mod series;
pub mod server;
mod stream;
mod validation;
mod words;

/// What is fuzzed; there is none of it in the program.
#[cfg(fuzzing)]
pub mod fuzzing {
    /// What the reader of tables makes of the pieces of one, in words.
    #[must_use]
    pub fn csv_rows(pieces: &[&[u8]]) -> String {
        use crate::series::{ExtraColumns, Reader, all};
        let read = |extra| all(Reader::csv(extra), pieces);
        format!("{:?} {:?}", read(ExtraColumns::Refuse), read(ExtraColumns::Ignore))
    }
}

pub use app::{Limits, Service, app, layered};
pub use metrics::Metrics;
pub use openapi::{document as openapi_document, text as openapi_text};
