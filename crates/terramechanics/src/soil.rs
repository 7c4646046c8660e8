//! What is the soil made of, mechanically? Strength (Mohr–Coulomb), shear deformation and pressure–sinkage.
//!
//! Strength is what every model asks for. The two laws may be unknown: a model that needs one says so by
//! [`Error::MissingLaw`], and the others do not miss it.

use crate::error::{Error, SoilLaw};
use crate::fault::InvalidInput;
use crate::parameter::{Parametrised, present};
use crate::pressure_sinkage::{PressureSinkage, SinkageExponent};
use crate::shear::ShearLaw;
use crate::strength::Strength;

/// Parameters of a soil.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct SoilParams {
    /// Cohesion c (Pa), not negative.
    pub cohesion: f64,
    /// Internal friction angle φ (rad), from 0 up to π/2.
    pub friction_angle: f64,
    /// Shear law, where one is known; all but the classical sinkage and resistances need it.
    pub shear: Option<ShearLaw>,
    /// Pressure–sinkage law, where one is known; what a measured load gives does not need it.
    pub pressure_sinkage: Option<PressureSinkage>,
    /// Sinkage exponent N, where it is known and no law is: under a load that is known, the integrals take nothing else of a law.
    pub exponent_alone: Option<SinkageExponent>,
    /// Unit weight γ (N/m³), greater than 0, if known.
    pub unit_weight: Option<f64>,
    /// Shear deformation modulus K_y across the direction of travel (m), greater than 0, if it differs from the one along it.
    pub lateral_shear_modulus: Option<f64>,
    /// Bulk density ρ (kg/m³), greater than 0, if known; it gives the unit weight where none is known, and the granular stiffness.
    pub bulk_density: Option<f64>,
    /// Gravity g (m/s²), greater than 0, in which these values hold, if known.
    pub gravity: Option<f64>,
    /// Granular stiffness ξ (N/m³), greater than 0, if known; it follows from the density where it is not.
    pub granular_stiffness: Option<f64>,
}

/// A soil whose parameters make sense.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Soil {
    params: SoilParams,
    strength: Strength,
    /// Unit weight γ (N/m³), if known: the soil's own, else the one in its pressure–sinkage law.
    unit_weight: Option<f64>,
    /// Gravity (m/s²) in which the soil was measured, if it is known.
    measured_gravity: Option<f64>,
    /// Largest slip (–) of the tests to which the gain of the sinkage exponent was fitted, if it is known.
    largest_fitted_slip: Option<f64>,
}

impl Soil {
    /// Checks the parameters.
    ///
    /// # Errors
    /// Every parameter that is not finite or outside its range. Whether the sinkage modulus is positive depends on the
    /// wheel and is checked with it.
    pub fn new(params: SoilParams) -> Result<Self, InvalidInput> {
        let [cohesion, friction_angle, lateral_shear_modulus, unit_weight, grains @ ..] = params.values();
        let strength = present(&[Self::COHESION, Self::FRICTION_ANGLE], vec![cohesion, friction_angle]);
        let laws = params.shear.iter().flat_map(ShearLaw::parameters);
        let laws = laws.chain(params.pressure_sinkage.iter().flat_map(PressureSinkage::parameters));
        let laws =
            laws.chain(params.exponent_alone.iter().flat_map(|exponent| present(SinkageExponent::PARAMETERS, exponent.values())));
        let rest = present(&[Self::UNIT_WEIGHT, Self::LATERAL_SHEAR_MODULUS], vec![unit_weight, lateral_shear_modulus]);
        let grains = present(&[Self::BULK_DENSITY, Self::GRAVITY, Self::GRANULAR_STIFFNESS], grains.to_vec());
        InvalidInput::check(strength.chain(laws).chain(rest).chain(grains))?;
        let in_the_law = || {
            let parameters = params.pressure_sinkage.iter().flat_map(PressureSinkage::parameters);
            parameters.filter(|(parameter, _)| parameter.name == Self::UNIT_WEIGHT.name).map(|(_, value)| value).next()
        };
        Ok(Self {
            params,
            strength: Strength {
                cohesion: params.cohesion,
                tan_friction: params.friction_angle.tan(),
                shear_scale: params.shear.map_or(f64::NAN, |law| law.scale()),
                per_shear_scale: params.shear.map_or(f64::NAN, |law| 1.0 / law.scale()),
            },
            unit_weight: params.unit_weight.or_else(in_the_law),
            measured_gravity: params.gravity,
            largest_fitted_slip: None,
        })
    }

