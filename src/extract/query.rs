//! What stands behind the `?`: a request, the format of the answer, or nothing.

use axum::extract::FromRequestParts;
use axum::http::Uri;
use axum::http::request::Parts;
use terramechanics_reading::{Declared, Faults, Field, FieldFault, Kind, Node, Query, Scope, Word, shortened};
use utoipa::IntoParams;
use utoipa::openapi::path::{Parameter, ParameterIn};

use super::Format;
use crate::problem::Problem;
use crate::request::{self, Accepted, accepted, checked};
use crate::words::HINTS;

/// A request that stands in the query of a GET, read and checked, and the format asked for.
pub(crate) struct Asked<R> {
    pub(crate) case: Accepted<R>,
    pub(crate) format: Format,
}

impl<R: request::Request, S: Sync> FromRequestParts<S> for Asked<R> {
    type Rejection = Problem;

    async fn from_request_parts(parts: &mut Parts, _: &S) -> Result<Self, Problem> {
        let mut query = parsed(&parts.uri)?;
        let (format, mut faults) = asked_format(&mut query);
        match accepted(&query.into_node()) {
            Ok(case) if faults.is_empty() => Ok(Self { case, format: format.unwrap_or_else(|| Format::of(&parts.headers)) }),
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

/// The parameters of a query.
///
/// # Errors
/// [`Problem::Invalid`] where there are too many.
pub(crate) fn parsed(uri: &Uri) -> Result<Query<'_>, Problem> {
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
    let format = taken(query, FORMAT.name, &root).and_then(|node| FORMAT.kind.read(&node, root.field(FORMAT.name)));
    (format, faults.into_list())
}

/// A parameter that belongs to no request, taken out; that there are several is reported.
pub(crate) fn taken<'a>(query: &mut Query<'a>, name: &'static str, root: &Scope<'_>) -> Option<Node<'a>> {
    let (node, several) = query.take(name);
    if several {
        root.field(name).fault("is given more than once");
    }
    node
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
