//! Estimates that no soil of the catalogue comes near. Mostly a unit is wrong.

use terramechanics_identification::{Estimate, Unknown};

use super::{Finding, Warning};
use crate::catalogue::{self, SoilRecord};
use crate::request::unknowns::name_of;

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
            parameter: name_of(unknown),
            value,
            least,
            largest,
            alike: is_modulus(unknown),
        };
        if unknown == Unknown::FrictionAngle {
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
            Unknown::Cohesion => is_surely_below(estimate, least / FACTOR),
            Unknown::CohesiveModulus => false,
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

fn is_modulus(unknown: Unknown) -> bool {
    matches!(unknown, Unknown::SinkageModulus | Unknown::CohesiveModulus | Unknown::FrictionalModulus)
}

/// The sizes other than 0 that a parameter has among the soils of the catalogue.
fn span(unknown: Unknown, exponent: f64) -> Option<(f64, f64)> {
    let number = |record: &SoilRecord, name: &str| record.values.get(name).map(|value| value.value.abs());
    let is_like = |record: &SoilRecord| number(record, "n0").is_some_and(|n0| (n0 - exponent).abs() <= LIKE_EXPONENT);
    let is_bekker = |record: &SoilRecord| record.law.as_deref() == Some("bekker");
    let soils = || catalogue::soils().iter();
    let sizes: Vec<f64> = match unknown {
        Unknown::Cohesion | Unknown::FrictionAngle | Unknown::ShearModulus | Unknown::BaseExponent => {
            soils().filter_map(|record| number(record, name_of(unknown))).collect()
        }
        Unknown::CohesiveModulus | Unknown::FrictionalModulus => {
            let alike = soils().filter(|record| is_bekker(record) && is_like(record));
            alike.filter_map(|record| number(record, name_of(unknown))).collect()
        }
        // K_s is k_c/b + k_phi, of which k_phi is the greater part.
        Unknown::SinkageModulus => {
            let alike = soils().filter(|record| is_like(record));
            alike.filter_map(|record| if is_bekker(record) { number(record, "k_phi") } else { number(record, "k_s") }).collect()
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
            Unknown::Cohesion,
            Unknown::FrictionAngle,
            Unknown::ShearModulus,
            Unknown::CohesiveModulus,
            Unknown::FrictionalModulus,
            Unknown::BaseExponent,
        ];
        for record in catalogue::soils().iter().filter(|record| record.law.as_deref() == Some("bekker")) {
            let of = |name: &str| record.values.get(name).map(|value| value.value);
            let estimates: Vec<Estimate> = unknowns
                .into_iter()
                .filter_map(|unknown| {
                    let value = of(name_of(unknown))?;
                    let identifiability = terramechanics_identification::Identifiability::Determined;
                    Some(Estimate { unknown, value, standard_error: None, interval: None, at_bound: None, identifiability })
                })
                .collect();
            assert_eq!(implausible(&estimates, of("n0").expect("an exponent")), [], "{}", record.id);
        }
    }
}
