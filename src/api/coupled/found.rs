//! Torque and pull from a load that is measured.

use terramechanics::{Angles, CoupledForces, Sinkage, Slip};

use super::request::CoupledCase;
use crate::problem::Problem;
use crate::request::circles::Counted;
use crate::warning::{Warning, of_point};

/// What follows from the load, and from the torque where that is measured.
pub(crate) struct FoundCoupled {
    pub(crate) slip: Slip,
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
    let CoupledCase { system, motion, sinkage, known } = case;
    let refused = |error| Problem::refused(&error, &Sinkage::Given(*sinkage));
    let (angles, forces) = known.at(system, motion.slip, *sinkage).map_err(refused)?;
    let forces = forces.heading(motion.heading);
    let circles = system.contact.circles().into();
    let warnings = of_point(forces.cautions(system, motion.slip, *sinkage), system, *motion);
    Ok(FoundCoupled { slip: motion.slip, sinkage: *sinkage, circles, angles, forces, warnings })
}
