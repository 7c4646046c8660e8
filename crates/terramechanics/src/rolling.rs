//! What holds for a wheel at its slip, however deep it sinks? Its motion, and the laws of its soil.

use crate::circles::Kinematics;
use crate::contact::Contact;
use crate::error::{Error, SoilLaw};
use crate::fittable::{Fittable, Step, Tolerance};
use crate::numerics::elementary::Number;
use crate::numerics::lanes::Arithmetic;
use crate::parameter::{Parameter, Presence, Requirement};
use crate::pressure_sinkage::{Plate, PressureCurve};
use crate::shear::{JanosiHanamoto, ShearLaw};
use crate::slip::Slip;
use crate::soil::Soil;
use crate::strength::Strength;
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
    shear: &'a ShearLaw,
    /// The pressure over depth, where the soil has a law for it.
    curve: Option<PressureCurve>,
    /// The motion of the circle on which the shear displacement is counted.
    pub(crate) kinematics: Kinematics,
    /// What shears along the rim.
    pub(crate) strength: Strength,
    /// θ0 where the law of braking has two zones.
    pub(crate) reversal: Option<f64>,
}

impl WheelOnSoil {
    /// z.
    pub const SINKAGE: Parameter = Parameter {
        name: "sinkage_m",
        symbol: "z",
        unit: "m",
        meaning: "Sinkage of the wheel, at most its radius.",
        requirement: Requirement::Positive,
        least: 1e-9,
        most: 100.0,
        presence: Presence::Optional,
    };

    /// z0.
    pub const STATIC_SINKAGE: Parameter = Parameter {
        name: "static_sinkage_m",
        symbol: "z0",
        unit: "m",
        meaning: "Static sinkage, from which the sinkage follows with the slip.",
        requirement: Requirement::Positive,
        least: 1e-9,
        most: 100.0,
        presence: Presence::Optional,
    };

    /// W.
    pub const NORMAL_LOAD: Parameter = Parameter {
        name: "normal_load_n",
        symbol: "W",
        unit: "N",
        meaning: "Vertical load on the wheel.",
        requirement: Requirement::Positive,
        least: 1e-9,
        most: 1e12,
        presence: Presence::Optional,
    };

    /// T.
    pub const TORQUE: Parameter = Parameter {
        name: "torque_n_m",
        symbol: "T",
        unit: "N.m",
        meaning: "Torque about the axle, in the sense of the motion.",
        requirement: Requirement::Finite,
        least: -1e12,
        most: 1e12,
        presence: Presence::Optional,
    };

    /// What is known of a wheel at work; each operation says which of it is needed.
    pub const PARAMETERS: &'static [Parameter] = &[Self::SINKAGE, Self::STATIC_SINKAGE, Self::NORMAL_LOAD, Self::TORQUE];

    /// The static sinkage in a fit.
    pub const FITTABLE: &'static [Fittable] = &[Fittable {
        parameter: Self::STATIC_SINKAGE,
        bounds: [1e-6, 10.0],
        usual: [1e-3, 0.05],
        typical: 0.01,
        tolerance: Tolerance::Size,
        step: Step::Logarithmic(&Step::Linear(0.01)),
    }];

    /// The wheel rolling at `slip`.
    ///
    /// # Errors
    /// [`Error::MissingLaw`] where the soil has no shear law; [`Error::ExponentNotPositive`] and
    /// [`Error::ModulusNotPositive`] by its pressure–sinkage law, if it has one; [`Error::InterfaceBeyondSoil`] where the interface
    /// of the contact is stronger than the soil.
    #[inline(always)] // as a call its answer passes through memory, which the explicit forces feel
    pub fn rolling(&self, slip: Slip) -> Result<Rolling<'_>, Error> {
        let curve = match self.soil.pressure_sinkage() {
            Some(law) => Some(law.curve(&self.plate(), slip)?),
            None => None,
        };
        self.rolling_on(slip, curve)
    }

    /// The wheel rolling at `slip` under a load that is known: of its pressure–sinkage law the exponent counts alone, and the modulus
    /// is 1. A soil may have that exponent without a law.
    ///
    /// # Errors
    /// What [`WheelOnSoil::rolling`] refuses but for the modulus.
    pub fn rolling_under_load(&self, slip: Slip) -> Result<Rolling<'_>, Error> {
        let curve = match self.soil.sinkage_exponent() {
            Some(exponent) => Some(exponent.shape(slip)?),
            None => None,
        };
        self.rolling_on(slip, curve)
    }

    #[inline(always)] // as above
    fn rolling_on(&self, slip: Slip, curve: Option<PressureCurve>) -> Result<Rolling<'_>, Error> {
        let shear = self.soil.required_shear()?;
        let kinematics = self.kinematics(slip);
        let strength = Strength::of(&self.soil, self.contact.params().interface.as_ref())?;
        let reversal = self.contact.braking().reversal(kinematics.skid, self.soil.tan_friction());
        Ok(Rolling { system: self, slip, shear, curve, kinematics, strength, reversal })
    }

    /// The wheel rolling at `slip` in grains: neither the laws of the soil nor the zones of braking have a part in it. What needs a law
    /// all the same finds no number.
    pub(crate) fn rolling_in_grains(&self, slip: Slip) -> Rolling<'_> {
        static NO_LAW: ShearLaw = ShearLaw::JanosiHanamoto(JanosiHanamoto { modulus: f64::NAN });
        let strength = Strength { shear_scale: f64::NAN, per_shear_scale: f64::NAN, ..self.soil.strength() };
        let kinematics = self.kinematics(slip);
        Rolling { system: self, slip, shear: &NO_LAW, curve: None, kinematics, strength, reversal: None }
    }

    /// The motion at `slip` of the circle on which the shear displacement is counted.
    #[inline]
    pub(crate) fn kinematics(&self, slip: Slip) -> Kinematics {
        Kinematics::of(self.contact.circles(), &self.wheel, slip)
    }

    /// Pressure over depth under the wheel at `slip`.
    ///
    /// # Errors
    /// [`Error::MissingLaw`] where the soil has no pressure–sinkage law; what [`PressureSinkage::curve`] refuses.
    ///
    /// [`PressureSinkage::curve`]: crate::PressureSinkage::curve
    pub fn curve(&self, slip: Slip) -> Result<PressureCurve, Error> {
        let law = self.soil.pressure_sinkage().ok_or(Error::MissingLaw(SoilLaw::PressureSinkage))?;
        law.curve(&self.plate(), slip)
    }

    /// The wheel and the soil as a pressure–sinkage law sees them.
    #[must_use]
    pub fn plate(&self) -> Plate {
        Plate { width: self.wheel.width(), diameter: 2.0 * self.wheel.radius(), cohesion: self.soil.cohesion() }
    }
}

