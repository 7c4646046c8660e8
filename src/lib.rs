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
mod problem;
mod reply;
mod request;
pub mod server;
mod validation;
mod wire;

pub use app::{Limits, Service, app, layered};
pub use metrics::Metrics;
pub use openapi::{document as openapi_document, text as openapi_text};
