//! Texts that stay the same for as long as the program runs: packed once, tagged by what they hold, and not sent again to those who
//! have them.

use std::hash::{DefaultHasher, Hash, Hasher};
use std::io::Write;

use axum::body::Bytes;
use axum::http::header::{CACHE_CONTROL, CONTENT_ENCODING, CONTENT_TYPE, ETAG, IF_NONE_MATCH, VARY};
use axum::http::{HeaderMap, HeaderValue, StatusCode};
use axum::response::{IntoResponse, Response};
use flate2::Compression;
use flate2::write::GzEncoder;

use crate::accepted::{Accepted, words};

/// Shortest text that is packed (bytes): a shorter one fits into a packet as it is.
pub(crate) const SHORT: usize = 1 << 10;

/// Asked for anew each time, answered in full only when it has changed: a new version is seen at once.
pub(crate) const ASKED_ANEW: HeaderValue = HeaderValue::from_static("no-cache");

/// A text with its tag, as it is and packed.
#[derive(Debug, Clone)]
pub(crate) struct Fixed {
    plain: Form,
    packed: Vec<(Accepted, Form)>,
    media_type: &'static str,
    vary: &'static str,
}

#[derive(Debug, Clone)]
struct Form {
    bytes: Bytes,
    /// A strong tag is of the bytes that are sent, so each form has its own.
    tag: HeaderValue,
}

/// Marks an answer that comes in the form that suits its client best.
#[derive(Debug, Clone, Copy)]
pub(crate) struct InItsForm;

impl Fixed {
    /// A text; `version` is a word that is another one for every other text, and `ahead` are forms of it that were packed before.
    pub(crate) fn new(bytes: Bytes, version: &str, media_type: &'static str, ahead: Vec<(Accepted, Bytes)>) -> Self {
        let form = |bytes, coding| Some(Form { bytes, tag: tag(version, coding)? });
        let is_packed = |coding| ahead.iter().any(|(known, _)| *known == coding);
        let gzip = (bytes.len() >= SHORT && !is_packed(Accepted::Gzip)).then(|| Some((Accepted::Gzip, gzip(&bytes)?))).flatten();
        let packed = ahead.into_iter().chain(gzip);
        let packed = packed.filter_map(|(coding, bytes)| Some((coding, form(bytes, Some(coding))?))).collect();
        let plain = form(bytes.clone(), None).unwrap_or(Form { bytes, tag: HeaderValue::from_static("\"\"") });
        Self { plain, packed, media_type, vary: "accept-encoding" }
    }

    /// A text without a version, tagged by what it says.
    pub(crate) fn tagged(bytes: Bytes, media_type: &'static str) -> Self {
        let mut hash = DefaultHasher::new();
        bytes.hash(&mut hash);
        Self::new(bytes, &format!("{:016x}", hash.finish()), media_type, Vec::new())
    }

    /// Such a text, one of several at an address, between which the header Accept chooses.
    pub(crate) fn negotiated(bytes: Bytes, media_type: &'static str) -> Self {
        Self { vary: "accept, accept-encoding", ..Self::tagged(bytes, media_type) }
    }

    /// The text for a request with these headers; without it where the client has it already.
    pub(crate) fn answer(&self, request: &HeaderMap) -> Response {
        let offered: Vec<Accepted> = self.packed.iter().map(|(coding, _)| *coding).collect();
        let coding = Accepted::best_of(&offered, request);
        let packed = self.packed.iter().find(|(known, _)| Some(*known) == coding);
        let Form { bytes, tag } = packed.map_or(&self.plain, |(_, form)| form);
        let headers = [
            (ETAG, tag.clone()),
            (CACHE_CONTROL, ASKED_ANEW),
            (CONTENT_TYPE, HeaderValue::from_static(self.media_type)),
            (VARY, HeaderValue::from_static(self.vary)),
        ];
        if has(request, |known| known == "*" || known.as_bytes() == tag.as_bytes()) {
            return (StatusCode::NOT_MODIFIED, headers).into_response();
        }
        let mut response = (headers, bytes.clone()).into_response();
        if let Some((coding, _)) = packed {
            response.headers_mut().insert(CONTENT_ENCODING, HeaderValue::from_static(coding.name()));
        }
        response.extensions_mut().insert(InItsForm);
        response
    }
}

/// The strong tag of a version of a text in a coding.
pub(crate) fn tag(version: &str, coding: Option<Accepted>) -> Option<HeaderValue> {
    let tag = match coding {
        None => format!("\"{version}\""),
        Some(coding) => format!("\"{version}-{}\"", coding.name()),
    };
    HeaderValue::from_str(&tag).ok()
}

/// Whether a client says that it has the text of one of these tags (RFC 9110, section 13.1.2).
pub(crate) fn has(request: &HeaderMap, is_one: impl Fn(&str) -> bool) -> bool {
    words(request, IF_NONE_MATCH).any(|known| is_one(known.trim_start_matches("W/")))
}

fn gzip(bytes: &[u8]) -> Option<Bytes> {
    let mut writer = GzEncoder::new(Vec::new(), Compression::best());
    writer.write_all(bytes).ok()?;
    let packed = writer.finish().ok()?;
    (packed.len() < bytes.len()).then(|| packed.into())
}
