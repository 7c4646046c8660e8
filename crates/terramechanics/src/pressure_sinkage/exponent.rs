//! How fast does pressure grow with depth, and how does slip change that? N = n0 + n1 s (letter, below Eq. 1; Ding et al. 2010,
//! source 5), with a gain of its own at negative slip where one was measured (Pavlov & Johnson 2024, source 25).

use super::PressureCurve;
use crate::error::Error;
use crate::fittable::{Fittable, Step, Tolerance};
use crate::parameter::{Parameter, Parametrised, Presence, Requirement};
use crate::slip::Slip;

/// N = n0 + n1 s: the exponent of the sinkage, which grows with slip.
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
    /// n0.
    pub const BASE: Parameter = Parameter {
        name: "n0",
        symbol: "n0",
        unit: "1",
        meaning: "Sinkage exponent without slip.",
        requirement: Requirement::Finite,
        least: 1e-3,
        most: 10.0,
        presence: Presence::Required,
    };

    /// n1.
    pub const SLIP_GAIN: Parameter = Parameter {
        name: "n1",
        symbol: "n1",
        unit: "1",
        meaning: "Gain of the exponent with slip.",
        requirement: Requirement::Finite,
        least: -10.0,
        most: 10.0,
        presence: Presence::Default(0.0),
    };

    /// n2.
    pub const SKID_GAIN: Parameter = Parameter {
        name: "n2",
        symbol: "n2",
        unit: "1",
        meaning: "Gain of the exponent with skid: N = n0 − n2 s at s < 0; n1 holds there too unless given.",
        requirement: Requirement::Finite,
        least: -10.0,
        most: 10.0,
        presence: Presence::Optional,
    };

    /// n0 in a fit.
    pub const FITTABLE_BASE: Fittable = Fittable {
        parameter: Self::BASE,
        bounds: [0.05, 5.0],
        usual: [0.5, 1.5],
        typical: 1.0,
        tolerance: Tolerance::Fixed(0.3),
        step: Step::ONE,
    };

    /// n1 in a fit.
    pub const FITTABLE_SLIP_GAIN: Fittable = Fittable {
        parameter: Self::SLIP_GAIN,
        bounds: [-3.0, 10.0],
        usual: [-0.1, 1.0],
        typical: 0.0,
        tolerance: Tolerance::Fixed(0.5),
        step: Step::ONE,
    };

    /// N at `slip` (–).
    ///
    /// ```
    /// # use terramechanics::{SinkageExponent, Slip};
    /// let exponent = SinkageExponent { base: 1.0, slip_gain: 0.5, skid_gain: Some(0.8) };
    /// assert_eq!(exponent.at(Slip::new(0.5)?), 1.25); // 1 + 0.5 · 0.5
    /// assert_eq!(exponent.at(Slip::new(-0.5)?), 1.4); // 1 + 0.8 · 0.5
    /// # Ok::<(), terramechanics::Error>(())
    /// ```
    #[must_use]
    pub fn at(&self, slip: Slip) -> f64 {
        match self.skid_gain {
            Some(skid_gain) if !slip.is_driving() => self.base - skid_gain * slip.ratio(),
            _ => self.base + self.slip_gain * slip.ratio(),
        }
    }
}

impl SinkageExponent {
    /// How pressure grows with depth at `slip`, with a modulus of 1.
    ///
    /// # Errors
    /// [`Error::ExponentNotPositive`].
    #[inline]
    pub(crate) fn shape(&self, slip: Slip) -> Result<PressureCurve, Error> {
        let exponent = self.at(slip);
        if exponent <= 0.0 { Err(Error::ExponentNotPositive { exponent }) } else { Ok(PressureCurve { modulus: 1.0, exponent }) }
    }

    /// Whether it is the same at any slip.
    pub(crate) fn is_fixed(&self) -> bool {
        self.slip_gain == 0.0 && self.skid_gain.is_none_or(|gain| gain == 0.0)
    }
}

impl Parametrised for SinkageExponent {
    const PARAMETERS: &'static [Parameter] = &[Self::BASE, Self::SLIP_GAIN, Self::SKID_GAIN];

    fn from_values(values: &[Option<f64>]) -> Option<Self> {
        let &[base, slip_gain, skid_gain] = values else { return None };
        Some(Self { base: base?, slip_gain: slip_gain?, skid_gain })
    }

    fn values(&self) -> Vec<Option<f64>> {
        vec![Some(self.base), Some(self.slip_gain), self.skid_gain]
    }
}
