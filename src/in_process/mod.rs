//! The requests of the service for a caller in the same process: the same reading, the same faults and the same numbers, without
//! HTTP. Only the form of a refusal is that of the wire, so that it has the same words.

mod operations;
mod rovers;
mod table;

pub use crate::rows::Cells;
pub use operations::{answer, operations};
pub use table::{Answered, Column, Table};

use crate::problem::{Problem, ProblemBody};

/// Why a request has no answer: the problem document of the service, as JSON.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Refused(pub String);

impl From<Problem> for Refused {
    fn from(problem: Problem) -> Self {
        Self(serde_json::to_string(&ProblemBody::from(problem)).unwrap_or_default())
    }
}
