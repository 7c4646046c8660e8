//! Which numbers can be fitted, within which bounds, and on which scale.

use std::fmt;

use terramechanics::{Lambda, Method, PeakRule, PressureSinkage, ShearLaw};

use crate::setup::{Setup, SinkageSource};

/// A number that a fit may find.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub enum Unknown {
    /// Cohesion c (Pa).
    Cohesion,
    /// Internal friction angle φ (rad).
    FrictionAngle,
    /// Shear deformation modulus K (m).
    ShearModulus,
    /// Sinkage modulus K_s of the direct law (Pa/m^N).
    SinkageModulus,
    /// Cohesive modulus k_c of Bekker's or Reece's law.
    CohesiveModulus,
    /// Frictional modulus k_φ of Bekker's or Reece's law.
    FrictionalModulus,
    /// Sinkage exponent without slip n0 (–).
    BaseExponent,
    /// Gain of the exponent with slip n1 (–).
    SlipGain,
    /// c1 of Wong & Reece's rule (–).
    PeakIntercept,
    /// c2 of Wong & Reece's rule (–).
    PeakSlipGain,
    /// λ_A of the explicit method (–).
    LambdaA,
    /// λ_B of the explicit method (–).
    LambdaB,
    /// Static sinkage z0 (m).
    StaticSinkage,
}

/// Below this share of the frictional modulus times the width, the sign of the cohesive modulus does not matter.
pub(crate) const SLIGHT: f64 = 0.01;

/// A closed range of values.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Range {
    /// Smallest value.
    pub lower: f64,
    /// Largest value.
    pub upper: f64,
}

impl Range {
    /// A range between two values.
    #[must_use]
    pub const fn new(lower: f64, upper: f64) -> Self {
        Self { lower, upper }
    }

    /// Whether both ends are finite and the lower one is below the upper one.
    #[must_use]
    pub fn is_proper(&self) -> bool {
        self.lower.is_finite() && self.upper.is_finite() && self.lower < self.upper
    }

    /// Whether a value is inside.
    #[must_use]
    pub fn contains(&self, value: f64) -> bool {
        (self.lower..=self.upper).contains(&value)
    }

    /// The overlap of two ranges; this one where they do not overlap.
    fn shared_with(&self, other: &Self) -> Self {
        let shared = Self::new(self.lower.max(other.lower), self.upper.min(other.upper));
        if shared.is_proper() { shared } else { *self }
    }
}

impl Unknown {
    /// All of them.
    pub const ALL: [Self; 13] = [
        Self::Cohesion,
        Self::FrictionAngle,
        Self::ShearModulus,
        Self::SinkageModulus,
        Self::CohesiveModulus,
        Self::FrictionalModulus,
        Self::BaseExponent,
        Self::SlipGain,
        Self::PeakIntercept,
        Self::PeakSlipGain,
        Self::LambdaA,
        Self::LambdaB,
        Self::StaticSinkage,
    ];

    /// Bounds where none are given: physical limits, wide enough for every measured soil.
    #[must_use]
    pub fn bounds(self) -> Range {
        match self {
            Self::Cohesion => Range::new(0.0, 1e6),
            Self::FrictionAngle => Range::new(0.0, 1.5),
            Self::ShearModulus => Range::new(1e-5, 1.0),
            Self::SinkageModulus => Range::new(1.0, 1e13),
            Self::CohesiveModulus => Range::new(-1e8, 1e8),
            Self::FrictionalModulus => Range::new(1.0, 1e11),
            Self::BaseExponent => Range::new(0.05, 5.0),
            Self::SlipGain => Range::new(-3.0, 10.0),
            Self::PeakIntercept => Range::new(-0.5, 1.5),
            Self::PeakSlipGain => Range::new(-2.0, 2.0),
            Self::LambdaA | Self::LambdaB => Range::new(-1.0, 1.0),
            Self::StaticSinkage => Range::new(1e-6, 10.0),
        }
    }

