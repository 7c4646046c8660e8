//! Parameters of soil and contact from measured forces.

mod line;
mod search;

pub(crate) use line::FoundLine;
pub(crate) use search::FoundFit;

use std::time::Instant;

use super::request::IdentifyCase;
use crate::compute::Pace;
use crate::problem::Problem;

/// What measurements tell of the parameters.
pub(crate) enum FoundParameters {
    Fit(Box<FoundFit>),
    Line(Box<FoundLine>),
}

/// Share of the time for a computation that a search may take; the rest is for its report and for writing it.
const SEARCHING: f64 = 0.5;

/// The parameters, with a search that ends within its share of the time.
///
/// # Errors
/// What of the request the model or the data do not allow.
pub(crate) fn identify(case: &IdentifyCase, pace: &Pace) -> Result<FoundParameters, Problem> {
    match case {
        IdentifyCase::Fit(case) => {
            let found = search::search(case, Instant::now() + pace.time().mul_f64(SEARCHING), pace)?;
            Ok(FoundParameters::Fit(Box::new(found)))
        }
        IdentifyCase::Linear(case) => Ok(FoundParameters::Line(Box::new(line::line(case, pace)?))),
    }
}
