//! What a handler takes from an HTTP request: a checked query, and the format of the answer.

use axum::body::Body;
use axum::extract::{FromRequest, FromRequestParts};
use axum::http::header::{ACCEPT, CONTENT_LENGTH, CONTENT_TYPE};
use axum::http::request::Parts;
use axum::http::{HeaderMap, Request, Uri};
use terramechanics_reading::{
    Declared, Faults, Field, FieldFault, Kind, Node, Query, Scope, Unread, Word, fault_in_words, json, shortened,
};
use utoipa::IntoParams;
use utoipa::openapi::path::{Parameter, ParameterIn};

use crate::body;
use crate::compute::Cost;
use crate::problem::Problem;
use crate::request::{self, checked};
use crate::state::Service;
use crate::words::HINTS;

/// A request body that was read and checked.
pub(crate) struct Input<R>(pub(crate) R);

impl<R: request::Request> FromRequest<Service> for Input<R> {
    type Rejection = Problem;

    async fn from_request(request: Request<Body>, service: &Service) -> Result<Self, Problem> {
        if !is_json(request.headers()) {
            return Err(Problem::NotJsonType);
        }
        let declared = request.headers().get(CONTENT_LENGTH).and_then(|length| length.to_str().ok()?.parse::<usize>().ok());
        let body = body::read(request.into_body(), declared, service).await?;
        service.pool().run(Cost::of_body(body.bytes.len()), move |_| query::<R>(&body.bytes)).await.map(Self)
    }
}

/// A request that stands in the query of a GET, read and checked, and the format asked for.
pub(crate) struct Asked<R> {
    pub(crate) query: R,
    pub(crate) format: Format,
}

impl<R: request::Request, S: Sync> FromRequestParts<S> for Asked<R> {
    type Rejection = Problem;

    async fn from_request_parts(parts: &mut Parts, _: &S) -> Result<Self, Problem> {
        let mut query = parsed(&parts.uri)?;
        let (format, mut faults) = asked_format(&mut query);
        match checked(&query.into_node()) {
            Ok(query) if faults.is_empty() => Ok(Self { query, format: format.unwrap_or_else(|| Format::of(&parts.headers)) }),
            Ok(_) => Err(Problem::Invalid(faults)),
            Err(more) => {
                faults.extend(more);
                Err(Problem::Invalid(faults))
            }
        }
    }
}

/// The same of an answer that has one format.
pub(crate) struct AskedOnly<R>(pub(crate) R);

impl<R: request::Request, S: Sync> FromRequestParts<S> for AskedOnly<R> {
    type Rejection = Problem;

    async fn from_request_parts(parts: &mut Parts, _: &S) -> Result<Self, Problem> {
        checked(&read_query(&parts.uri)?).map(Self).map_err(Problem::Invalid)
    }
}

/// Refuses every parameter that is left.
fn refuse_all(query: &Query<'_>, detail: &str) -> Result<(), Problem> {
    let faults = Faults::new(&HINTS);
    query.names().for_each(|name| Scope::root(&faults).fault_of(&shortened(name), detail));
    let faults = faults.into_list();
    if faults.is_empty() { Ok(()) } else { Err(Problem::Invalid(faults)) }
}

/// The request object that a query stands for.
///
/// # Errors
/// [`Problem::Invalid`] where it has too many parameters.
pub(crate) fn read_query(uri: &Uri) -> Result<Node<'_>, Problem> {
    parsed(uri).map(Query::into_node)
}

fn parsed(uri: &Uri) -> Result<Query<'_>, Problem> {
    Query::parse(uri.query().unwrap_or("")).map_err(|error| Problem::Invalid(vec![FieldFault::new("", error)]))
}

const FORMAT: Field<Word<Format>> = Field::new(
    "format",
    "Format of the answer; else what the header Accept prefers.",
    Word::new(&[("json", Format::Json), ("csv", Format::Csv)]),
);

/// The format that a query names, and what is wrong with it.
fn asked_format(query: &mut Query<'_>) -> (Option<Format>, Vec<FieldFault>) {
    let faults = Faults::new(&HINTS);
    let root = Scope::root(&faults);
    let (node, several) = query.take(FORMAT.name);
    if several {
        root.field(FORMAT.name).fault("is given more than once");
    }
    let format = node.and_then(|node| FORMAT.kind.read(&node, root.field(FORMAT.name)));
    (format, faults.into_list())
}

/// The parameter `format` for the contract.
pub(crate) struct FormatParameter;

impl IntoParams for FormatParameter {
    fn into_params(_: impl Fn() -> Option<ParameterIn>) -> Vec<Parameter> {
        let mut found = Vec::new();
        FORMAT.parameters("", &mut found);
        found
    }
}

