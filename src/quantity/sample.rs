//! Quantities of a sample of a track.

use terramechanics::TrackRow;
use terramechanics_identification::{StrengthBound, StrengthEstimate};

use super::cell::Cell;

/// How a sample gives a quantity, and when.
#[derive(Debug, Clone, Copy)]
pub(crate) enum SampleValue {
    Number(fn(&TrackRow) -> f64),
    Word(fn(&TrackRow) -> &'static str),
    /// Only where a torque was measured.
    WithTorque(fn(&TrackRow) -> f64),
    /// Only where the load is known beside the sinkage.
    OfLoad(fn(&TrackRow) -> f64),
    /// From the running estimate of the strength, where it was asked for.
    Running(fn(&StrengthEstimate) -> f64),
}

/// How a sample gives a quantity.
#[derive(Debug, Clone, Copy)]
pub(crate) struct OfSample {
    pub(crate) value: SampleValue,
}

/// What is computed beside the forces of a sample.
#[derive(Debug, Clone, Copy, Default)]
pub(crate) struct Beside {
    /// The pull by the coupled form, from a measured torque.
    pub(crate) coupled: bool,
    /// What the load shows of the soil.
    pub(crate) under_load: bool,
    /// The running estimate of the strength.
    pub(crate) strength: bool,
}

/// A sample and what the run knows of the strength by then.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Row<'a> {
    pub(crate) row: &'a TrackRow,
    pub(crate) strength: Option<&'a StrengthEstimate>,
}

impl SampleValue {
    pub(super) fn cell(self, of: &Row<'_>) -> Cell<'static> {
        match self {
            Self::Number(value) | Self::WithTorque(value) | Self::OfLoad(value) => Cell::Number(value(of.row)),
            Self::Word(word) => Cell::Word(word(of.row)),
            Self::Running(value) => Cell::Number(of.strength.map_or(f64::NAN, value)),
        }
    }

    pub(super) fn is_there(self, beside: Beside) -> bool {
        match self {
            Self::Number(_) | Self::Word(_) => true,
            Self::WithTorque(_) => beside.coupled,
            Self::OfLoad(_) => beside.under_load,
            Self::Running(_) => beside.strength,
        }
    }
}

/// The variance of the cohesion; NaN where a bound decides it.
pub(super) fn cohesion_variance(estimate: &StrengthEstimate) -> f64 {
    if estimate.bound == Some(StrengthBound::NoCohesion) { f64::NAN } else { estimate.cohesion_variance }
}

/// The variance of tan φ; NaN where a bound decides it.
pub(super) fn tan_friction_variance(estimate: &StrengthEstimate) -> f64 {
    if estimate.bound == Some(StrengthBound::NoFriction) { f64::NAN } else { estimate.tan_friction_variance }
}

/// The covariance; NaN where a bound decides one of the two.
pub(super) fn covariance(estimate: &StrengthEstimate) -> f64 {
    if estimate.bound.is_some() { f64::NAN } else { estimate.covariance }
}
