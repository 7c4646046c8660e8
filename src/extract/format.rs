//! The format of an answer.

use axum::http::HeaderMap;
use axum::http::header::ACCEPT;

use super::media::quality;

/// The format of an answer that has columns.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum Format {
    /// JSON, unless something else was asked for.
    Json,
    /// One header row, then one row per point.
    Csv,
}

impl Format {
    /// What the headers of a request ask for.
    pub(super) fn of(headers: &HeaderMap) -> Self {
        let accept = headers.get(ACCEPT).and_then(|value| value.to_str().ok());
        accept.map_or(Self::Json, Self::preferred)
    }

    /// The format that an Accept header prefers (RFC 9110, section 12.5.1); JSON where it accepts neither or both alike.
    fn preferred(accept: &str) -> Self {
        if quality(accept, "text", "csv") > quality(accept, "application", "json") { Self::Csv } else { Self::Json }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn csv_is_sent_only_where_it_is_preferred() {
        for accept in
            ["text/csv", "text/csv, */*;q=0.1", "application/json;q=0.5, text/csv", "TEXT/CSV", "text/*, application/json;q=0.9"]
        {
            assert_eq!(Format::preferred(accept), Format::Csv, "{accept}");
        }
        for accept in [
            "",
            "*/*",
            "application/json",
            "text/csv;q=0",
            "text/csv;q=0.5, application/json",
            "text/html",
            "text/csv;q=x",
            ";;,,/",
        ] {
            assert_eq!(Format::preferred(accept), Format::Json, "{accept}");
        }
    }
}
