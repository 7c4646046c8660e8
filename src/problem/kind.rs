//! The kinds of failures, for programs: each has an address that answers with what it means.

use axum::http::StatusCode;
use serde::Serialize;
use utoipa::ToSchema;

/// A kind of failure.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, ToSchema)]
#[schema(as = ProblemKind)]
pub(crate) struct Kind {
    /// Its name, the last part of its address.
    #[schema(example = "too-costly")]
    pub(crate) name: &'static str,
    /// HTTP status of an answer of this kind.
    #[serde(serialize_with = "as_number")]
    #[schema(value_type = u16, example = 422)]
    pub(crate) status: StatusCode,
    /// The kind in a few words.
    pub(crate) title: &'static str,
    /// What brings it about, and what to do.
    pub(crate) meaning: &'static str,
}

// The signature is that of serde.
#[expect(clippy::trivially_copy_pass_by_ref)]
fn as_number<S: serde::Serializer>(status: &StatusCode, serializer: S) -> Result<S::Ok, S::Error> {
    serializer.serialize_u16(status.as_u16())
}

/// Where the kinds are found.
const ADDRESS: &str = "/problems/";

impl Kind {
    const fn new(name: &'static str, status: StatusCode, title: &'static str, meaning: &'static str) -> Self {
        Self { name, status, title, meaning }
    }

    /// The address of this kind at the service.
    pub(crate) fn address(&self) -> String {
        format!("{ADDRESS}{}", self.name)
    }

    /// The kind of that name.
    pub(crate) fn named(name: &str) -> Option<&'static Self> {
        Self::ALL.iter().copied().find(|kind| kind.name == name)
    }

    /// Every kind.
    pub(crate) const ALL: [&'static Self; 15] = [
        &NOT_JSON,
        &BROKEN_BODY,
        &AMBIGUOUS,
        &UNREADABLE,
        &NOT_FOUND,
        &METHOD_NOT_ALLOWED,
        &SLOW_BODY,
        &TOO_LARGE,
        &MEDIA_TYPE,
        &CODING,
        &INVALID,
        &TOO_COSTLY,
        &INTERNAL,
        &BUSY,
        &LATE,
    ];
}

pub(super) static NOT_JSON: Kind = Kind::new(
    "not-json",
    StatusCode::BAD_REQUEST,
    "The body is not JSON",
    "`line` and `column` say where it stops to be JSON. NaN and Infinity are no numbers of JSON, and a name may stand once in an object.",
);

pub(super) static BROKEN_BODY: Kind = Kind::new(
    "broken-body",
    StatusCode::BAD_REQUEST,
    "The body could not be received",
    "The connection broke, the chunks were malformed, or the body is not packed as its Content-Encoding says.",
);

pub(super) static AMBIGUOUS: Kind = Kind::new(
    "ambiguous-request",
    StatusCode::BAD_REQUEST,
    "The request is not clear",
    "Its headers say in two ways where it goes or where its body ends, so that a proxy may read it otherwise than the service. The \
     connection is closed.",
);

pub(super) static UNREADABLE: Kind = Kind::new(
    "unreadable-series",
    StatusCode::BAD_REQUEST,
    "The series cannot be read",
    "The rows do not go with their heading, or are not of the form that was declared; `line` and `column` say where.",
);

pub(super) static NOT_FOUND: Kind = Kind::new(
    "not-found",
    StatusCode::NOT_FOUND,
    "There is nothing here",
    "The path is not one of the contract (/openapi.json), or the catalogue has no entry of that name.",
);

pub(super) static METHOD_NOT_ALLOWED: Kind = Kind::new(
    "method-not-allowed",
    StatusCode::METHOD_NOT_ALLOWED,
    "The method is not allowed here",
    "The header Allow has the methods of the path.",
);

pub(super) static SLOW_BODY: Kind = Kind::new(
    "slow-body",
    StatusCode::REQUEST_TIMEOUT,
    "The body did not arrive in time",
    "It came too slowly, or nothing of a stream was sent or taken for too long. /v1/limits has the times.",
);

pub(super) static TOO_LARGE: Kind = Kind::new(
    "too-large",
    StatusCode::PAYLOAD_TOO_LARGE,
    "The body is too large",
    "/v1/limits has the largest. Many rows go as a stream to /v1/batch or /v1/track, which have no such limit.",
);

pub(super) static MEDIA_TYPE: Kind = Kind::new(
    "unsupported-media-type",
    StatusCode::UNSUPPORTED_MEDIA_TYPE,
    "The body has a form that is not taken here",
    "Declare the form of the body in Content-Type; the detail names those that are taken.",
);

pub(super) static CODING: Kind = Kind::new(
    "unsupported-coding",
    StatusCode::UNSUPPORTED_MEDIA_TYPE,
    "The body has a coding that is not known",
    "Send it as it is, or packed once in a coding that the header Accept-Encoding of the answer names.",
);

pub(super) static INVALID: Kind = Kind::new(
    "invalid-input",
    StatusCode::UNPROCESSABLE_ENTITY,
    "The request cannot be computed",
    "`errors` has every fault that was found, each with a JSON pointer to the field and, where one is known, what was probably meant.",
);

pub(super) static TOO_COSTLY: Kind = Kind::new(
    "too-costly",
    StatusCode::UNPROCESSABLE_ENTITY,
    "The computation takes too long",
    "Its price in processor time, known from its input, is above the limit, or it took twice its price. Ask for fewer points; \
     /v1/limits has the limit and what a point costs.",
);

pub(super) static INTERNAL: Kind = Kind::new(
    "internal",
    StatusCode::INTERNAL_SERVER_ERROR,
    "The service failed",
    "A fault of the service. The request id in the header X-Request-Id leads to the cause in its log.",
);

pub(super) static BUSY: Kind = Kind::new(
    "busy",
    StatusCode::SERVICE_UNAVAILABLE,
    "The service is busy",
    "All places for such requests are taken, or the service is stopping. Ask again after the seconds of the header Retry-After.",
);

pub(super) static LATE: Kind = Kind::new(
    "late",
    StatusCode::SERVICE_UNAVAILABLE,
    "The answer was not ready in time",
    "The work waited or took longer than a computation may. Ask again after the seconds of the header Retry-After, or for fewer points.",
);