    /// Range of further starts: the values of sands, regoliths and their simulants.
    pub(crate) fn search_range(self, bounds: &Range) -> Range {
        let usual = match self {
            Self::Cohesion => Range::new(0.0, 3e3),
            Self::FrictionAngle => Range::new(0.3, 0.8),
            Self::ShearModulus => Range::new(3e-3, 0.05),
            Self::SinkageModulus | Self::FrictionalModulus => Range::new(3e4, 3e7),
            Self::CohesiveModulus => Range::new(-1e4, 1e5),
            Self::BaseExponent => Range::new(0.5, 1.5),
            Self::SlipGain => Range::new(-0.1, 1.0),
            Self::PeakIntercept => Range::new(0.2, 0.6),
            Self::PeakSlipGain => Range::new(-0.2, 0.4),
            Self::LambdaA | Self::LambdaB => Range::new(-0.3, 0.3),
            Self::StaticSinkage => Range::new(1e-3, 0.05),
        };
        bounds.shared_with(&usual)
    }

    /// A start where neither the soil nor the caller has one.
    #[must_use]
    pub fn typical(self) -> f64 {
        match self {
            Self::Cohesion => 200.0,
            Self::FrictionAngle => 0.5,
            Self::ShearModulus => 0.015,
            Self::SinkageModulus | Self::FrictionalModulus => 1e6,
            Self::CohesiveModulus => 0.0,
            Self::BaseExponent => 1.0,
            Self::SlipGain | Self::LambdaA | Self::LambdaB => 0.0,
            Self::PeakIntercept => 0.4,
            Self::PeakSlipGain => 0.1,
            Self::StaticSinkage => 0.01,
        }
    }

    /// Largest useful error of an estimate of `value`; an estimate that is less certain counts as not determined. For moduli
    /// and lengths it is the value itself, for the others a fixed share of the range of soils.
    pub(crate) fn useful_width(self, value: f64, setup: &Setup) -> f64 {
        match self {
            Self::Cohesion => value.abs().max(500.0),
            Self::FrictionAngle => 0.2,
            Self::ShearModulus | Self::SinkageModulus | Self::FrictionalModulus | Self::StaticSinkage => value.abs(),
            Self::CohesiveModulus => {
                let frictional = Self::FrictionalModulus.value(setup).unwrap_or(0.0);
                value.abs().max(SLIGHT * setup.wheel.width() * frictional.abs())
            }
            Self::BaseExponent | Self::LambdaA | Self::LambdaB => 0.3,
            Self::SlipGain => 0.5,
            Self::PeakIntercept => 0.2,
            Self::PeakSlipGain => 0.4,
        }
    }

    /// The scale on which the fit moves the value.
    pub(crate) fn scale(self, bounds: &Range, start: f64) -> Scale {
        match self {
            Self::ShearModulus | Self::SinkageModulus | Self::FrictionalModulus | Self::StaticSinkage if bounds.lower > 0.0 => {
                Scale::Logarithmic
            }
            Self::Cohesion => Scale::Linear { unit: 1e3 },
            Self::CohesiveModulus | Self::FrictionalModulus => Scale::Linear { unit: start.abs().max(1e4) },
            Self::SinkageModulus => Scale::Linear { unit: start.abs().max(1.0) },
            Self::ShearModulus | Self::StaticSinkage => Scale::Linear { unit: 0.01 },
            _ => Scale::Linear { unit: 1.0 },
        }
    }

    /// Its value in a setup; none where the setup has no such parameter.
    #[must_use]
    pub fn value(self, setup: &Setup) -> Option<f64> {
        let Setup { mut soil, mut contact, mut model, mut sinkage, .. } = *setup;
        self.place(&mut soil, &mut contact, &mut model.method, &mut sinkage).map(|value| *value)
    }

    /// The setup with another value; the same where it has no such parameter.
    #[must_use]
    pub fn replaced(self, setup: &Setup, value: f64) -> Setup {
        let mut changed = *setup;
        if let Some(place) = self.place(&mut changed.soil, &mut changed.contact, &mut changed.model.method, &mut changed.sinkage)
        {
            *place = value;
        }
        changed
    }

