//! The failures that operations share, for the contract.

use std::collections::BTreeMap;
use std::time::Duration;

use terramechanics_reading::{FieldFault, Figures};
use utoipa::openapi::response::{Response, ResponseBuilder};
use utoipa::openapi::{ContentBuilder, Ref, RefOr};
use utoipa::{IntoResponses, ToSchema};

use crate::problem::{Problem, ProblemBody};
use crate::series::SeriesFault;

/// Each problem with what brings it about, as it is documented under its status.
fn problems(list: Vec<(Problem, &str)>) -> BTreeMap<String, RefOr<Response>> {
    list.into_iter()
        .map(|(problem, description)| {
            let status = problem.status().as_str().to_owned();
            let content = ContentBuilder::new()
                .schema(Some(Ref::from_schema_name(ProblemBody::name())))
                .example(serde_json::to_value(ProblemBody::from(problem)).ok())
                .build();
            let response = ResponseBuilder::new().description(description).content("application/problem+json", content).build();
            (status, RefOr::T(response))
        })
        .collect()
}

/// A refusal, for example.
fn refused() -> Problem {
    let fault = FieldFault::new("/soil/cohesion_pa", "must be from 0 to 1e8, not -5");
    let figures = Figures { unit: Some("Pa".into()), minimum: Some(0.0), maximum: Some(1e8), ..Figures::default() };
    Problem::Invalid(vec![fault.with(Figures { value: Some(-5.0), ..figures })])
}

/// What can be wrong with a body.
pub(crate) struct InvalidBody;

impl IntoResponses for InvalidBody {
    fn responses() -> BTreeMap<String, RefOr<Response>> {
        let not_json = Problem::NotJson { detail: "expected `,` or `}` at line 1 column 24".into(), line: 1, column: 24 };
        problems(vec![
            (not_json, "The body is not JSON; line and column of the fault"),
            (Problem::SlowBody(Duration::from_secs(10)), "The body did not arrive in time"),
            (Problem::TooLarge { limit: 1 << 20 }, "The body is too large"),
            (
                Problem::NotJsonType,
                "The body is not declared as JSON, or has a coding that is not unpacked; the header Accept-Encoding names those that are",
            ),
            (refused(), "The request cannot be computed; every fault with a JSON pointer"),
        ])
    }
}

/// What can be wrong with a body that is a series.
pub(crate) struct InvalidSeries;

impl IntoResponses for InvalidSeries {
    fn responses() -> BTreeMap<String, RefOr<Response>> {
        let unreadable = SeriesFault { line: 2, column: 2, detail: "`abc` is not a number (column `slip`)".into() };
        problems(vec![
            (Problem::Unreadable(unreadable), "The body cannot be read; line and column of the fault"),
            (Problem::Idle(Duration::from_secs(30)), "The body did not arrive in time"),
            (Problem::TooLarge { limit: 1 << 20 }, "The JSON body is too large; the other forms have no limit"),
            (
                Problem::NotSeriesType,
                "The body is not declared as JSON, CSV or NDJSON, or has a coding that is not unpacked; the header Accept-Encoding names those that are",
            ),
            (refused(), "The request cannot be computed; every fault with a JSON pointer"),
        ])
    }
}

/// What can be wrong with a body that is the rows of a batch.
pub(crate) struct InvalidRows;

impl IntoResponses for InvalidRows {
    fn responses() -> BTreeMap<String, RefOr<Response>> {
        let unreadable = SeriesFault { line: 2, column: 3, detail: "the number of cells is 2, the header has 3".into() };
        problems(vec![
            (Problem::Unreadable(unreadable), "The body cannot be read; line and column of the fault"),
            (Problem::Idle(Duration::from_secs(30)), "The body did not arrive in time"),
            (
                Problem::NotRowsType,
                "The body is declared as none of the forms that are taken, or has a coding that is not unpacked; the header Accept-Encoding names those that are",
            ),
            (refused(), "No row can be computed; every fault with a JSON pointer"),
        ])
    }
}

/// What can be wrong with a query.
pub(crate) struct InvalidQuery;

impl IntoResponses for InvalidQuery {
    fn responses() -> BTreeMap<String, RefOr<Response>> {
        problems(vec![(refused(), "The request cannot be computed; every fault with a JSON pointer")])
    }
}

/// What the service's limits can bring about.
pub(crate) struct Limits;

impl IntoResponses for Limits {
    fn responses() -> BTreeMap<String, RefOr<Response>> {
        problems(vec![
            (Problem::MethodNotAllowed(Some("POST".into())), "The method is not allowed; the header Allow lists those that are"),
            (Problem::Internal, "The service failed; the request id leads to the cause in the log"),
            (
                Problem::Busy(Duration::ZERO),
                "The service is busy or the answer took too long; the header Retry-After says when to try again",
            ),
        ])
    }
}

/// What can be wrong with a name in a path.
pub(crate) struct UnknownName;

impl IntoResponses for UnknownName {
    fn responses() -> BTreeMap<String, RefOr<Response>> {
        let unknown = Problem::NotFound("unknown name `leter`; did you mean `letter`?".into());
        problems(vec![(unknown, "The catalogue has no such entry; the nearest known name")])
    }
}
