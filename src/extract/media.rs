//! Media types, as headers declare and accept them.

use axum::http::HeaderMap;
use axum::http::header::CONTENT_TYPE;

/// Whether the body is declared as `application/json` or another type with the suffix `+json`.
pub(super) fn is_json(headers: &HeaderMap) -> bool {
    let declared = headers.get(CONTENT_TYPE).and_then(|value| value.to_str().ok()).unwrap_or("");
    let essence = declared.split(';').next().unwrap_or("").trim();
    essence.eq_ignore_ascii_case("application/json")
        || (essence.len() > 5
            && essence.is_char_boundary(essence.len() - 5)
            && essence[essence.len() - 5..].eq_ignore_ascii_case("+json"))
}

/// Whether the body is declared as one of these media types.
pub(super) fn is_declared(headers: &HeaderMap, known: &[&str]) -> bool {
    let declared = headers.get(CONTENT_TYPE).and_then(|value| value.to_str().ok()).unwrap_or("");
    let essence = declared.split(';').next().unwrap_or("").trim();
    known.iter().any(|known| essence.eq_ignore_ascii_case(known))
}

/// How much an Accept header wants one of several media types, from 0 to 1.
pub(super) fn wanted(accept: &str, media_types: &[&str]) -> f64 {
    let of = |known: &&str| known.split_once('/').map_or(0.0, |(kind, subtype)| quality(accept, kind, subtype));
    media_types.iter().map(of).fold(0.0, f64::max)
}

/// Whether a media type declares no charset, or one that UTF-8 covers.
pub(super) fn is_utf_8(declared: &str) -> bool {
    let parameters = declared.split(';').skip(1).filter_map(|parameter| parameter.split_once('='));
    let mut charsets = parameters.filter(|(name, _)| name.trim().eq_ignore_ascii_case("charset"));
    charsets.all(|(_, charset)| {
        let charset = charset.trim().trim_matches('"');
        ["utf-8", "utf8", "us-ascii"].iter().any(|known| charset.eq_ignore_ascii_case(known))
    })
}

/// How much an Accept header wants a media type, from 0 to 1.
pub(super) fn quality(accept: &str, kind: &str, subtype: &str) -> f64 {
    let ranges = accept.split(',').filter_map(|range| {
        let mut parts = range.split(';').map(str::trim);
        let (main, sub) = parts.next()?.split_once('/')?;
        let specificity = match (main, sub) {
            _ if main.eq_ignore_ascii_case(kind) && sub.eq_ignore_ascii_case(subtype) => 2,
            (_, "*") if main.eq_ignore_ascii_case(kind) => 1,
            ("*", "*") => 0,
            _ => return None,
        };
        let weight = parts.find_map(|part| part.strip_prefix("q=").or_else(|| part.strip_prefix("Q=")));
        Some((specificity, weight.map_or(Some(1.0), |weight| weight.parse::<f64>().ok())?))
    });
    ranges.max_by_key(|(specificity, _)| *specificity).map_or(0.0, |(_, weight)| weight)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn json_may_be_declared_with_parameters_or_as_a_suffix() {
        let declared = |value: &'static str| is_json(&HeaderMap::from_iter([(CONTENT_TYPE, value.parse().expect("a header"))]));
        for yes in ["application/json", "Application/JSON; charset=utf-8", "application/merge-patch+json"] {
            assert!(declared(yes), "{yes}");
        }
        for no in ["text/plain", "application/x-www-form-urlencoded", "json", "", "+json"] {
            assert!(!declared(no), "{no}");
        }
        assert!(!is_json(&HeaderMap::new()));
    }
}
