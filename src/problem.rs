//! Failures as clients see them: RFC 9457 problem documents. The only place that knows HTTP statuses of failures.

mod kind;

use std::time::Duration;

use axum::http::header::{ACCEPT_ENCODING, CONNECTION, CONTENT_TYPE, RETRY_AFTER};
use axum::http::{HeaderValue, StatusCode};
use axum::response::{IntoResponse, Response};
use serde::Serialize;
use utoipa::ToSchema;

pub(crate) use self::kind::Kind;
use crate::coding::{self, UnknownCoding};
use crate::compute::Stop;
use crate::legible::legible;
use crate::request::error_fault;
use crate::series::SeriesFault;
use crate::server::Slowest;
use crate::warning::Warning;
use terramechanics_reading::FieldFault;

/// Why a request has no answer.
#[derive(Debug, Clone, PartialEq)]
pub(crate) enum Problem {
    /// The body is not JSON.
    NotJson {
        /// What the parser says.
        detail: String,
        /// Line of the fault, from 1.
        line: usize,
        /// Column of the fault, from 0 at the line's start.
        column: usize,
    },
    /// The body could not be received.
    BrokenBody,
    /// The head of the request can be read in several ways.
    Ambiguous(&'static str),
    /// The body has a coding that is not unpacked.
    UnknownCoding,
    /// There is nothing at the path.
    NotFound(String),
    /// The path has no such method; those that it has, where the contract has the path.
    MethodNotAllowed(Option<String>),
    /// The body did not arrive in time.
    SlowBody(Duration),
    /// The body is too large.
    TooLarge {
        /// Largest body taken (bytes).
        limit: usize,
    },
    /// The body is not declared to be JSON.
    NotJsonType,
    /// The body is not declared to be a series in a form that is known.
    NotSeriesType,
    /// The body is not declared to be rows in a form that is known.
    NotRowsType,
    /// The series in the body cannot be read.
    Unreadable(SeriesFault),
    /// Nothing of the body arrived, or nothing of the answer was taken, for too long.
    Idle(Duration),
    /// The body came slower than this.
    Crawling(Slowest),
    /// The request cannot be computed.
    Invalid(Vec<FieldFault>),
    /// The request cannot be computed although its fields are each right: why, and what of it may be meant otherwise.
    Refused(Vec<FieldFault>, Vec<Warning>),
    /// All places for long computations are taken, by work that usually takes so long.
    Busy(Duration),
    /// All places for connections are taken, or the memory for large bodies or answers.
    Crowded,
    /// The answer was not ready in time.
    Late(Duration),
    /// The computation is priced above the limit, or took twice its price.
    TooCostly {
        /// Its price (processor time).
        price: Duration,
        /// Highest price taken.
        limit: Duration,
        /// Whether it was accepted, and ended when it had taken twice its price.
        spent: bool,
    },
    /// A fault of the service.
    Internal,
}

/// A failure: an RFC 9457 problem document.
#[derive(Debug, Serialize, ToSchema)]
#[schema(as = Problem)]
pub(crate) struct ProblemBody {
    /// Kind of the problem, for programs: an address at this service, which answers with what the kind means.
    #[serde(rename = "type")]
    #[schema(format = "uri-reference", example = "/problems/invalid-input")]
    kind: String,
    /// The kind in words.
    #[schema(example = "The request cannot be computed")]
    title: &'static str,
    /// HTTP status.
    #[schema(example = 422)]
    status: u16,
    /// What happened this time.
    detail: String,
    /// For bad input: every fault found.
    #[serde(skip_serializing_if = "Vec::is_empty")]
    errors: Vec<FieldFault>,
    /// For a computation that failed: values that may be in another unit.
    #[serde(skip_serializing_if = "Vec::is_empty")]
    #[schema(required = false)]
    warnings: Vec<Warning>,
    /// For a body that cannot be read: line of the fault, from 1.
    #[serde(skip_serializing_if = "Option::is_none")]
    #[schema(nullable = false)]
    line: Option<usize>,
    /// For a body that cannot be read: column of the fault; of a table, the cell.
    #[serde(skip_serializing_if = "Option::is_none")]
    #[schema(nullable = false)]
    column: Option<usize>,
}

/// Shortest time after which a busy service is asked again.
const SOONEST: Duration = Duration::from_secs(1);

impl Problem {
    /// What the model refuses of a request whose fields are each right.
    pub(crate) fn refused(error: &terramechanics::Error, sinkage: &terramechanics::Sinkage) -> Self {
        Self::Invalid(vec![error_fault(error, sinkage)])
    }

    /// The same with what of the request may be meant otherwise, where it is the request that has no answer.
    pub(crate) fn hinting(self, hints: impl FnOnce() -> Vec<Warning>) -> Self {
        match self {
            Self::Invalid(errors) => Self::Refused(errors, hints()),
            other => other,
        }
    }

    pub(crate) fn status(&self) -> StatusCode {
        self.kind().status
    }

    fn kind(&self) -> &'static Kind {
        match self {
            Self::NotJson { .. } => &kind::NOT_JSON,
            Self::BrokenBody => &kind::BROKEN_BODY,
            Self::Ambiguous(_) => &kind::AMBIGUOUS,
            Self::UnknownCoding => &kind::CODING,
            Self::NotFound(_) => &kind::NOT_FOUND,
            Self::MethodNotAllowed(_) => &kind::METHOD_NOT_ALLOWED,
            Self::Unreadable(_) => &kind::UNREADABLE,
            Self::SlowBody(_) | Self::Idle(_) | Self::Crawling(_) => &kind::SLOW_BODY,
            Self::TooLarge { .. } => &kind::TOO_LARGE,
            Self::NotJsonType | Self::NotSeriesType | Self::NotRowsType => &kind::MEDIA_TYPE,
            Self::Invalid(_) | Self::Refused(..) => &kind::INVALID,
            Self::Busy(_) | Self::Crowded => &kind::BUSY,
            Self::Late(_) => &kind::LATE,
            Self::TooCostly { .. } => &kind::TOO_COSTLY,
            Self::Internal => &kind::INTERNAL,
        }
    }

