//! The plotting page, embedded in the binary.

use std::borrow::Cow;
use std::collections::HashMap;
use std::sync::{LazyLock, OnceLock};

use axum::Router;
use axum::body::Bytes;
use axum::http::header::{CONTENT_SECURITY_POLICY, REFERRER_POLICY};
use axum::http::{HeaderMap, HeaderValue};
use axum::response::{IntoResponse, Response};
use axum::routing::get;
use rust_embed::{Embed, EmbeddedFile};

use crate::accepted::Accepted;
use crate::fixed::Fixed;
use crate::name::Name;
use crate::problem::Problem;
use crate::state::Service;
use terramechanics_reading::shortened;

#[derive(Embed)]
#[folder = "static/"]
struct Files;

/// Those of them that get shorter by it, as the build packed them.
#[derive(Embed)]
#[folder = "$OUT_DIR/packed/"]
struct Packed;

/// The page runs its own scripts and styles and asks its own server, nothing else.
const POLICY: &str = "default-src 'none'; script-src 'self'; style-src 'self'; img-src 'self' data:; connect-src 'self'; \
                      base-uri 'none'; form-action 'none'; frame-ancestors 'none'";

/// The page and its files.
pub(crate) fn routes() -> Router<Service> {
    Router::new()
        .route("/", get(|headers: HeaderMap| async move { file("index.html", &headers) }))
        .route("/static/{*name}", get(|Name(name): Name, headers: HeaderMap| async move { file(&name, &headers) }))
        .route("/favicon.ico", get(|headers: HeaderMap| async move { file("icon.svg", &headers) }))
}

/// A file of the page.
///
/// # Errors
/// [`Problem::NotFound`] for another name.
pub(crate) fn file(name: &str, request: &HeaderMap) -> Result<Response, Problem> {
    /// Each is packed when it is first asked for.
    static FIXED: LazyLock<HashMap<Cow<'static, str>, OnceLock<Fixed>>> =
        LazyLock::new(|| Files::iter().map(|name| (name, OnceLock::new())).collect());
    let not_found = || Problem::NotFound(format!("no such file: {}", shortened(name)));
    let fixed = FIXED.get(name).ok_or_else(not_found)?;
    let fixed = match fixed.get() {
        Some(fixed) => fixed,
        None => {
            let file = Files::get(name).ok_or_else(not_found)?;
            fixed.get_or_init(|| fixed_file(name, file))
        }
    };
    let policies =
        [(CONTENT_SECURITY_POLICY, HeaderValue::from_static(POLICY)), (REFERRER_POLICY, HeaderValue::from_static("no-referrer"))];
    Ok((policies, fixed.answer(request)).into_response())
}

fn fixed_file(name: &str, EmbeddedFile { data, metadata }: EmbeddedFile) -> Fixed {
    let version: String = metadata.sha256_hash()[..8].iter().map(|byte| format!("{byte:02x}")).collect();
    let packed = Packed::get(name).map(|packed| (Accepted::Brotli, bytes(packed.data)));
    Fixed::new(bytes(data), &version, content_type(name), packed.into_iter().collect())
}

fn bytes(data: Cow<'static, [u8]>) -> Bytes {
    match data {
        Cow::Borrowed(bytes) => Bytes::from_static(bytes),
        Cow::Owned(bytes) => bytes.into(),
    }
}

fn content_type(name: &str) -> &'static str {
    match name.rsplit('.').next() {
        Some("html") => "text/html; charset=utf-8",
        Some("css") => "text/css; charset=utf-8",
        Some("js") => "text/javascript; charset=utf-8",
        Some("svg") => "image/svg+xml",
        _ => "application/octet-stream",
    }
}
