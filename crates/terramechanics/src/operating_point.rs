//! What is known of the sinkage, and what holds at one slip.

use crate::contact::Angles;
use crate::forces::Forces;
use crate::pressure_sinkage::PressureCurve;
use crate::slip::Slip;
use crate::slip_sinkage::SlipSinkage;

/// How the sinkage is known.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Sinkage {
    /// Given (m).
    Given(f64),
    /// From the static sinkage and the slip.
    FromStatic {
        /// Static sinkage z0 (m).
        static_sinkage: f64,
        /// Slip–sinkage law.
        law: SlipSinkage,
    },
    /// Such that the normal force carries this load (N).
    CarryingLoad(f64),
    /// Known together with the load, which takes the place of the sinkage modulus.
    UnderLoad {
        /// The sinkage.
        sinkage: KnownSinkage,
        /// Load W (N).
        load: f64,
    },
}

/// A sinkage that is known without the soil.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum KnownSinkage {
    /// Given (m).
    Given(f64),
    /// From the static sinkage and the slip.
    FromStatic {
        /// Static sinkage z0 (m).
        static_sinkage: f64,
        /// Slip–sinkage law.
        law: SlipSinkage,
    },
}

impl KnownSinkage {
    /// The sinkage z (m) at `slip`.
    #[must_use]
    pub fn at(&self, slip: Slip) -> f64 {
        match *self {
            Self::Given(sinkage) => sinkage,
            Self::FromStatic { static_sinkage, law } => law.sinkage(static_sinkage, slip),
        }
    }
}

impl Sinkage {
    /// The load (N) where it is known.
    #[must_use]
    pub fn load(&self) -> Option<f64> {
        match *self {
            Self::CarryingLoad(load) | Self::UnderLoad { load, .. } => Some(load),
            Self::Given(_) | Self::FromStatic { .. } => None,
        }
    }

    /// The slip–sinkage law that it follows, if it does.
    #[must_use]
    pub fn law(&self) -> Option<SlipSinkage> {
        match *self {
            Self::FromStatic { law, .. } | Self::UnderLoad { sinkage: KnownSinkage::FromStatic { law, .. }, .. } => Some(law),
            Self::Given(_) | Self::CarryingLoad(_) | Self::UnderLoad { .. } => None,
        }
    }

    /// What the normal stress follows from.
    #[must_use]
    pub fn normal_stress_from(&self) -> NormalStressFrom {
        if matches!(self, Self::UnderLoad { .. }) { NormalStressFrom::Load } else { NormalStressFrom::Soil }
    }
}

/// What the normal stress follows from.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum NormalStressFrom {
    /// The pressure–sinkage law of the soil.
    Soil,
    /// The load, which is known as well as the sinkage.
    Load,
}

impl NormalStressFrom {
    /// A name for programs.
    #[must_use]
    pub fn name(self) -> &'static str {
        match self {
            Self::Soil => "soil",
            Self::Load => "load",
        }
    }
}

/// What holds at one slip.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct OperatingPoint {
    /// The slip.
    pub slip: Slip,
    /// Sinkage z (m).
    pub sinkage: f64,
    /// Characteristic angles.
    pub angles: Angles,
    /// Pressure over depth under the wheel: the soil's, or what the load shows. None by the resistive force method, and where a closed
    /// form under a known load does without, on a soil that has no exponent.
    pub curve: Option<PressureCurve>,
    /// Granular stiffness ξ (N/m³) by the resistive force method: the soil's, or what the load shows. None by another method.
    pub granular_stiffness: Option<f64>,
    /// What the normal stress follows from.
    pub normal_stress_from: NormalStressFrom,
    /// The forces on a wheel that moves forward.
    pub forces: Forces,
}

impl OperatingPoint {
    /// Sinkage modulus K_s (Pa/m^N): the soil's, or the one found from the load.
    #[must_use]
    pub fn sinkage_modulus(&self) -> Option<f64> {
        self.curve.map(|curve| curve.modulus)
    }

    /// Sinkage exponent N (–).
    #[must_use]
    pub fn sinkage_exponent(&self) -> Option<f64> {
        self.curve.map(|curve| curve.exponent)
    }
}
