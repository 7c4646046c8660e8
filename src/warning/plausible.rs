//! Estimates that no soil of the catalogue comes near. Mostly a unit is wrong.

use terramechanics::{PressureSinkage, SinkageExponent};
use terramechanics_identification::{Estimate, Home, Unknown};

use super::{Finding, Warning};
use crate::catalogue::{self, SoilRecord, is_of_exponent};

/// Factor beyond the catalogue's values from which on an estimate is implausible.
const FACTOR: f64 = 10.0;

/// Friction angle beyond which an estimate is implausible (rad); a factor means nothing for an angle.
const STEEPEST: f64 = std::f64::consts::FRAC_PI_3;

/// Exponents that differ by no more have moduli in units that can be compared.
const LIKE_EXPONENT: f64 = 0.3;

/// A warning for each estimate beyond what the soils of the catalogue have. Moduli are compared among soils of like `exponent`.
pub(crate) fn implausible(estimates: &[Estimate], exponent: f64) -> Vec<Warning> {
    let finding = |estimate: &Estimate| {
        let Estimate { unknown, value, .. } = *estimate;
        let beyond = |least, largest| Finding::ImplausibleEstimate {
            parameter: unknown.name(),
            value,
            least,
            largest,
            alike: is_modulus(unknown),
        };
        if unknown == Unknown::FRICTION_ANGLE {
            let least = span(unknown, exponent).map_or(0.0, |(least, _)| least);
            return match value {
                _ if value > STEEPEST => Some(beyond(None, None)),
                _ if is_surely_below(estimate, least / FACTOR) => Some(beyond(Some(least), None)),
                _ => None,
            };
        }
        let (least, largest) = span(unknown, exponent)?;
        let is_small = match unknown {
            // Next to nothing is usual, so it has to be told from nothing.
            Unknown::COHESION => is_surely_below(estimate, least / FACTOR),
            // Of either sign, it may as well be nothing.
            _ if unknown.bounds().lower < 0.0 => false,
            _ => value.abs() < least / FACTOR,
        };
        (is_small || value.abs() > FACTOR * largest).then(|| beyond(Some(least), Some(largest)))
    };
    estimates.iter().filter_map(finding).map(Warning::from).collect()
}

/// Whether an estimate is below the limit and yet surely not 0, as its interval tells.
fn is_surely_below(estimate: &Estimate, limit: f64) -> bool {
    estimate.value < limit && estimate.interval.is_some_and(|[lower, _]| lower > 0.0)
}

/// Whether it is of a pressure–sinkage law, but not of the exponent.
fn is_modulus(unknown: Unknown) -> bool {
    unknown.home() == Home::PressureSinkage && !is_of_exponent(unknown.name())
}

/// The sizes other than 0 that a parameter has among the soils of the catalogue; none of one that only some soils have.
fn span(unknown: Unknown, exponent: f64) -> Option<(f64, f64)> {
    let size = |record: &SoilRecord, name: &str| record.number(name).map(f64::abs);
    let n0 = SinkageExponent::BASE.name;
    let is_like = |record: &SoilRecord| size(record, n0).is_some_and(|n0| (n0 - exponent).abs() <= LIKE_EXPONENT);
    let sizes: Vec<f64> = match unknown.home() {
        Home::PressureSinkage if is_modulus(unknown) => {
            let law = PressureSinkage::LAWS.iter().find(|law| law.parameters.contains(unknown.parameter()))?;
            let alike = catalogue::soils().iter().filter(|record| is_like(record));
            alike.filter_map(|record| catalogue::size(record, law, unknown.parameter())).collect()
        }
        Home::Soil | Home::Shear | Home::PressureSinkage if unknown.parameter().is_required() => {
            catalogue::soils().iter().filter_map(|record| size(record, unknown.name())).collect()
        }
        _ => return None,
    };
    let sizes = || sizes.iter().copied().filter(|size| *size > 0.0);
    Some((sizes().reduce(f64::min)?, sizes().reduce(f64::max)?))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn no_soil_of_the_catalogue_is_implausible() {
        let unknowns = [
            Unknown::COHESION,
            Unknown::FRICTION_ANGLE,
            Unknown::SHEAR_MODULUS,
            Unknown::COHESIVE_MODULUS,
            Unknown::FRICTIONAL_MODULUS,
            Unknown::BASE_EXPONENT,
        ];
        for record in catalogue::soils().iter().filter(|record| record.law.as_deref() == Some("bekker")) {
            let of = |name: &str| record.values.get(name).map(|value| value.value);
            let estimates: Vec<Estimate> = unknowns
                .into_iter()
                .filter_map(|unknown| {
                    let value = of(unknown.name())?;
                    let identifiability = terramechanics_identification::Identifiability::Determined;
                    Some(Estimate { unknown, value, standard_error: None, interval: None, at_bound: None, identifiability })
                })
                .collect();
            assert_eq!(implausible(&estimates, of("n0").expect("an exponent")), [], "{}", record.id);
        }
    }
}
