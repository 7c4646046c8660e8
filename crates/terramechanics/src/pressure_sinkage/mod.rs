//! How does pressure grow with depth? σ = K_s z^N (letter, Eq. 1), with K_s from one of the published laws.

mod bekker;
mod diameter;
mod direct;
mod exponent;
mod reece;

pub use bekker::Bekker;
pub(crate) use bekker::{NEGATIVE_COHESIVE_MODULUS, SMALL_WHEEL};
pub use diameter::Diameter;
pub use direct::Direct;
pub use exponent::SinkageExponent;
pub use reece::Reece;

use crate::caution::Caution;
use crate::error::Error;
use crate::law::family;
use crate::numerics::elementary::Number;
use crate::slip::Slip;

family! {
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

    /// The sinkage exponent of the law.
    #[must_use]
    pub fn exponent(&self) -> SinkageExponent;

    /// Sinkage modulus K_s (Pa/m^N) under `plate`, at the sinkage exponent N (–) of the slip in question.
    fn sinkage_modulus(&self, plate: &Plate, exponent: f64) -> f64;

    /// What is to be taken with care under `plate`.
    pub(crate) fn cautions(&self, plate: &Plate) -> [Option<Caution>; 2];
}

/// What presses on the soil, as far as a law asks.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Plate {
    /// Width b of the wheel, or the smaller side of a plate (m).
    pub width: f64,
    /// Diameter 2r of the wheel (m).
    pub diameter: f64,
    /// Cohesion c of the soil (Pa).
    pub cohesion: f64,
}

/// Pressure over depth under one plate at one slip: p = K_s z^N. Eq. (1).
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct PressureCurve {
    /// Sinkage modulus K_s (Pa/m^N).
    pub modulus: f64,
    /// Sinkage exponent N (–).
    pub exponent: f64,
}

impl PressureCurve {
    /// Pressure p (Pa) at `depth` z (m), not negative. Eq. (1).
    #[inline]
    #[must_use]
    pub fn pressure(&self, depth: f64) -> f64 {
        // The logarithm is that of a normal number.
        if depth >= f64::MIN_POSITIVE {
            pressure(self.modulus, self.exponent, depth)
        } else {
            self.modulus * depth.powf(self.exponent)
        }
    }
}

/// Pressure p (Pa) at a depth z (m) greater than 0, by the modulus K_s (Pa/m^N) and the exponent N (–). Eq. (1).
#[inline(always)]
pub(crate) fn pressure<F: Number>(modulus: F, exponent: F, depth: F) -> F {
    (depth.ln() * exponent).exp() * modulus
}

impl PressureSinkage {
    /// Pressure over depth under `plate` of a wheel at `slip`; a plate that is only pressed in has [`Slip::ROLLING`].
    ///
    /// # Errors
    /// [`Error::ExponentNotPositive`] and [`Error::ModulusNotPositive`].
    ///
    /// ```
    /// use terramechanics::*;
    /// // By hand: K_s = 2000/0.1 + 980 000 = 1e6 Pa/m, and 20 kPa at 20 mm.
    /// let exponent = SinkageExponent { base: 1.0, slip_gain: 1.0, skid_gain: None };
    /// let law = PressureSinkage::Bekker(Bekker { k_c: 2000.0, k_phi: 980_000.0, exponent });
    /// let plate = Plate { width: 0.1, diameter: 0.4, cohesion: 0.0 };
    /// assert!((law.curve(&plate, Slip::ROLLING)?.pressure(0.02) - 20_000.0).abs() < 1e-9);
    /// // On the spot N = 2, and 0.02² m² times 1e6 Pa/m² are 400 Pa.
    /// assert!((law.curve(&plate, Slip::SPINNING)?.pressure(0.02) - 400.0).abs() < 1e-10);
    /// # Ok::<(), terramechanics::Error>(())
    /// ```
    #[inline(always)] // see `WheelOnSoil::rolling`
    pub fn curve(&self, plate: &Plate, slip: Slip) -> Result<PressureCurve, Error> {
        let PressureCurve { exponent, .. } = self.exponent().shape(slip)?;
        let modulus = self.sinkage_modulus(plate, exponent);
        if modulus.is_nan() || modulus <= 0.0 {
            return Err(Error::ModulusNotPositive { modulus });
        }
        Ok(PressureCurve { modulus, exponent })
    }
}
