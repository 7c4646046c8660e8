//! When does a result leave the range in which its model was tested?

use std::fmt;

use crate::forces::Forces;
use crate::operation::{Operation, Sinkage};
use crate::slip::Slip;

/// A reason to take a result with care.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Caution {
    /// N = n0 + n1 s was fitted to driving wheels and is applied to a braking one, for which no gain of its own is given.
    SlipGainExtrapolated,
    /// The slip–sinkage relation was fitted to driving wheels and is applied to a braking one.
    SlipSinkageExtrapolated,
    /// Load and torque leave a normal stress at the peak that would have to pull.
    NegativeNormalStress {
        /// The normal stress at the peak (Pa).
        stress: f64,
    },
    /// The integrals by quadrature may be off by more than 1e-9 of the scale of the forces.
    IntegrationError {
        /// Estimate of the relative error.
        estimate: f64,
    },
}

/// Estimate of the relative integration error above which a result says so.
const LARGEST_INTEGRATION_ERROR: f64 = 1e-9;

impl Caution {
    /// The caution that an estimate of the relative integration error calls for, if it does.
    #[must_use]
    pub fn of_integration(estimate: f64) -> Option<Self> {
        (estimate > LARGEST_INTEGRATION_ERROR).then_some(Self::IntegrationError { estimate })
    }

    /// A name for programs.
    #[must_use]
    pub fn code(&self) -> &'static str {
        match self {
            Self::SlipGainExtrapolated => "slip_gain_extrapolated",
            Self::SlipSinkageExtrapolated => "slip_sinkage_extrapolated",
            Self::NegativeNormalStress { .. } => "negative_normal_stress",
            Self::IntegrationError { .. } => "integration_error",
        }
    }
}

impl fmt::Display for Caution {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::SlipGainExtrapolated => {
                write!(
                    f,
                    "the slip gain n1 of the sinkage exponent was fitted to driving wheels; at negative slip it extrapolates"
                )
            }
            Self::SlipSinkageExtrapolated => {
                write!(f, "the slip–sinkage law was fitted to driving wheels; at negative slip it extrapolates")
            }
            Self::NegativeNormalStress { stress } => write!(
                f,
                "load and torque leave a normal stress of {stress:.3e} Pa at the peak, but soil cannot pull: they do not belong \
                 together at this slip and sinkage"
            ),
            Self::IntegrationError { estimate } => {
                write!(f, "the integrals may be off by {estimate:.1e} of the scale of the forces")
            }
        }
    }
}

/// The cautions that apply to the forces of `operation` at `slip`.
pub fn cautions(operation: &Operation, slip: Slip, forces: Option<&Forces>) -> impl Iterator<Item = Caution> {
    let braking = !slip.is_driving();
    let exponent = operation.system.soil.pressure_sinkage().exponent();
    let estimate = forces.map_or(0.0, |forces| forces.integration_error);
    [
        (braking && exponent.slip_gain != 0.0 && exponent.skid_gain.is_none()).then_some(Caution::SlipGainExtrapolated),
        (braking && matches!(operation.sinkage, Sinkage::FromStatic { .. })).then_some(Caution::SlipSinkageExtrapolated),
        Caution::of_integration(estimate),
    ]
    .into_iter()
    .flatten()
}
