//! The failures that operations share, for the contract.

use std::collections::BTreeMap;

use utoipa::openapi::response::{Response, ResponseBuilder};
use utoipa::openapi::{ContentBuilder, Ref, RefOr};
use utoipa::{IntoResponses, ToSchema};

use crate::problem::ProblemBody;

fn problems(list: &[(&str, &str)]) -> BTreeMap<String, RefOr<Response>> {
    list.iter()
        .map(|(status, description)| {
            let content = ContentBuilder::new().schema(Some(Ref::from_schema_name(ProblemBody::name()))).build();
            let response = ResponseBuilder::new().description(*description).content("application/problem+json", content).build();
            ((*status).to_owned(), RefOr::T(response))
        })
        .collect()
}

/// What can be wrong with a body.
pub(super) struct InvalidBody;

impl IntoResponses for InvalidBody {
    fn responses() -> BTreeMap<String, RefOr<Response>> {
        problems(&[
            ("400", "The body is not JSON; line and column of the fault"),
            ("408", "The body did not arrive in time"),
            ("413", "The body is too large"),
            ("415", "The body is not declared as JSON"),
            ("422", "The request cannot be computed; every fault with a JSON pointer"),
        ])
    }
}

/// What can be wrong with a body that is a series.
pub(super) struct InvalidSeries;

impl IntoResponses for InvalidSeries {
    fn responses() -> BTreeMap<String, RefOr<Response>> {
        problems(&[
            ("400", "The body cannot be read; line and column of the fault"),
            ("408", "The body did not arrive in time"),
            ("413", "The JSON body is too large; the other forms have no limit"),
            ("415", "The body is not declared as JSON, CSV or NDJSON"),
            ("422", "The request cannot be computed; every fault with a JSON pointer"),
        ])
    }
}

/// What can be wrong with a query.
pub(super) struct InvalidQuery;

impl IntoResponses for InvalidQuery {
    fn responses() -> BTreeMap<String, RefOr<Response>> {
        problems(&[("422", "The request cannot be computed; every fault with a JSON pointer")])
    }
}

/// What the service's limits can bring about.
pub(super) struct Limits;

impl IntoResponses for Limits {
    fn responses() -> BTreeMap<String, RefOr<Response>> {
        problems(&[
            ("405", "The method is not allowed; the header Allow lists those that are"),
            ("500", "The service failed; the request id leads to the cause in the log"),
            ("503", "The service is busy or the answer took too long; the header Retry-After says when to try again"),
        ])
    }
}

/// What can be wrong with a name in a path.
pub(super) struct UnknownName;

impl IntoResponses for UnknownName {
    fn responses() -> BTreeMap<String, RefOr<Response>> {
        problems(&[("404", "The catalogue has no such entry; the nearest known name")])
    }
}