    /// Gravity (m/s²) in which the soil was measured, if it is known: the one that it was made with, wherever it was taken since.
    #[must_use]
    pub fn measured_gravity(&self) -> Option<f64> {
        self.measured_gravity
    }

    /// The same soil, marked as one whose values were measured in `gravity` (m/s²), wherever it lies now. No weight changes with
    /// it; moduli that are used in another gravity carry a [`crate::Caution`].
    #[must_use]
    pub fn measured_in(self, gravity: f64) -> Self {
        Self { measured_gravity: Some(gravity), ..self }
    }

    /// The same soil with what is remembered of another's measurement.
    pub(crate) fn marked_as(self, other: &Self) -> Self {
        let Self { measured_gravity, largest_fitted_slip, .. } = *other;
        Self { measured_gravity, largest_fitted_slip, ..self }
    }

    /// The same soil, marked as one whose gain of the sinkage exponent was fitted to tests up to this slip (–). No force
    /// depends on it; results beyond carry a [`crate::Caution`].
    #[must_use]
    pub fn fitted_up_to(self, slip: f64) -> Self {
        Self { largest_fitted_slip: Some(slip), ..self }
    }

    /// Largest slip (–) of the tests to which the gain of the sinkage exponent was fitted, if it is known.
    #[must_use]
    pub fn largest_fitted_slip(&self) -> Option<f64> {
        self.largest_fitted_slip
    }

    /// The parameters it was made of.
    #[must_use]
    pub fn params(&self) -> &SoilParams {
        &self.params
    }

    /// Cohesion c (Pa).
    #[must_use]
    pub fn cohesion(&self) -> f64 {
        self.params.cohesion
    }

    /// Internal friction angle φ (rad).
    #[must_use]
    pub fn friction_angle(&self) -> f64 {
        self.params.friction_angle
    }

    /// tan φ (–).
    #[must_use]
    pub fn tan_friction(&self) -> f64 {
        self.strength.tan_friction
    }

    /// Pressure–sinkage law, where one is known.
    #[must_use]
    pub fn pressure_sinkage(&self) -> Option<&PressureSinkage> {
        self.params.pressure_sinkage.as_ref()
    }

    /// Sinkage exponent N: that of the pressure–sinkage law, else the one that is known without a law.
    #[inline]
    #[must_use]
    pub fn sinkage_exponent(&self) -> Option<SinkageExponent> {
        self.params.pressure_sinkage.as_ref().map(PressureSinkage::exponent).or(self.params.exponent_alone)
    }

    /// Shear law, where one is known.
    #[must_use]
    pub fn shear(&self) -> Option<&ShearLaw> {
        self.params.shear.as_ref()
    }

    /// The shear law, for what cannot do without.
    ///
    /// # Errors
    /// [`Error::MissingLaw`].
    #[inline]
    pub(crate) fn required_shear(&self) -> Result<&ShearLaw, Error> {
        self.params.shear.as_ref().ok_or(Error::MissingLaw(SoilLaw::Shear))
    }

    /// Unit weight γ (N/m³), if known: the soil's own, else the one in Reece's law, else ρ g.
    #[must_use]
    pub fn unit_weight(&self) -> Option<f64> {
        self.unit_weight.or_else(|| Some(self.params.bulk_density? * self.gravity_or_standard()))
    }

    /// By how much a unit weight that is given, its own or the one in Reece's law, exceeds ρ g, over the latter; that of the two which
    /// is further off, and 0 where there is nothing to compare.
    pub(crate) fn weight_contradiction(&self) -> f64 {
        let Some(density) = self.params.bulk_density else { return 0.0 };
        let in_the_law = match self.params.pressure_sinkage {
            Some(PressureSinkage::Reece(law)) => Some(law.unit_weight),
            _ => None,
        };
        let off = |weight: Option<f64>| weight.map_or(0.0, |weight| weight / (density * self.gravity_or_standard()) - 1.0);
        let (own, of_law) = (off(self.params.unit_weight), off(in_the_law));
        if of_law.abs() > own.abs() { of_law } else { own }
    }

