//! How does pressure grow with depth? σ = K_s z^N (letter, Eq. 1), with K_s from one of the published laws.

mod bekker;
mod diameter;
mod direct;
mod reece;

pub use bekker::Bekker;
pub use diameter::Diameter;
pub use direct::Direct;
pub use reece::Reece;

use crate::error::{Parameter, Requirement};
use crate::slip::Slip;

/// N = n0 + n1 s: the exponent of the sinkage, which grows with slip (letter, below Eq. 1; Ding et al. 2010), and with a gain of
/// its own at negative slip where one was measured (Pavlov & Johnson 2024).
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct SinkageExponent {
    /// n0, the exponent without slip (–).
    pub base: f64,
    /// n1, its gain with slip (–); 0 where none was measured.
    pub slip_gain: f64,
    /// n2, its gain with skid (–): N = n0 − n2 s at s < 0; where none was measured, n1 is applied there too.
    pub skid_gain: Option<f64>,
}

impl SinkageExponent {
    /// N at `slip` (–).
    #[must_use]
    pub fn at(&self, slip: Slip) -> f64 {
        match self.skid_gain {
            Some(skid_gain) if !slip.is_driving() => self.base - skid_gain * slip.ratio(),
            _ => self.base + self.slip_gain * slip.ratio(),
        }
    }
}

/// What a law may depend on besides its own parameters.
pub(crate) struct PlateConditions {
    /// Width b of the wheel (m).
    pub(crate) width: f64,
    /// Diameter 2r of the wheel (m).
    pub(crate) diameter: f64,
    /// Cohesion c of the soil (Pa).
    pub(crate) cohesion: f64,
    /// Sinkage exponent N at the slip in question (–).
    pub(crate) exponent: f64,
}

/// A pressure–sinkage law with its parameters.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum PressureSinkage {
    /// Bekker 1956, 1969.
    Bekker(Bekker),
    /// A sinkage modulus given as it is.
    Direct(Direct),
    /// Reece 1965.
    Reece(Reece),
    /// Meirion-Griffith & Spenko 2011.
    Diameter(Diameter),
}

impl PressureSinkage {
    /// The sinkage exponent of the law.
    #[must_use]
    pub fn exponent(&self) -> SinkageExponent {
        match self {
            Self::Bekker(law) => law.exponent,
            Self::Direct(law) => law.exponent,
            Self::Reece(law) => law.exponent,
            Self::Diameter(law) => law.exponent,
        }
    }

    /// Sinkage modulus K_s (Pa/m^N).
    pub(crate) fn sinkage_modulus(&self, conditions: &PlateConditions) -> f64 {
        match self {
            Self::Bekker(law) => law.sinkage_modulus(conditions),
            Self::Direct(law) => law.sinkage_modulus(),
            Self::Reece(law) => law.sinkage_modulus(conditions),
            Self::Diameter(law) => law.sinkage_modulus(conditions),
        }
    }

    /// What every parameter of the law has to satisfy by itself; K_s > 0 depends on the wheel and is checked there.
    pub(crate) fn requirements(&self) -> Vec<(Parameter, f64, Requirement)> {
        use Parameter as P;
        use Requirement::{Finite, NotNegative};
        let mut checks = match *self {
            Self::Bekker(Bekker { k_c, k_phi, .. }) => {
                vec![(P::CohesiveModulus, k_c, Finite), (P::FrictionalModulus, k_phi, Finite)]
            }
            Self::Direct(Direct { k_s, .. }) => vec![(P::SinkageModulus, k_s, Finite)],
            Self::Reece(Reece { k_c, k_phi, unit_weight, .. }) => {
                vec![
                    (P::CohesiveModulus, k_c, Finite),
                    (P::FrictionalModulus, k_phi, Finite),
                    (P::UnitWeight, unit_weight, NotNegative),
                ]
            }
            Self::Diameter(Diameter { k, m, .. }) => vec![(P::DiameterCoefficient, k, Finite), (P::DiameterExponent, m, Finite)],
        };
        let SinkageExponent { base, slip_gain, skid_gain } = self.exponent();
        checks.extend([(P::BaseExponent, base, Finite), (P::SlipGain, slip_gain, Finite)]);
        checks.extend(skid_gain.map(|gain| (P::SkidGain, gain, Finite)));
        checks
    }
}
