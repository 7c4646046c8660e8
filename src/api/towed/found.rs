//! A wheel that is towed and rolls freely.

use terramechanics::{Method, Motion, Outcome, Towed, cautions};

use super::request::TowedCase;
use crate::problem::Problem;
use crate::request::circles::Counted;
use crate::warning::{Warning, of_point};

/// How a towed wheel rolls.
pub(crate) struct FoundTowed {
    pub(crate) towed: Towed,
    /// Granular stiffness (N/m³), by the method that has one.
    pub(crate) granular_stiffness: Option<f64>,
    pub(crate) circles: Counted,
    pub(crate) warnings: Vec<Warning>,
}

/// The skid, the sinkage and the resistance of a towed wheel.
///
/// # Errors
/// What the model refuses.
pub(crate) fn towed(TowedCase { operation, load, unused }: &TowedCase) -> Result<FoundTowed, Problem> {
    let towed =
        operation.model.solve_towed(&operation.system, *load).map_err(|error| Problem::refused(&error, &operation.sinkage))?;
    let outcome = Outcome {
        slip: towed.slip,
        sinkage: towed.sinkage,
        normal: Some(towed.forces.normal),
        integration_error: towed.forces.integration_error,
        mobilised_share: None,
        standstill_normal: None,
        found_curve: None,
    };
    let mut warnings = of_point(cautions(operation, &outcome), &operation.system, Motion::forward(towed.slip));
    let in_grains = operation.model.method == Method::ResistiveForce;
    let granular_stiffness = operation.system.soil.granular_stiffness().filter(|_| in_grains);
    warnings.extend(unused.warning());
    let circles = Counted::by(&operation.model.method, operation.system.contact.circles());
    Ok(FoundTowed { towed, granular_stiffness, circles, warnings })
}
