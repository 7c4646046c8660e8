//! The codings of an answer that a client takes (RFC 9110, section 12.5.3).

use axum::http::header::ACCEPT_ENCODING;
use axum::http::{HeaderMap, HeaderName};

/// A coding in which an answer can be sent.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum Accepted {
    Brotli,
    Zstd,
    Gzip,
}

impl Accepted {
    /// Its name in a header.
    pub(crate) fn name(self) -> &'static str {
        match self {
            Self::Brotli => "br",
            Self::Zstd => "zstd",
            Self::Gzip => "gzip",
        }
    }

    /// The coding of `offered` that a client wants most, the first of those that it wants alike; none where it takes none or would
    /// rather have the answer as it is.
    pub(crate) fn best_of(offered: &[Self], request: &HeaderMap) -> Option<Self> {
        if !request.contains_key(ACCEPT_ENCODING) {
            return None;
        }
        let plain = weight(request, "identity").unwrap_or(0.0);
        let any = weight(request, "*");
        let mut best = None;
        for &coding in offered {
            let weight = weight(request, coding.name()).or(any).unwrap_or(0.0);
            if weight > 0.0 && weight >= plain && best.is_none_or(|(_, most)| weight > most) {
                best = Some((coding, weight));
            }
        }
        best.map(|(coding, _)| coding)
    }
}

/// The weight that a client gives a coding by its name; one that cannot be read refuses it.
fn weight(request: &HeaderMap, coding: &str) -> Option<f64> {
    words(request, ACCEPT_ENCODING).find_map(|word| {
        let (name, parameters) = word.split_once(';').unwrap_or((word, ""));
        let weight = parameters.trim().strip_prefix("q=").map_or(Some(1.0), |weight| weight.parse::<f64>().ok());
        name.trim().eq_ignore_ascii_case(coding).then_some(weight.unwrap_or(0.0))
    })
}

/// The words of a header, which may come in several lines.
pub(crate) fn words(headers: &HeaderMap, name: HeaderName) -> impl Iterator<Item = &str> {
    headers.get_all(name).into_iter().filter_map(|value| value.to_str().ok()).flat_map(|value| value.split(',')).map(str::trim)
}

#[cfg(test)]
mod tests {
    use axum::http::HeaderValue;

    use super::*;

    fn best(accepted: &'static str) -> Option<Accepted> {
        let request = HeaderMap::from_iter([(ACCEPT_ENCODING, HeaderValue::from_static(accepted))]);
        Accepted::best_of(&[Accepted::Brotli, Accepted::Zstd, Accepted::Gzip], &request)
    }

    #[test]
    fn the_coding_that_is_wanted_most_is_sent() {
        for accepted in
            ["gzip", "deflate, GZIP;q=0.5", "gzip; q=0.001", "br;q=0.1, gzip;q=0.2", "gzip;q=1, *;q=0.1", "br;q=0, gzip"]
        {
            assert_eq!(best(accepted), Some(Accepted::Gzip), "{accepted}");
        }
        for accepted in ["br", "gzip, deflate, br, zstd", "*", "*;q=0.5, identity;q=0.5"] {
            assert_eq!(best(accepted), Some(Accepted::Brotli), "{accepted}");
        }
        assert_eq!(best("br;q=0, *"), Some(Accepted::Zstd));
        for accepted in ["", "deflate", "gzip;q=0", "*;q=0", "identity", "gzip;q=x", "gzip;q=0.5, identity"] {
            assert_eq!(best(accepted), None, "{accepted}");
        }
        assert_eq!(Accepted::best_of(&[Accepted::Gzip], &HeaderMap::new()), None);
    }
}