/// Reads and checks a body.
fn query<R: request::Request>(body: &[u8]) -> Result<R, Problem> {
    let node = json(body).map_err(|unread| match unread {
        Unread::NotJson(error) => {
            let (line, column) = (error.line(), error.column());
            Problem::NotJson { detail: fault_in_words(body, &error), line, column }
        }
        Unread::TooMuch => Problem::Invalid(vec![FieldFault::new("", unread)]),
    })?;
    checked(&node).map_err(Problem::Invalid)
}

/// Whether the body is declared as `application/json` or another type with the suffix `+json`.
fn is_json(headers: &HeaderMap) -> bool {
    let declared = headers.get(CONTENT_TYPE).and_then(|value| value.to_str().ok()).unwrap_or("");
    let essence = declared.split(';').next().unwrap_or("").trim();
    essence.eq_ignore_ascii_case("application/json")
        || (essence.len() > 5
            && essence.is_char_boundary(essence.len() - 5)
            && essence[essence.len() - 5..].eq_ignore_ascii_case("+json"))
}

/// Whether a media type declares no charset, or one that UTF-8 covers.
fn is_utf_8(declared: &str) -> bool {
    let parameters = declared.split(';').skip(1).filter_map(|parameter| parameter.split_once('='));
    let mut charsets = parameters.filter(|(name, _)| name.trim().eq_ignore_ascii_case("charset"));
    charsets.all(|(_, charset)| {
        let charset = charset.trim().trim_matches('"');
        ["utf-8", "utf8", "us-ascii"].iter().any(|known| charset.eq_ignore_ascii_case(known))
    })
}

/// The format of an answer that has columns.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum Format {
    /// JSON, unless something else was asked for.
    Json,
    /// One header row, then one row per point.
    Csv,
}

/// Beside a body nothing stands in the query, where it would have no effect.
impl<S: Sync> FromRequestParts<S> for Format {
    type Rejection = Problem;

    async fn from_request_parts(parts: &mut Parts, _: &S) -> Result<Self, Problem> {
        refuse_all(
            &parsed(&parts.uri)?,
            "is not taken beside a body: fields stand in the body, and the header Accept chooses the format",
        )?;
        Ok(Self::of(&parts.headers))
    }
}

/// The format of an answer without parameters, and a query of nothing else.
pub(crate) struct AskedFormat(pub(crate) Format);

impl<S: Sync> FromRequestParts<S> for AskedFormat {
    type Rejection = Problem;

    async fn from_request_parts(parts: &mut Parts, _: &S) -> Result<Self, Problem> {
        let mut query = parsed(&parts.uri)?;
        let (format, faults) = asked_format(&mut query);
        if !faults.is_empty() {
            return Err(Problem::Invalid(faults));
        }
        refuse_all(&query, "unknown parameter; known are format")?;
        Ok(Self(format.unwrap_or_else(|| Format::of(&parts.headers))))
    }
}

/// A query without parameters.
pub(crate) struct NoQuery;

impl<S: Sync> FromRequestParts<S> for NoQuery {
    type Rejection = Problem;

    async fn from_request_parts(parts: &mut Parts, _: &S) -> Result<Self, Problem> {
        refuse_all(&parsed(&parts.uri)?, "unknown parameter; there are none here").map(|()| Self)
    }
}

impl Format {
    /// What the headers of a request ask for.
    fn of(headers: &HeaderMap) -> Self {
        let accept = headers.get(ACCEPT).and_then(|value| value.to_str().ok());
        accept.map_or(Self::Json, Self::preferred)
    }

    /// The format that an Accept header prefers (RFC 9110, section 12.5.1); JSON where it accepts neither or both alike.
    fn preferred(accept: &str) -> Self {
        if quality(accept, "text", "csv") > quality(accept, "application", "json") { Self::Csv } else { Self::Json }
    }
}

/// How much an Accept header wants a media type, from 0 to 1.
fn quality(accept: &str, kind: &str, subtype: &str) -> f64 {
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
        let essence = declared.split(';').next().unwrap_or("").trim();
        let is = |form: &Self| form.media_types().iter().any(|known| essence.eq_ignore_ascii_case(known));
        if !is_utf_8(declared) {
            return Err(Problem::NotSeriesType);
        }
        match Self::ALL.into_iter().find(is) {
            Some(form) => Ok(form),
            None if is_json(headers) => Ok(Self::Json),
            None => Err(Problem::NotSeriesType),
        }
    }

    /// The form that an answer to a body of this form is wanted in: the same unless another is preferred.
    pub(crate) fn of_answer(self, headers: &HeaderMap) -> Self {
        let Some(accept) = headers.get(ACCEPT).and_then(|value| value.to_str().ok()) else { return self };
        let wanted = |form: Self| {
            let of = |known: &&str| known.split_once('/').map_or(0.0, |(kind, subtype)| quality(accept, kind, subtype));
            form.media_types().iter().map(of).fold(0.0, f64::max)
        };
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
