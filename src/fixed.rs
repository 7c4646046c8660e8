//! Texts that stay the same for as long as the program runs: packed once, tagged by what they hold, and not sent again to those who
//! have them.

use std::io::Write;

use axum::body::Bytes;
use axum::http::header::{ACCEPT_ENCODING, CACHE_CONTROL, CONTENT_ENCODING, CONTENT_TYPE, ETAG, IF_NONE_MATCH, VARY};
use axum::http::{HeaderMap, HeaderValue, StatusCode};
use axum::response::{IntoResponse, Response};
use flate2::Compression;
use flate2::write::GzEncoder;

/// Shortest text that is packed (bytes): a shorter one fits into a packet as it is.
const SHORT: usize = 1 << 10;

/// A text with its tag, as it is and packed.
#[derive(Debug, Clone)]
pub(crate) struct Fixed {
    plain: Form,
    packed: Option<Form>,
    media_type: &'static str,
}

#[derive(Debug, Clone)]
struct Form {
    bytes: Bytes,
    /// A strong tag is of the bytes that are sent, so each form has its own.
    tag: HeaderValue,
}

impl Fixed {
    /// A text; `version` is a word that is another one for every other text.
    pub(crate) fn new(bytes: Bytes, version: &str, media_type: &'static str) -> Self {
        let form =
            |bytes, suffix: &str| Some(Form { bytes, tag: HeaderValue::from_str(&format!("\"{version}{suffix}\"")).ok()? });
        let packed = (bytes.len() >= SHORT).then(|| packed(&bytes)).flatten().and_then(|bytes| form(bytes, "-gzip"));
        let plain = form(bytes.clone(), "").unwrap_or(Form { bytes, tag: HeaderValue::from_static("\"\"") });
        Self { plain, packed, media_type }
    }

    /// The text for a request with these headers; without it where the client has it already.
    pub(crate) fn answer(&self, request: &HeaderMap) -> Response {
        let packed = self.packed.as_ref().filter(|_| takes_gzip(request));
        let Form { bytes, tag } = packed.unwrap_or(&self.plain);
        let headers = [
            (ETAG, tag.clone()),
            // Asked for anew each time, answered in full only when it has changed: a new version is seen at once.
            (CACHE_CONTROL, HeaderValue::from_static("no-cache")),
            (CONTENT_TYPE, HeaderValue::from_static(self.media_type)),
            (VARY, HeaderValue::from_static("accept-encoding")),
        ];
        if is_known(request, tag) {
            return (StatusCode::NOT_MODIFIED, headers).into_response();
        }
        let mut response = (headers, bytes.clone()).into_response();
        if packed.is_some() {
            response.headers_mut().insert(CONTENT_ENCODING, HeaderValue::from_static("gzip"));
        }
        response
    }
}

/// The words of a header, which may come in several lines.
fn words(headers: &HeaderMap, name: axum::http::HeaderName) -> impl Iterator<Item = &str> {
    headers.get_all(name).into_iter().filter_map(|value| value.to_str().ok()).flat_map(|value| value.split(',')).map(str::trim)
}

/// Whether a client has the text of a tag (RFC 9110, section 13.1.2).
fn is_known(request: &HeaderMap, tag: &HeaderValue) -> bool {
    words(request, IF_NONE_MATCH).any(|known| known == "*" || known.trim_start_matches("W/").as_bytes() == tag.as_bytes())
}

/// Whether a client takes gzip (RFC 9110, section 12.5.3).
fn takes_gzip(request: &HeaderMap) -> bool {
    let weight = |coding: &str| {
        words(request, ACCEPT_ENCODING).find_map(|word| {
            let (name, parameters) = word.split_once(';').unwrap_or((word, ""));
            let weight = parameters.trim().strip_prefix("q=").map_or(Some(1.0), |weight| weight.parse::<f64>().ok());
            name.trim().eq_ignore_ascii_case(coding).then_some(weight.unwrap_or(0.0))
        })
    };
    weight("gzip").or_else(|| weight("*")).is_some_and(|weight| weight > 0.0)
}

fn packed(bytes: &[u8]) -> Option<Bytes> {
    let mut writer = GzEncoder::new(Vec::new(), Compression::best());
    writer.write_all(bytes).ok()?;
    let packed = writer.finish().ok()?;
    (packed.len() < bytes.len()).then(|| packed.into())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn gzip_is_sent_where_it_is_taken() {
        let takes = |value: &'static str| takes_gzip(&HeaderMap::from_iter([(ACCEPT_ENCODING, HeaderValue::from_static(value))]));
        for yes in ["gzip", "deflate, GZIP;q=0.5, br", "*", "br;q=1, *;q=0.1", "gzip; q=0.001"] {
            assert!(takes(yes), "{yes}");
        }
        for no in ["", "br", "gzip;q=0", "*;q=0", "gzip;q=0, *", "identity", "gzip;q=x"] {
            assert!(!takes(no), "{no}");
        }
        assert!(!takes_gzip(&HeaderMap::new()));
    }
}