    /// What happened, in words of one line.
    pub(crate) fn detail(&self) -> String {
        legible(&self.words())
    }

    fn words(&self) -> String {
        match self {
            Self::NotJson { detail, .. } => detail.clone(),
            Self::BrokenBody => "the connection broke, or the body was malformed or could not be unpacked".into(),
            Self::Ambiguous(fault) => (*fault).into(),
            Self::UnknownCoding => format!("send the body as it is, or with one Content-Encoding of {}", coding::TAKEN),
            Self::NotFound(path) => path.clone(),
            Self::MethodNotAllowed(Some(methods)) => format!("use {methods}; the header Allow lists the methods of this path"),
            Self::MethodNotAllowed(None) => "the header Allow lists the methods of this path".into(),
            Self::SlowBody(limit) => format!("the body has to arrive within {} s", limit.as_secs_f64()),
            Self::TooLarge { limit } => format!("the body may have at most {limit} bytes"),
            Self::NotJsonType => "send the body with Content-Type: application/json".into(),
            Self::NotSeriesType => {
                "send the body in UTF-8, with Content-Type: application/json, text/csv or application/x-ndjson".into()
            }
            Self::NotRowsType => {
                "send the body in UTF-8 with Content-Type: text/csv or application/x-ndjson, or as application/vnd.apache.arrow.stream".into()
            },
            Self::Unreadable(fault) => fault.to_string(),
            Self::Idle(limit) => format!("nothing was sent or taken for {} s", limit.as_secs_f64()),
            Self::Crawling(slowest) => {
                format!("the body came at less than {} bytes a second over {} s", slowest.rate, slowest.window.as_secs_f64())
            }
            Self::Invalid(errors) | Self::Refused(errors, _) => match errors.as_slice() {
                [one] if one.pointer.is_empty() => one.detail.clone(),
                [one] => format!("{}: {}", one.pointer, one.detail),
                many => format!("{} faults, see errors", many.len()),
            },
            Self::Busy(_) => "all places for long computations are taken, try again soon".into(),
            Self::Crowded => "too many others are connected, send or read, try again soon".into(),
            Self::Late(limit) => format!("no answer within {} s, try again or ask for fewer points", limit.as_secs_f64()),
            Self::TooCostly { price, limit, spent: false } => format!(
                "the request is priced at {} s of processor time, and {} s is the most that is taken; ask for fewer points",
                price.as_secs_f64(),
                limit.as_secs_f64()
            ),
            Self::TooCostly { price, spent: true, .. } => format!(
                "the computation was ended after twice its price of {} s of processor time: the contact is too stiff for so many \
                 points, ask for fewer",
                price.as_secs_f64()
            ),
            Self::Internal => "the request id in the header X-Request-Id leads to the cause in the log".into(),
        }
    }
}

/// Work that was told to stop; the pool knows why and answers accordingly.
impl From<UnknownCoding> for Problem {
    fn from(UnknownCoding: UnknownCoding) -> Self {
        Self::UnknownCoding
    }
}

impl From<Stop> for Problem {
    fn from(_: Stop) -> Self {
        Self::Busy(Duration::ZERO)
    }
}

impl From<Problem> for ProblemBody {
    fn from(problem: Problem) -> Self {
        let Kind { status, title, .. } = *problem.kind();
        let (status, kind) = (status.as_u16(), problem.kind().address());
        let (line, column) = match problem {
            Problem::NotJson { line, column, .. } => (Some(line), Some(column)),
            Problem::Unreadable(SeriesFault { line, column, .. }) => {
                (usize::try_from(line).ok().filter(|line| *line > 0), (column > 0).then_some(column))
            }
            _ => (None, None),
        };
        let detail = problem.detail();
        let (errors, warnings) = match problem {
            Problem::Invalid(errors) => (errors, Vec::new()),
            Problem::Refused(errors, warnings) => (errors, warnings),
            _ => (Vec::new(), Vec::new()),
        };
        let errors = errors.into_iter().map(|fault| FieldFault { detail: legible(&fault.detail), ..fault }).collect();
        Self { kind, title, status, detail, errors, warnings, line, column }
    }
}

impl IntoResponse for Problem {
    fn into_response(self) -> Response {
        let status = self.status();
        let again = if let Self::Busy(ahead) = self { ahead.max(SOONEST) } else { SOONEST };
        let is_of_coding = self == Self::UnknownCoding;
        let is_ambiguous = matches!(self, Self::Ambiguous(_));
        let text = serde_json::to_vec(&ProblemBody::from(self)).unwrap_or_default();
        let mut response = (status, [(CONTENT_TYPE, HeaderValue::from_static("application/problem+json"))], text).into_response();
        if status == StatusCode::SERVICE_UNAVAILABLE {
            response.headers_mut().insert(RETRY_AFTER, (again.as_secs_f64().ceil() as u64).into());
        }
        if is_ambiguous {
            // What follows on the connection may be the rest of this request or the next one.
            response.headers_mut().insert(CONNECTION, HeaderValue::from_static("close"));
        }
        if is_of_coding {
            response.headers_mut().insert(ACCEPT_ENCODING, HeaderValue::from_static(coding::TAKEN));
        }
        response
    }
}
