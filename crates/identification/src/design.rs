//! Could any data of this kind tell the unknowns apart? What the choice of the operating points leaves out.
//!
//! Some unknowns are only separated by a change of the operating point: without it, they differ in their effect on the data by
//! no more than the assumed shape of the stresses, which the model has wrong by far more. The derivatives alone do not show
//! that, since on the model's own terms they may still be independent.

use crate::observations::{Observations, Quantity};
use crate::unknown::Unknown;

/// What the operating points do not vary.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum DesignGap {
    /// All samples have one slip: how strength builds up with it cannot be seen.
    OneSlip,
    /// All samples have one load, or one sinkage where no normal force was measured.
    OneLoad,
    /// Only the normal force is fitted, to which the shear stress adds a small part.
    NormalForceOnly,
}

/// Range of slips that counts as one.
pub(crate) const SLIP_SPREAD: f64 = 0.01;

/// Standard deviation over mean of loads or sinkages that count as one: what a test bed holds a load to.
pub(crate) const LOAD_SPREAD: f64 = 0.05;

/// The gaps of a design, each with the unknowns that it leaves together.
pub(crate) fn gaps(observations: &Observations, fitted: &[Quantity], sought: &[Unknown]) -> Vec<(DesignGap, Vec<Unknown>)> {
    use Unknown as U;
    let has = |unknown: U| sought.contains(&unknown);
    let strength: Vec<U> = [U::Cohesion, U::FrictionAngle].into_iter().filter(|&unknown| has(unknown)).collect();
    let moduli: Vec<U> = [U::SinkageModulus, U::CohesiveModulus, U::FrictionalModulus].into_iter().filter(|&u| has(u)).collect();
    let mut found = Vec::new();
    if is_one_slip(observations) {
        let mut together = Vec::new();
        if has(U::ShearModulus) && !strength.is_empty() {
            together.push(U::ShearModulus);
            together.extend(&strength);
        }
        for pair in [[U::BaseExponent, U::SlipGain], [U::PeakIntercept, U::PeakSlipGain]] {
            if pair.into_iter().all(has) {
                together.extend(pair);
            }
        }
        found.push((DesignGap::OneSlip, together));
    }
    if is_one_load(observations) {
        let mut together = Vec::new();
        if strength.len() == 2 {
            together.extend(&strength);
        }
        if !moduli.is_empty() && has(U::BaseExponent) {
            together.extend(&moduli);
            together.push(U::BaseExponent);
        }
        found.push((DesignGap::OneLoad, together));
    }
    if fitted == [Quantity::Normal] {
        let mut together = strength;
        together.extend([U::ShearModulus].into_iter().filter(|&unknown| has(unknown)));
        found.push((DesignGap::NormalForceOnly, together));
    }
    found.retain(|(_, together)| !together.is_empty());
    found
}

fn is_one_slip(observations: &Observations) -> bool {
    let ratios = || observations.slip.iter().map(|slip| slip.ratio());
    ratios().fold(f64::NEG_INFINITY, f64::max) - ratios().fold(f64::INFINITY, f64::min) < SLIP_SPREAD
}

fn is_one_load(observations: &Observations) -> bool {
    let column = observations.column(Quantity::Normal).or(observations.column(Quantity::Sinkage));
    column.is_some_and(|column| {
        let count = column.values.len() as f64;
        let mean = column.values.iter().sum::<f64>() / count;
        let variance = column.values.iter().map(|value| (value - mean).powi(2)).sum::<f64>() / count;
        variance.sqrt() < LOAD_SPREAD * mean.abs()
    })
}
