//! Can data of this kind tell the unknowns apart at all? A check of the operating points, before any measured value counts.
//!
//! Some unknowns can only be told apart when the operating point changes. Without that, their effects on the data differ only
//! through the assumed shape of the stresses, and the error of that shape is far larger than the difference. The derivatives do
//! not show this: within the model they may still be independent.

use terramechanics::{Parametrised, SinkageExponent};

use crate::observations::Observations;
use crate::quantity::Quantity;
use crate::setup::Prediction;
use crate::unknown::{Home, Unknown};

/// What the operating points do not vary.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum DesignGap {
    /// All samples have one slip, so they do not show how the strength builds up with slip.
    OneSlip,
    /// All samples have one load, measured or, where no normal force was measured, predicted by the model.
    OneLoad,
    /// The samples repeat too few operating points to determine that many unknowns.
    FewPoints,
    /// Only the normal force is fitted, to which the shear stress adds a small part.
    NormalForceOnly,
}

/// Range of slips that counts as one.
pub(crate) const SLIP_SPREAD: f64 = 0.01;

/// Standard deviation over mean of loads that count as one: a test bed holds a load about as well.
pub(crate) const LOAD_SPREAD: f64 = 0.05;

/// The same for loads that the model predicts, which noise in the data scatters more widely.
const PREDICTED_LOAD_SPREAD: f64 = 0.2;

/// Relative difference below which sinkages, or loads, count as one operating point.
const SAME_POINT: f64 = 0.05;

/// The gaps of a design, each with the unknowns that it cannot tell apart.
pub(crate) fn gaps(
    observations: &Observations,
    fitted: &[Quantity],
    sought: &[Unknown],
    predictions: &[Prediction],
) -> Vec<(DesignGap, Vec<Unknown>)> {
    use Unknown as U;
    let has = |unknown: U| sought.contains(&unknown);
    let strength: Vec<U> = [U::COHESION, U::FRICTION_ANGLE].into_iter().filter(|&unknown| has(unknown)).collect();
    // What a pressure–sinkage law has besides its exponent.
    let is_of_exponent = |unknown: U| SinkageExponent::PARAMETERS.contains(unknown.parameter());
    let moduli = U::ALL.into_iter().filter(|&unknown| unknown.home() == Home::PressureSinkage && !is_of_exponent(unknown));
    let moduli: Vec<U> = moduli.filter(|&unknown| has(unknown)).collect();
    let mut found = Vec::new();
    if is_one_slip(observations) {
        let mut together = Vec::new();
        if has(U::SHEAR_MODULUS) && !strength.is_empty() {
            together.push(U::SHEAR_MODULUS);
            together.extend(&strength);
        }
        for pair in [[U::BASE_EXPONENT, U::SLIP_GAIN], [U::PEAK_INTERCEPT, U::PEAK_SLIP_GAIN]] {
            if pair.into_iter().all(has) {
                together.extend(pair);
            }
        }
        found.push((DesignGap::OneSlip, together));
    }
    if is_one_load(observations, predictions) {
        let mut together = Vec::new();
        if strength.len() == 2 {
            together.extend(&strength);
        }
        if !moduli.is_empty() && has(U::BASE_EXPONENT) {
            together.extend(&moduli);
            together.push(U::BASE_EXPONENT);
        }
        found.push((DesignGap::OneLoad, together));
    }
    if fitted == [Quantity::Normal] {
        let mut together = strength;
        together.extend([U::SHEAR_MODULUS].into_iter().filter(|&unknown| has(unknown)));
        found.push((DesignGap::NormalForceOnly, together));
    }
    let points = distinct_points(observations, predictions, sought.len());
    if sought.len() > 1 && (points == 1 || points * fitted.len() <= sought.len()) {
        found.push((DesignGap::FewPoints, sought.to_vec()));
    }
    found.retain(|(_, together)| !together.is_empty());
    found
}

fn is_one_slip(observations: &Observations) -> bool {
    let ratios = || observations.slip.iter().map(|slip| slip.ratio());
    ratios().fold(f64::NEG_INFINITY, f64::max) - ratios().fold(f64::INFINITY, f64::min) < SLIP_SPREAD
}

/// Uses the measured normal force; where there is none, the one that the model predicts at the solution.
fn is_one_load(observations: &Observations, predictions: &[Prediction]) -> bool {
    let is_one = |loads: &mut dyn Iterator<Item = f64>, spread: f64| {
        let loads: Vec<f64> = loads.collect();
        let count = loads.len() as f64;
        let mean = loads.iter().sum::<f64>() / count;
        let variance = loads.iter().map(|load| (load - mean).powi(2)).sum::<f64>() / count;
        variance.sqrt() < spread * mean.abs()
    };
    match observations.column(Quantity::Normal) {
        Some(column) => is_one(&mut column.values.iter().copied(), LOAD_SPREAD),
        None => is_one(&mut predictions.iter().map(|prediction| prediction.normal), PREDICTED_LOAD_SPREAD),
    }
}

/// Number of operating points that differ in slip or in sinkage by more than repetitions do. Counting stops past `most`.
fn distinct_points(observations: &Observations, predictions: &[Prediction], most: usize) -> usize {
    let mut known: Vec<(f64, f64)> = Vec::new();
    for (slip, prediction) in observations.slip.iter().zip(predictions) {
        let (ratio, sinkage) = (slip.ratio(), prediction.sinkage);
        let is_same = |&(slip, depth): &(f64, f64)| {
            (slip - ratio).abs() < SLIP_SPREAD && (depth - sinkage).abs() < SAME_POINT * depth.max(sinkage)
        };
        if !known.iter().any(is_same) {
            known.push((ratio, sinkage));
        }
        if known.len() > most {
            break;
        }
    }
    known.len()
}
