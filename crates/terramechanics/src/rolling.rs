//! Which law of pressure holds for a wheel at its slip? Modulus and exponent, and what else does not depend on the sinkage.

use crate::contact::Contact;
use crate::error::Error;
use crate::pressure_sinkage::PlateConditions;
use crate::slip::Slip;
use crate::soil::Soil;
use crate::stress::ContactPatch;
use crate::wheel::Wheel;

/// A wheel on a soil, touching it in a given way.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct WheelOnSoil {
    /// The wheel.
    pub wheel: Wheel,
    /// The soil.
    pub soil: Soil,
    /// How the contact lies on the rim.
    pub contact: Contact,
}

/// A wheel on a soil at one slip: all that does not depend on the sinkage.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Rolling<'a> {
    /// The wheel, the soil and the rule of the contact.
    pub system: &'a WheelOnSoil,
    /// The slip.
    pub slip: Slip,
    modulus: f64,
    exponent: f64,
    velocity_ratio: f64,
    velocity_complement: f64,
    /// θ0 where the law of braking has two zones.
    pub(crate) reversal: Option<f64>,
}

impl WheelOnSoil {
    /// The wheel rolling at `slip`.
    ///
    /// # Errors
    /// [`Error::ExponentNotPositive`] and [`Error::ModulusNotPositive`].
    #[inline(always)] // as a call it takes a third longer to the explicit forces: its answer passes through memory
    pub fn rolling(&self, slip: Slip) -> Result<Rolling<'_>, Error> {
        let law = self.soil.pressure_sinkage();
        let exponent = law.exponent().at(slip);
        if exponent <= 0.0 {
            return Err(Error::ExponentNotPositive { exponent });
        }
        let modulus = law.sinkage_modulus(&PlateConditions {
            width: self.wheel.width(),
            diameter: 2.0 * self.wheel.radius(),
            cohesion: self.soil.cohesion(),
            exponent,
        });
        if modulus.is_nan() || modulus <= 0.0 {
            return Err(Error::ModulusNotPositive { modulus });
        }
        let (velocity_ratio, velocity_complement) = slip.velocity_ratio();
        let reversal = self.contact.braking().reversal(slip, &self.soil);
        Ok(Rolling { system: self, slip, modulus, exponent, velocity_ratio, velocity_complement, reversal })
    }
}

impl Rolling<'_> {
    /// Sinkage modulus K_s (Pa/m^N).
    #[must_use]
    pub fn sinkage_modulus(&self) -> f64 {
        self.modulus
    }

    /// Sinkage exponent N (–).
    #[must_use]
    pub fn sinkage_exponent(&self) -> f64 {
        self.exponent
    }

    /// The contact at `sinkage` z (m).
    ///
    /// # Errors
    /// [`Error::SinkageOutsideWheel`] unless 0 < z ≤ r, [`Error::PeakOutsideContact`], [`Error::ReversalOutsideContact`].
    pub fn contact(&self, sinkage: f64) -> Result<ContactPatch<'_>, Error> {
        let radius = self.system.wheel.radius();
        if !(sinkage > 0.0 && sinkage <= radius) {
            return Err(Error::SinkageOutsideWheel { sinkage, radius });
        }
        let depth_ratio = sinkage / radius;
        let angles = match self.reversal {
            None => self.system.contact.angles(depth_ratio, self.slip)?,
            Some(reversal) => self.system.contact.angles_parted_at(reversal, depth_ratio)?,
        };
        Ok(ContactPatch::new(self, sinkage, angles))
    }

    /// θ* (rad): the rim of a braking wheel slips forwards over the soil between −θ* and θ*, where cos θ > 1/κ, and backwards
    /// elsewhere; that of a driving wheel backwards throughout, and least at θ* = 0.
    pub(crate) fn turning(&self) -> f64 {
        // arccos(1 + s), written for small slip.
        2.0 * (-0.5 * self.slip.ratio().min(0.0)).sqrt().asin()
    }

    /// Sinkages (m) between which the wheel can have a contact: the lower one, not itself one of them, is 0 unless two zones
    /// take a depth of their own.
    pub(crate) fn sinkages(&self) -> (f64, f64) {
        let radius = self.system.wheel.radius();
        self.reversal.map_or((0.0, radius), |reversal| self.system.contact.sinkages_parted_at(reversal, radius))
    }

    /// κ = v/(rω) and 1 − κ.
    #[inline]
    pub(crate) fn velocity_ratio(&self) -> (f64, f64) {
        (self.velocity_ratio, self.velocity_complement)
    }

    /// σ (Pa) at `depth` (m). Eq. (1).
    #[inline]
    pub(crate) fn pressure(&self, depth: f64) -> f64 {
        self.modulus * depth.powf(self.exponent)
    }

    /// Shear strength c + σ tan φ (Pa). Eq. (5).
    #[inline]
    pub(crate) fn shear_strength(&self, normal_stress: f64) -> f64 {
        self.system.soil.cohesion() + normal_stress * self.system.soil.tan_friction()
    }
}
