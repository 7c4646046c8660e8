//! What can be measured of a wheel.

use std::fmt;

use crate::setup::Prediction;

/// A quantity that can be measured.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub enum Quantity {
    /// Sinkage z (m).
    Sinkage,
    /// Longitudinal force F_x (N).
    Longitudinal,
    /// Normal force F_z (N).
    Normal,
    /// Torque T (N·m).
    Torque,
}

impl Quantity {
    /// All of them.
    pub const ALL: [Self; 4] = [Self::Sinkage, Self::Longitudinal, Self::Normal, Self::Torque];

    pub(crate) fn of(self, prediction: &Prediction) -> f64 {
        match self {
            Self::Sinkage => prediction.sinkage,
            Self::Longitudinal => prediction.longitudinal,
            Self::Normal => prediction.normal,
            Self::Torque => prediction.torque,
        }
    }
}

impl fmt::Display for Quantity {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(match self {
            Self::Sinkage => "sinkage",
            Self::Longitudinal => "longitudinal force",
            Self::Normal => "normal force",
            Self::Torque => "torque",
        })
    }
}
