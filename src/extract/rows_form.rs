//! The forms of a batch.

use axum::http::HeaderMap;
use axum::http::header::{ACCEPT, CONTENT_TYPE};

use super::media::{is_declared, is_utf_8, wanted};
use crate::problem::Problem;

/// A form in which the rows of a batch come or go.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum RowsForm {
    /// A table.
    Csv,
    /// A JSON object a line.
    Ndjson,
    /// Record batches, as a stream of Arrow's messages.
    Arrow,
}

impl RowsForm {
    const ALL: [Self; 3] = [Self::Csv, Self::Ndjson, Self::Arrow];

    /// The form of a body.
    ///
    /// # Errors
    /// [`Problem::NotRowsType`] for any other, and for another charset than UTF-8.
    pub(crate) fn of_body(headers: &HeaderMap) -> Result<Self, Problem> {
        let declared = headers.get(CONTENT_TYPE).and_then(|value| value.to_str().ok()).unwrap_or("");
        let form = Self::ALL.into_iter().find(|form| is_declared(headers, form.media_types()));
        form.filter(|_| is_utf_8(declared)).ok_or(Problem::NotRowsType)
    }

    /// The form that an answer to a body of this form is wanted in: the same unless another is preferred.
    pub(crate) fn of_answer(self, headers: &HeaderMap) -> Self {
        let Some(accept) = headers.get(ACCEPT).and_then(|value| value.to_str().ok()) else { return self };
        let wanted = |form: Self| wanted(accept, form.media_types());
        Self::ALL.into_iter().fold(self, |best, form| if wanted(form) > wanted(best) { form } else { best })
    }

    /// The form of rows in which an answer to a JSON body is wanted; none where JSON is wanted, or no form is preferred to it.
    pub(crate) fn preferred_to_json(headers: &HeaderMap) -> Option<Self> {
        let accept = headers.get(ACCEPT).and_then(|value| value.to_str().ok())?;
        let mut most = wanted(accept, &["application/json"]);
        let mut best = None;
        for form in Self::ALL {
            let wanted = wanted(accept, form.media_types());
            if wanted > most {
                (best, most) = (Some(form), wanted);
            }
        }
        best
    }

    /// Its media types, the one that is sent first.
    fn media_types(self) -> &'static [&'static str] {
        match self {
            Self::Csv => &["text/csv"],
            Self::Ndjson => &["application/x-ndjson", "application/ndjson", "application/jsonl"],
            Self::Arrow => &["application/vnd.apache.arrow.stream"],
        }
    }

    /// What an answer is declared to be.
    pub(crate) fn content_type(self) -> &'static str {
        match self {
            Self::Csv => "text/csv; charset=utf-8; header=present",
            Self::Ndjson => "application/x-ndjson",
            Self::Arrow => "application/vnd.apache.arrow.stream",
        }
    }
}
