//! What stresses act along the rim? Normal and shear stress of a rolling wheel (letter, Eqs. 1, 5; Wong & Reece 1967, source 22).
//!
//! | equation | here |
//! |---|---|
//! | (1) σ = K_s z^N | [`StressField::normal`] |
//! | (5) τ = E (c + σ tan φ) | [`StressField::shear`] |
//!
//! Units: σ, τ and c in Pa, φ in rad, K_s in Pa/m^N. The laws behind K_s and E have validity ranges of their own.

use crate::contact::Angles;
use crate::error::Error;
use crate::patch::ContactPatch;
use crate::pressure_sinkage::PressureCurve;
use crate::rim::RimPoint;

/// The stresses along a contact.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct StressField<'a> {
    /// The contact.
    pub patch: &'a ContactPatch<'a>,
    /// The pressure of the soil over depth.
    pub curve: &'a PressureCurve,
}

/// Stresses at one place of the rim.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Stresses {
    /// Normal stress σ (Pa).
    pub normal: f64,
    /// Shear stress τ (Pa), positive where the soil pushes the wheel forward.
    pub shear: f64,
}

impl ContactPatch<'_> {
    /// The stresses along the contact.
    ///
    /// # Errors
    /// [`Error::MissingLaw`] where the soil has no pressure–sinkage law.
    #[inline(always)] // see `WheelOnSoil::rolling`
    pub fn stresses(&self) -> Result<StressField<'_>, Error> {
        Ok(StressField { patch: self, curve: self.rolling.curve()? })
    }
}

impl StressField<'_> {
    /// Normal stress σ (Pa) at `theta` (rad); 0 outside the contact. Eq. (1).
    #[must_use]
    pub fn normal(&self, theta: f64) -> f64 {
        self.at(theta).normal
    }

    /// Shear stress τ (Pa) at `theta` (rad); 0 outside the contact. Eq. (5).
    #[must_use]
    pub fn shear(&self, theta: f64) -> f64 {
        self.at(theta).shear
    }

    /// Both stresses at `theta` (rad); 0 outside the contact.
    #[must_use]
    pub fn at(&self, theta: f64) -> Stresses {
        let Angles { entry, exit, .. } = self.patch.angles;
        if !(exit..=entry).contains(&theta) {
            return Stresses { normal: 0.0, shear: 0.0 };
        }
        self.under(&self.patch.rim_point(entry - theta), self.patch.depth(theta))
    }

    /// Stresses at a rim point if the depth that sets its normal stress were `depth` (m). Eqs. (1), (5).
    #[inline]
    pub(crate) fn under(&self, point: &RimPoint, depth: f64) -> Stresses {
        let normal = self.curve.pressure(depth);
        Stresses { normal, shear: self.patch.mobilisation(point) * self.patch.rolling.shear_strength(normal) }
    }
}
