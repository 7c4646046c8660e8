//! One operating point.

use terramechanics::{Error, Motion, OperatingPoint, Operation, Outcome, SolvedSlip, cautions};

use super::request::ForcesCase;
use crate::problem::Problem;
use crate::request::pull::SlipFrom;
use crate::warning::{Warning, of_point};

/// An operating point of a wheel that moves.
pub(crate) struct FoundForces {
    pub(crate) operation: Operation,
    pub(crate) motion: Motion,
    pub(crate) point: OperatingPoint,
    pub(crate) warnings: Vec<Warning>,
}

impl ForcesCase {
    /// The operating point, and how the wheel moves there.
    ///
    /// # Errors
    /// What the model refuses.
    pub(crate) fn point(&self) -> Result<(Motion, OperatingPoint), Error> {
        match self.slip {
            SlipFrom::Motion(motion) => self.operation.at(motion.slip).map(|point| (motion, point)),
            SlipFrom::Pull(pull) => {
                self.operation.solve_slip(pull).map(|SolvedSlip { point, .. }| (Motion::forward(point.slip), point))
            }
        }
    }
}

/// The forces at one operating point.
///
/// # Errors
/// What the model refuses.
pub(crate) fn forces(case: &ForcesCase) -> Result<FoundForces, Problem> {
    let operation = &case.operation;
    let (motion, point) = case.point().map_err(|error| Problem::refused(&error, &operation.sinkage))?;
    Ok(FoundForces::at(case, motion, point))
}

/// The same where the sinkage that carries a load is found in few steps.
pub(super) fn forces_in_few_steps(case: &ForcesCase) -> Option<FoundForces> {
    let SlipFrom::Motion(motion) = case.slip else { return None };
    let point = case.operation.at_in_few_steps(motion.slip)?;
    Some(FoundForces::at(case, motion, point))
}

impl FoundForces {
    /// A point that was found, and what is to be said of it.
    fn at(ForcesCase { operation, unused, .. }: &ForcesCase, motion: Motion, point: OperatingPoint) -> Self {
        let outcome = Outcome { standstill_normal: operation.standstill_normal(), ..Outcome::from(&point) };
        let mut warnings = of_point(cautions(operation, &outcome), &operation.system, motion);
        warnings.extend(unused.warning());
        Self { operation: *operation, motion, point, warnings }
    }
}
