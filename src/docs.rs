//! The explorer of the API: a page that draws the contract and sends the requests that its reader edits.

use axum::Router;
use axum::http::HeaderMap;
use axum::response::Redirect;
use axum::routing::get;

use crate::page::file;
use crate::state::Service;

/// The explorer; its modules are among the files of the page.
pub(crate) fn routes() -> Router<Service> {
    Router::new()
        .route("/docs", get(|headers: HeaderMap| async move { file("explorer/index.html", &headers) }))
        .route("/docs/", get(|| async { Redirect::permanent("../docs") }))
}
