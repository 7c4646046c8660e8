//! One operating point.

use terramechanics::{Motion, OperatingPoint, Operation, Outcome, cautions};

use super::request::ForcesCase;
use crate::problem::Problem;
use crate::warning::{Warning, of_point};

/// An operating point of a wheel that moves.
pub(crate) struct FoundForces {
    pub(crate) operation: Operation,
    pub(crate) motion: Motion,
    pub(crate) point: OperatingPoint,
    pub(crate) warnings: Vec<Warning>,
}

/// The forces at one operating point.
///
/// # Errors
/// What the model refuses.
pub(crate) fn forces(&ForcesCase { operation, motion }: &ForcesCase) -> Result<FoundForces, Problem> {
    let point = operation.at(motion.slip).map_err(|error| Problem::refused(&error, &operation.sinkage))?;
    let outcome = Outcome { standstill_normal: operation.standstill_normal(), ..Outcome::from(&point) };
    let warnings = of_point(cautions(&operation, &outcome), &operation.system, motion.heading);
    Ok(FoundForces { operation, motion, point, warnings })
}
