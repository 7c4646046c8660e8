//! The forms of a series.

use axum::http::HeaderMap;
use axum::http::header::{ACCEPT, CONTENT_TYPE};

use super::media::{is_declared, is_json, is_utf_8, wanted};
use crate::problem::Problem;

/// A form in which a series comes or goes.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum SeriesForm {
    /// Columns in one JSON text.
    Json,
    /// A table.
    Csv,
    /// A JSON object a line.
    Ndjson,
}

impl SeriesForm {
    const ALL: [Self; 3] = [Self::Json, Self::Csv, Self::Ndjson];

    /// The form of a body.
    ///
    /// # Errors
    /// [`Problem::NotSeriesType`] for any other, and for another charset than UTF-8.
    pub(crate) fn of_body(headers: &HeaderMap) -> Result<Self, Problem> {
        let declared = headers.get(CONTENT_TYPE).and_then(|value| value.to_str().ok()).unwrap_or("");
        if !is_utf_8(declared) {
            return Err(Problem::NotSeriesType);
        }
        match Self::ALL.into_iter().find(|form| is_declared(headers, form.media_types())) {
            Some(form) => Ok(form),
            None if is_json(headers) => Ok(Self::Json),
            None => Err(Problem::NotSeriesType),
        }
    }

    /// The form that an answer to a body of this form is wanted in: the same unless another is preferred.
    pub(crate) fn of_answer(self, headers: &HeaderMap) -> Self {
        let Some(accept) = headers.get(ACCEPT).and_then(|value| value.to_str().ok()) else { return self };
        let wanted = |form: Self| wanted(accept, form.media_types());
        Self::ALL.into_iter().fold(self, |best, form| if wanted(form) > wanted(best) { form } else { best })
    }

    /// Its media types, the one that is sent first.
    pub(crate) fn media_types(self) -> &'static [&'static str] {
        match self {
            Self::Json => &["application/json"],
            Self::Csv => &["text/csv"],
            Self::Ndjson => &["application/x-ndjson", "application/ndjson", "application/jsonl"],
        }
    }
}
