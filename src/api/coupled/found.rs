//! Torque and pull from a load that is measured.

use terramechanics::{Angles, Circles, CoupledForces, Heading, Sinkage, Slip};

use super::request::CoupledCase;
use crate::problem::Problem;
use crate::warning::{Warning, of_point};

/// What follows from the load, and from the torque where that is measured.
pub(crate) struct FoundCoupled {
    /// None where it was not sent.
    pub(crate) slip: Option<Slip>,
    pub(crate) sinkage: f64,
    pub(crate) circles: Circles,
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
    let CoupledCase { system, motion, sinkage, known } = case;
    let refused = |error| Problem::refused(&error, &Sinkage::Given(*sinkage));
    let (slip, heading) = (motion.map(|motion| motion.slip), motion.map_or(Heading::Forward, |motion| motion.heading));
    // Without a slip the contact is the same at any.
    let (angles, forces) = known.at(system, slip.unwrap_or(Slip::ROLLING), *sinkage).map_err(refused)?;
    // What is told of a torque against the slip is of the wheel that moves forward.
    let cautions = forces.cautions(system, slip, *sinkage);
    let forces = forces.heading(heading);
    let circles = system.contact.circles();
    let warnings = of_point(cautions, system, heading);
    Ok(FoundCoupled { slip, sinkage: *sinkage, circles, angles, forces, warnings })
}
