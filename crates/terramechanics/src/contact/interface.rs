//! What shears where the rim is not soil? Strength and displacement of the interface between a bare rim and the grains.
//!
//! A bare rim slips on the grains before the soil shears in itself: its friction angle is below φ, and its displacement modulus
//! several times smaller than the one a shear box gives. With the soil's own, a smooth wheel pulls too little at low slip and too
//! much at high slip. What the interface has takes the place of the soil's in
//!
//! τ = E(j/K) (c + σ tan φ) (letter, Eqs. 5, 6).
//!
//! Units: rad, Pa, m. Validity: rims that touch the soil with a surface of their own. Quoted as measured with the bevameter of the
//! Keweenaw Research Center, soil on soil and rubber on soil: φ 37.4 → 28.6°, K 24.2 → 6.0 mm, c 1.05 → 0 kPa on fine grains; 30.4 →
//! 26.4°, 18.6 → 8.9 mm, 1.56 → 0.32 kPa on coarse ones; 37.3 → 28.7°, 27.5 → 6.5 mm, 3.06 → 0.46 kPa on wet ones. No public text
//! was found to check these values by. An interface that is stronger than the soil is refused: the soil would then shear in itself.
//!
//! The angle θ0 at which two zones of a braking wheel part is that of the soil, which fails in itself there, and so is all that is
//! bulldozed. A lateral shear modulus that the soil has holds across the wheel; else the interface has one modulus both ways.

use crate::error::Error;
use crate::fittable::{Fittable, Step, Tolerance};
use crate::parameter::{Parameter, Parametrised, Presence, Requirement, present};
use crate::soil::Soil;
use crate::strength::Strength;

/// What the interface of a rim has in place of the soil; what is absent is the soil's.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct Interface {
    /// Friction angle δ (rad), at most that of the soil.
    pub friction_angle: Option<f64>,
    /// Adhesion c_a (Pa), at most the soil's cohesion.
    pub adhesion: Option<f64>,
    /// Displacement (m) by which the shear law scales along the rim.
    pub shear_modulus: Option<f64>,
}

impl Interface {
    /// δ.
    pub const FRICTION_ANGLE: Parameter = Parameter {
        symbol: "δ",
        meaning: "Friction angle between rim and soil, at most that of the soil; the soil's unless given.",
        presence: Presence::Optional,
        ..Soil::FRICTION_ANGLE
    };

    /// c_a.
    pub const ADHESION: Parameter = Parameter {
        name: "adhesion_pa",
        symbol: "c_a",
        meaning: "Adhesion between rim and soil, at most the soil's cohesion; the soil's cohesion unless given.",
        presence: Presence::Optional,
        ..Soil::COHESION
    };

    /// K_i.
    pub const SHEAR_MODULUS: Parameter = Parameter {
        name: "shear_modulus_m",
        symbol: "K_i",
        unit: "m",
        meaning: "Displacement by which the shear law scales between rim and soil; the soil's unless given.",
        requirement: Requirement::Positive,
        least: 1e-6,
        most: 10.0,
        presence: Presence::Optional,
    };

    /// The numbers that a fit may find, under names that tell them from the soil's. Bounds and scales are those of the soil's strength;
    /// the moduli measured between rims and soils are 6 to 9 mm.
    pub const FITTABLE: &'static [Fittable] = &[
        Fittable {
            parameter: Parameter { name: "interface_friction_angle_rad", ..Self::FRICTION_ANGLE },
            bounds: [0.0, 1.5],
            usual: [0.3, 0.6],
            typical: 0.4,
            tolerance: Tolerance::Fixed(0.2),
            step: Step::ONE,
        },
        Fittable {
            parameter: Parameter { name: "interface_adhesion_pa", ..Self::ADHESION },
            bounds: [0.0, 1e6],
            usual: [0.0, 1e3],
            typical: 100.0,
            tolerance: Tolerance::SizeOr(500.0),
            step: Step::Linear(1e3),
        },
        Fittable {
            parameter: Parameter { name: "interface_shear_modulus_m", ..Self::SHEAR_MODULUS },
            bounds: [1e-5, 1.0],
            usual: [1e-3, 0.02],
            typical: 5e-3,
            tolerance: Tolerance::Size,
            step: Step::Logarithmic(&Step::Linear(0.01)),
        },
    ];

    /// The values that are there, each with its parameter.
    pub fn parameters(&self) -> impl Iterator<Item = (&'static Parameter, f64)> + use<> {
        present(Self::PARAMETERS, self.values())
    }

    /// The value that a fit may find under that name, if it is there.
    #[must_use]
    pub fn fitted(&self, name: &str) -> Option<f64> {
        let place = Self::FITTABLE.iter().position(|fittable| fittable.parameter.name == name)?;
        self.values()[place]
    }

    /// The interface with another value under that name; the same where there is no such name.
    #[must_use]
    pub fn with_fitted(self, name: &str, value: f64) -> Self {
        let mut values = self.values();
        if let Some(place) = Self::FITTABLE.iter().position(|fittable| fittable.parameter.name == name) {
            values[place] = Some(value);
        }
        Self::from_values(&values).unwrap_or(self)
    }
}

impl Parametrised for Interface {
    const PARAMETERS: &'static [Parameter] = &[Self::FRICTION_ANGLE, Self::ADHESION, Self::SHEAR_MODULUS];

    fn from_values(values: &[Option<f64>]) -> Option<Self> {
        let &[friction_angle, adhesion, shear_modulus] = values else { return None };
        Some(Self { friction_angle, adhesion, shear_modulus })
    }

    fn values(&self) -> Vec<Option<f64>> {
        vec![self.friction_angle, self.adhesion, self.shear_modulus]
    }
}

impl Strength {
    /// The strength along a rim on `soil`.
    ///
    /// # Errors
    /// [`Error::InterfaceBeyondSoil`].
    #[inline]
    pub(crate) fn of(soil: &Soil, interface: Option<&Interface>) -> Result<Self, Error> {
        let soils = soil.strength();
        match interface {
            None => Ok(soils),
            Some(interface) => Self::between(soil, interface, soils),
        }
    }

    #[cold]
    fn between(soil: &Soil, interface: &Interface, soils: Self) -> Result<Self, Error> {
        let at_most = |parameter: &'static Parameter, value: f64, soil: f64| {
            if value <= soil { Ok(value) } else { Err(Error::InterfaceBeyondSoil { parameter, value, soil }) }
        };
        let cohesion = match interface.adhesion {
            Some(adhesion) => at_most(&Interface::ADHESION, adhesion, soils.cohesion)?,
            None => soils.cohesion,
        };
        let tan_friction = match interface.friction_angle {
            Some(angle) => at_most(&Interface::FRICTION_ANGLE, angle, soil.friction_angle())?.tan(),
            None => soils.tan_friction,
        };
        let (shear_scale, per_shear_scale) =
            interface.shear_modulus.map_or((soils.shear_scale, soils.per_shear_scale), |modulus| (modulus, 1.0 / modulus));
        Ok(Self { cohesion, tan_friction, shear_scale, per_shear_scale })
    }
}