    /// Shear deformation modulus across the direction of travel (m): its own, else the displacement by which the shear law
    /// scales (K for Janosi–Hanamoto); none where neither is known.
    #[must_use]
    pub fn lateral_shear_modulus(&self) -> Option<f64> {
        self.params.lateral_shear_modulus.or(self.params.shear.map(|law| law.scale()))
    }

    /// What shears within the soil.
    #[inline]
    pub(crate) fn strength(&self) -> Strength {
        self.strength
    }
}

impl SoilParams {
    /// A soil without strength, of which nothing else is known: what a literal of the others leaves out.
    pub const BARE: Self = Self {
        cohesion: 0.0,
        friction_angle: 0.0,
        shear: None,
        pressure_sinkage: None,
        exponent_alone: None,
        unit_weight: None,
        lateral_shear_modulus: None,
        bulk_density: None,
        gravity: None,
        granular_stiffness: None,
    };

    /// The values of [`Soil::PARAMETERS`].
    #[must_use]
    pub fn values(&self) -> [Option<f64>; 7] {
        let Self { cohesion, friction_angle, lateral_shear_modulus, unit_weight, .. } = *self;
        let Self { bulk_density, gravity, granular_stiffness, .. } = *self;
        [Some(cohesion), Some(friction_angle), lateral_shear_modulus, unit_weight, bulk_density, gravity, granular_stiffness]
    }

    /// A soil without laws from the values of [`Soil::PARAMETERS`]; none where a required one is absent.
    #[must_use]
    pub fn from_values(values: [Option<f64>; 7]) -> Option<Self> {
        let [cohesion, friction_angle, lateral_shear_modulus, unit_weight, bulk_density, gravity, granular_stiffness] = values;
        let (cohesion, friction_angle) = (cohesion?, friction_angle?);
        let weights = Self { unit_weight, bulk_density, gravity, granular_stiffness, ..Self::BARE };
        Some(Self { cohesion, friction_angle, lateral_shear_modulus, ..weights })
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::pressure_sinkage::{Bekker, Reece, SinkageExponent};
    use crate::shear::{JanosiHanamoto, WongPeak};

    const EXPONENT: SinkageExponent = SinkageExponent { base: 1.0, slip_gain: 0.0, skid_gain: None };
    const SOIL: SoilParams = SoilParams {
        cohesion: 0.0,
        friction_angle: 0.5,
        shear: Some(ShearLaw::JanosiHanamoto(JanosiHanamoto { modulus: 0.01 })),
        pressure_sinkage: Some(PressureSinkage::Bekker(Bekker { k_c: 0.0, k_phi: 1e6, exponent: EXPONENT })),
        ..SoilParams::BARE
    };

    fn soil(params: SoilParams) -> Soil {
        Soil::new(params).expect("a soil")
    }

    #[test]
    fn the_unit_weight_is_the_soils_own_or_that_of_reeces_law() {
        let reece = Some(PressureSinkage::Reece(Reece { k_c: 0.0, k_phi: 80.0, unit_weight: 1.5e4, exponent: EXPONENT }));
        assert_eq!(soil(SOIL).unit_weight(), None);
        assert_eq!(soil(SoilParams { pressure_sinkage: reece, ..SOIL }).unit_weight(), Some(1.5e4));
        let own = SoilParams { pressure_sinkage: reece, unit_weight: Some(2e4), ..SOIL };
        assert_eq!(soil(own).unit_weight(), Some(2e4));
    }

    #[test]
    fn the_lateral_modulus_is_its_own_or_the_length_of_the_shear_law() {
        assert_eq!(soil(SOIL).lateral_shear_modulus(), Some(0.01));
        let peak = Some(ShearLaw::WongPeak(WongPeak { peak_displacement: 0.02 }));
        assert_eq!(soil(SoilParams { shear: peak, ..SOIL }).lateral_shear_modulus(), Some(0.02));
        assert_eq!(soil(SoilParams { lateral_shear_modulus: Some(0.03), ..SOIL }).lateral_shear_modulus(), Some(0.03));
        assert_eq!(soil(SoilParams { shear: None, ..SOIL }).lateral_shear_modulus(), None);
    }
}