    /// The place of the value in a setup.
    fn place<'a>(
        self,
        soil: &'a mut terramechanics::SoilParams,
        contact: &'a mut terramechanics::ContactParams,
        method: &'a mut Method,
        sinkage: &'a mut SinkageSource,
    ) -> Option<&'a mut f64> {
        let exponent = |law: &'a mut PressureSinkage| match law {
            PressureSinkage::Bekker(law) => &mut law.exponent,
            PressureSinkage::Direct(law) => &mut law.exponent,
            PressureSinkage::Reece(law) => &mut law.exponent,
            PressureSinkage::Diameter(law) => &mut law.exponent,
        };
        let law = soil.pressure_sinkage.as_mut();
        match (self, law) {
            (Self::Cohesion, _) => Some(&mut soil.cohesion),
            (Self::FrictionAngle, _) => Some(&mut soil.friction_angle),
            (Self::ShearModulus, _) => match &mut soil.shear {
                Some(ShearLaw::JanosiHanamoto(law)) => Some(&mut law.modulus),
                Some(ShearLaw::WongResidual(_) | ShearLaw::WongPeak(_)) | None => None,
            },
            (Self::SinkageModulus, Some(PressureSinkage::Direct(law))) => Some(&mut law.k_s),
            (Self::CohesiveModulus, Some(PressureSinkage::Bekker(law))) => Some(&mut law.k_c),
            (Self::CohesiveModulus, Some(PressureSinkage::Reece(law))) => Some(&mut law.k_c),
            (Self::FrictionalModulus, Some(PressureSinkage::Bekker(law))) => Some(&mut law.k_phi),
            (Self::FrictionalModulus, Some(PressureSinkage::Reece(law))) => Some(&mut law.k_phi),
            (Self::BaseExponent, Some(law)) => Some(&mut exponent(law).base),
            (Self::SlipGain, Some(law)) => Some(&mut exponent(law).slip_gain),
            (Self::PeakIntercept, _) => match &mut contact.rule {
                PeakRule::WongReece(rule) => Some(&mut rule.c1),
                PeakRule::Midpoint | PeakRule::HalfSinkage => None,
            },
            (Self::PeakSlipGain, _) => match &mut contact.rule {
                PeakRule::WongReece(rule) => Some(&mut rule.c2),
                PeakRule::Midpoint | PeakRule::HalfSinkage => None,
            },
            (Self::LambdaA, _) => match method {
                Method::Explicit { lambda_a: Lambda::Given(value), .. } => Some(value),
                _ => None,
            },
            (Self::LambdaB, _) => match method {
                Method::Explicit { lambda_b: Lambda::Given(value), .. } => Some(value),
                _ => None,
            },
            (Self::StaticSinkage, _) => match sinkage {
                SinkageSource::Static { static_sinkage, .. } => Some(static_sinkage),
                SinkageSource::Measured | SinkageSource::Load => None,
            },
            _ => None,
        }
    }
}

impl fmt::Display for Unknown {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(match self {
            Self::Cohesion => "c",
            Self::FrictionAngle => "φ",
            Self::ShearModulus => "K",
            Self::SinkageModulus => "K_s",
            Self::CohesiveModulus => "k_c",
            Self::FrictionalModulus => "k_φ",
            Self::BaseExponent => "n0",
            Self::SlipGain => "n1",
            Self::PeakIntercept => "c1",
            Self::PeakSlipGain => "c2",
            Self::LambdaA => "λ_A",
            Self::LambdaB => "λ_B",
            Self::StaticSinkage => "z0",
        })
    }
}

/// The scale on which the fit moves a value, with numbers of about one.
///
/// Moduli span decades and K_s z^N is a straight line in ln K_s and N, so they move on a logarithmic scale.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) enum Scale {
    /// value/unit.
    Linear { unit: f64 },
    /// ln value.
    Logarithmic,
}

impl Scale {
    pub(crate) fn inward(self, value: f64) -> f64 {
        match self {
            Self::Linear { unit } => value / unit,
            Self::Logarithmic => value.ln(),
        }
    }

    pub(crate) fn outward(self, scaled: f64) -> f64 {
        match self {
            Self::Linear { unit } => scaled * unit,
            Self::Logarithmic => scaled.exp(),
        }
    }

    /// d value/d scaled.
    pub(crate) fn slope(self, value: f64) -> f64 {
        match self {
            Self::Linear { unit } => unit,
            Self::Logarithmic => value,
        }
    }
}
