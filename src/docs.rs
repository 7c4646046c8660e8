//! The explorer of the API: Swagger UI with its own files, so that it works without internet.

use std::borrow::Cow;
use std::sync::Arc;

use axum::Router;
use axum::body::Bytes;
use axum::http::header::{CONTENT_SECURITY_POLICY, CONTENT_TYPE};
use axum::response::{IntoResponse, Response};
use axum::routing::get;
use utoipa_swagger_ui::{Config, serve};

use crate::name::Name;
use crate::problem::Problem;
use crate::state::Service;
use terramechanics_reading::shortened;

/// Swagger UI sets styles on its elements from scripts, which needs `'unsafe-inline'` for styles; scripts stay its own.
const POLICY: &str = "default-src 'none'; script-src 'self'; style-src 'self' 'unsafe-inline'; img-src 'self' data:; \
                      connect-src 'self'; base-uri 'self'; form-action 'none'; frame-ancestors 'none'";

/// The explorer and its files.
pub(crate) fn routes() -> Router<Service> {
    // Off localhost Swagger UI would send the document's address to a validator on the internet.
    let config = Arc::new(Config::from("/openapi.json").validator_url("none").try_it_out_enabled(true));
    let index = config.clone();
    Router::new()
        .route("/docs", get(|| async move { file("index.html", &index) }))
        .route("/docs/", get(|| async { axum::response::Redirect::permanent("/docs") }))
        .route("/docs/{name}", get(|Name(name): Name| async move { file(&name, &config) }))
}

fn file(name: &str, config: &Arc<Config<'static>>) -> Result<Response, Problem> {
    let found = serve(name, config.clone()).map_err(|error| {
        tracing::error!(%error, "the explorer could not be read");
        Problem::Internal
    })?;
    let file = found.ok_or_else(|| Problem::NotFound(format!("no such file: {}", shortened(name))))?;
    let bytes = match file.bytes {
        // Its page names its files relative to /docs/, but is served at /docs.
        bytes if name == "index.html" => {
            String::from_utf8_lossy(&bytes).replacen("<head>", "<head><base href=\"/docs/\">", 1).into()
        }
        Cow::Borrowed(bytes) => Bytes::from_static(bytes),
        Cow::Owned(bytes) => bytes.into(),
    };
    Ok(([(CONTENT_TYPE, file.content_type.as_str()), (CONTENT_SECURITY_POLICY, POLICY)], bytes).into_response())
}
