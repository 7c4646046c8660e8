//! A wheel that is towed and rolls freely.

use terramechanics::{Circles, Heading, Outcome, Towed, cautions};

use super::request::TowedCase;
use crate::problem::Problem;
use crate::warning::{Warning, of_point};

/// How a towed wheel rolls.
pub(crate) struct FoundTowed {
    pub(crate) towed: Towed,
    pub(crate) circles: Circles,
    pub(crate) warnings: Vec<Warning>,
}

/// The skid, the sinkage and the resistance of a towed wheel.
///
/// # Errors
/// What the model refuses.
pub(crate) fn towed(TowedCase { operation, load }: &TowedCase) -> Result<FoundTowed, Problem> {
    let towed = operation.system.solve_towed(*load).map_err(|error| Problem::refused(&error, &operation.sinkage))?;
    let outcome = Outcome {
        slip: towed.slip,
        sinkage: towed.sinkage,
        normal: Some(towed.forces.normal),
        integration_error: towed.forces.integration_error,
        mobilised_share: None,
        standstill_normal: None,
    };
    let warnings = of_point(cautions(operation, &outcome), &operation.system, Heading::Forward);
    Ok(FoundTowed { towed, circles: operation.system.contact.circles(), warnings })
}