impl Rolling<'_> {
    /// The same wheel on a soil of that pressure and that cohesion (Pa).
    pub(crate) fn pressed_by(&self, curve: PressureCurve, cohesion: f64) -> Self {
        Self { curve: Some(curve), strength: Strength { cohesion, ..self.strength }, ..*self }
    }
    /// Pressure over depth under the wheel.
    ///
    /// # Errors
    /// [`Error::MissingLaw`] where the soil has no pressure–sinkage law.
    #[inline(always)] // see `WheelOnSoil::rolling`
    pub fn curve(&self) -> Result<&PressureCurve, Error> {
        self.curve.as_ref().ok_or(Error::MissingLaw(SoilLaw::PressureSinkage))
    }

    /// The shear law of the soil.
    #[inline]
    #[must_use]
    pub fn shear(&self) -> &ShearLaw {
        self.shear
    }

    /// E (–) at a shear displacement j (m). Eq. (6).
    #[inline(always)]
    pub(crate) fn mobilisation<F: Number>(&self, displacement: F) -> F {
        self.shear.mobilisation(displacement * self.strength.per_shear_scale)
    }

    /// dE/dθ1 (1/rad) where E is `share` at a shear displacement j (m) that changes at `rate` = dj/dθ1 (m/rad).
    #[inline(always)]
    pub(crate) fn mobilisation_rate<F: Number>(&self, displacement: F, share: F, rate: F) -> F {
        let per_shear_scale = self.strength.per_shear_scale;
        self.shear.steepness(Arithmetic::abs(displacement) * per_shear_scale, share) * rate * per_shear_scale
    }

    /// Reciprocal of the displacement by which the shear law scales across the wheel (1/m).
    #[inline]
    pub(crate) fn per_lateral_modulus(&self) -> f64 {
        1.0 / self.system.soil.params().lateral_shear_modulus.unwrap_or(self.strength.shear_scale)
    }

    /// θ* (rad): the circle of the displacement, where it skids, slips forwards over the soil between −θ* and θ*, where cos θ > 1/κ,
    /// and backwards elsewhere; else backwards throughout, and least at θ* = 0.
    pub(crate) fn turning(&self) -> f64 {
        // arccos(1/κ), written for small skid.
        2.0 * (0.5 * self.kinematics.skid.max(0.0)).sqrt().asin()
    }

    /// Sinkages (m) between which the wheel can have a contact: the lower one, not itself one of them, is 0 unless two zones
    /// take a depth of their own.
    pub(crate) fn sinkages(&self) -> (f64, f64) {
        let radius = self.system.wheel.radius();
        self.reversal.map_or((0.0, radius), |reversal| self.system.contact.sinkages_parted_at(reversal, radius))
    }

    /// Shear strength c + σ tan φ (Pa) along the rim. Eq. (5).
    #[inline(always)]
    pub(crate) fn shear_strength<F: Number>(&self, normal_stress: F) -> F {
        normal_stress * self.strength.tan_friction + self.strength.cohesion
    }
}
