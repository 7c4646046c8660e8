//! When does a result leave the range in which its model was tested?

use std::fmt;

use crate::forces::{Forces, Method};
use crate::lateral::Bulldozing;
use crate::operation::{Operation, Sinkage};
use crate::slip::Slip;

/// A reason to take a result with care.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Caution {
    /// N = n0 + n1 s was fitted to driving wheels and is applied to a braking one, for which no gain of its own is given.
    SlipGainExtrapolated,
    /// The slip–sinkage relation was fitted to driving wheels and is applied to a braking one.
    SlipSinkageExtrapolated,
    /// The integrals by quadrature may be off by more than 1e-9 of the scale of the forces.
    IntegrationError {
        /// Estimate of the relative error.
        estimate: f64,
    },
    /// The soil's unit weight is not known, so the lateral force lacks the pressure on the side wall.
    BulldozingLeftOut,
    /// All of the pressure on the side wall is counted, though the wheel moves too little sideways to mobilise it.
    BulldozingNotMobilised {
        /// Share of the pressure that is mobilised (–).
        share: f64,
    },
}

/// Share of the pressure on the side wall below which a result says so.
const LEAST_MOBILISED_SHARE: f64 = 0.5;

/// Estimate of the relative integration error above which a result says so.
const LARGEST_INTEGRATION_ERROR: f64 = 1e-9;

impl Caution {
    /// The caution that an estimate of the relative integration error calls for, if it does.
    #[must_use]
    pub fn of_integration(estimate: f64) -> Option<Self> {
        (estimate > LARGEST_INTEGRATION_ERROR).then_some(Self::IntegrationError { estimate })
    }

    /// The caution that a mobilised share of the pressure on the side wall calls for, if `operation` counts all of it.
    #[must_use]
    pub fn of_bulldozing(operation: &Operation, share: f64) -> Option<Self> {
        let Method::SideSlipping(side) = operation.model.method else { return None };
        (side.bulldozing == Bulldozing::Full && share < LEAST_MOBILISED_SHARE).then_some(Self::BulldozingNotMobilised { share })
    }

    /// A name for programs.
    #[must_use]
    pub fn code(&self) -> &'static str {
        match self {
            Self::SlipGainExtrapolated => "slip_gain_extrapolated",
            Self::SlipSinkageExtrapolated => "slip_sinkage_extrapolated",
            Self::IntegrationError { .. } => "integration_error",
            Self::BulldozingLeftOut => "bulldozing_left_out",
            Self::BulldozingNotMobilised { .. } => "bulldozing_not_mobilised",
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
            Self::IntegrationError { estimate } => {
                write!(f, "the integrals may be off by {estimate:.1e} of the scale of the forces")
            }
            Self::BulldozingLeftOut => {
                write!(f, "the soil has no unit weight, so the lateral force lacks the soil bulldozed by the side wall")
            }
            Self::BulldozingNotMobilised { share } => write!(
                f,
                "all of the pressure on the side wall is counted, as published; the sideways displacement under the wheel \
                 mobilises {:.2} % of it",
                100.0 * share
            ),
        }
    }
}

/// The cautions that apply to the forces of `operation` at `slip`.
pub fn cautions(operation: &Operation, slip: Slip, forces: Option<&Forces>) -> impl Iterator<Item = Caution> {
    let braking = !slip.is_driving();
    let exponent = operation.system.soil.pressure_sinkage().exponent();
    let estimate = forces.map_or(0.0, |forces| forces.integration_error);
    let share = forces.and_then(|forces| forces.side).map_or(1.0, |side| side.mobilised_share);
    let left_out = match operation.model.method {
        Method::SideSlipping(side) => side.angle.angle() != 0.0 && operation.system.soil.unit_weight().is_none(),
        _ => false,
    };
    [
        (braking && exponent.slip_gain != 0.0 && exponent.skid_gain.is_none()).then_some(Caution::SlipGainExtrapolated),
        (braking && matches!(operation.sinkage, Sinkage::FromStatic { .. })).then_some(Caution::SlipSinkageExtrapolated),
        Caution::of_integration(estimate),
        left_out.then_some(Caution::BulldozingLeftOut),
        Caution::of_bulldozing(operation, share),
    ]
    .into_iter()
    .flatten()
}
