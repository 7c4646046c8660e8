//! Torque and pull from a load that is measured.

use terramechanics::{Angles, CoupledForces, Motion, Sinkage, Slip};

use super::request::CoupledCase;
use crate::problem::Problem;
use crate::request::circles::Counted;
use crate::warning::{Warning, of_point};

/// What follows from the load, and from the torque where that is measured.
pub(crate) struct FoundCoupled {
    /// None where it was not sent.
    pub(crate) slip: Option<Slip>,
    pub(crate) sinkage: f64,
    pub(crate) circles: Counted,
    pub(crate) angles: Angles,
    /// In the heading of the wheel.
    pub(crate) forces: CoupledForces,
    pub(crate) warnings: Vec<Warning>,
}

/// Torque and pull from what was measured.
///
/// # Errors
/// What the model refuses.
pub(crate) fn coupled(case: &CoupledCase) -> Result<FoundCoupled, Problem> {
    let CoupledCase { system, motion, sinkage, known, unused } = case;
    let refused = |error| Problem::refused(&error, &Sinkage::Given(*sinkage));
    // Without a slip the contact is the same at any, and the wheel moves forward.
    let (slip, moving) = (motion.map(|motion| motion.slip), motion.unwrap_or(Motion::forward(Slip::ROLLING)));
    let (angles, forces) = known.at(system, moving.slip, *sinkage).map_err(refused)?;
    // What is told of a torque against the slip is of the wheel that moves forward.
    let cautions = forces.cautions(system, slip, *sinkage);
    let forces = forces.heading(moving.heading);
    let circles = system.contact.circles().into();
    let mut warnings = of_point(cautions, system, moving);
    warnings.extend(unused.warning());
    Ok(FoundCoupled { slip, sinkage: *sinkage, circles, angles, forces, warnings })
}
