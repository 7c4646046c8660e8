//! What a request has to keep of HTTP/1.1 before anything else is asked of it.
//!
//! hyper refuses a head that it cannot read, lengths that differ, and a transfer coding that does not end in `chunked`. Two more
//! things are refused here, because a proxy in front may read them otherwise than this service: where the request goes and where its
//! body ends. A length beside a transfer coding is taken off by hyper before it can be seen here; it reads the chunks and closes
//! the connection after the answer, as RFC 9112 (section 6.3) allows.

use axum::extract::Request;
use axum::http::header::{CONTENT_LENGTH, HOST, TRANSFER_ENCODING};
use axum::http::uri::Authority;
use axum::http::{HeaderMap, HeaderValue, Version};

use crate::problem::Problem;
use crate::{coding, rest};

/// The length of the body was declared, though it is no longer known: it was that of the packed body.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Declared;

/// The request with a body that is ready for its reader.
///
/// # Errors
/// The answer to one that is ambiguous, or packed in a way that is not known.
pub(crate) fn received(request: Request) -> Result<Request, Problem> {
    let (mut parts, body) = request.into_parts();
    if let Some(fault) = ambiguity(parts.version, &parts.headers) {
        return Err(Problem::Ambiguous(fault));
    }
    let is_declared = parts.headers.contains_key(CONTENT_LENGTH);
    let body = rest::read_to_its_end(body, &parts.headers);
    let body = coding::unpacked(body, &mut parts.headers)?;
    if is_declared && !parts.headers.contains_key(CONTENT_LENGTH) {
        parts.extensions.insert(Declared);
    }
    Ok(Request::from_parts(parts, body))
}

/// What is ambiguous about a request.
fn ambiguity(version: Version, headers: &HeaderMap) -> Option<&'static str> {
    let mut hosts = headers.get_all(HOST).iter();
    match (hosts.next(), hosts.next()) {
        (None, _) if version >= Version::HTTP_11 => return Some("a request has a header Host"),
        (Some(_), Some(_)) => return Some("a request has one header Host, not several"),
        (Some(host), None) if !is_host(host) => {
            return Some("the header Host has to be a name or an address, with or without a port");
        }
        _ => {}
    }
    let mut codings = headers.get_all(TRANSFER_ENCODING).iter();
    let is_chunked = |coding: &HeaderValue| coding.as_bytes().trim_ascii().eq_ignore_ascii_case(b"chunked");
    let is_known = codings.next().is_none_or(is_chunked) && codings.next().is_none();
    (!is_known).then_some("the only Transfer-Encoding is chunked, given once")
}

/// Whether a value is a host with or without a port (RFC 9110, section 7.2). An empty one is allowed.
fn is_host(value: &HeaderValue) -> bool {
    let value = value.as_bytes();
    if value.is_empty() {
        return true;
    }
    let Ok(authority) = Authority::try_from(value) else { return false };
    let host = authority.host();
    // What stands before the host, a user, does not belong here.
    let Some(port) = authority.as_str().strip_prefix(host) else { return false };
    let port = port.strip_prefix(':').unwrap_or("0");
    let is_port = port.is_empty() || (port.bytes().all(|byte| byte.is_ascii_digit()) && port.parse::<u16>().is_ok());
    !host.is_empty() && is_port
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_host_is_a_name_or_an_address_with_or_without_a_port() {
        let is_host = |text: &str| is_host(&HeaderValue::from_str(text).expect("a header"));
        for right in ["", "localhost", "localhost:8080", "127.0.0.1", "[::1]:80", "[::1]", "a.example.org:", "x-y_z.1"] {
            assert!(is_host(right), "{right}");
        }
        for wrong in
            ["a b", "a/b", "http://a", "user@a", "a:b", "a:70000", "a:+80", ":80", "a?b", "a#b", "[::1", "::1", "a:1:2", "a\\b"]
        {
            assert!(!is_host(wrong), "{wrong}");
        }
    }
}
