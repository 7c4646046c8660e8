//! How the service is seen from outside.

use axum::http::HeaderValue;

/// How the service is seen from outside.
#[derive(Debug, Clone, Default)]
pub struct Outside {
    /// Where clients find it, without a slash at the end, if that was said.
    pub public_url: Option<String>,
    /// The origins of pages elsewhere that may read its answers; `*` for all of them.
    pub origins: Vec<HeaderValue>,
}
