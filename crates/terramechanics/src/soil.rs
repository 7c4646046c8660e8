//! What is the soil made of, mechanically? Strength (Mohr–Coulomb), shear deformation and pressure–sinkage.

use crate::error::{InvalidInput, Parameter, Requirement};
use crate::pressure_sinkage::PressureSinkage;
use crate::shear::ShearLaw;

/// Parameters of a soil.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct SoilParams {
    /// Cohesion c (Pa), not negative.
    pub cohesion: f64,
    /// Internal friction angle φ (rad), from 0 up to π/2.
    pub friction_angle: f64,
    /// Shear law.
    pub shear: ShearLaw,
    /// Pressure–sinkage law.
    pub pressure_sinkage: PressureSinkage,
}

/// A soil whose parameters make sense.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Soil {
    params: SoilParams,
    tan_friction: f64,
    /// Reciprocal of the displacement by which the shear law scales (1/m).
    per_shear_scale: f64,
}

impl Soil {
    /// Checks the parameters.
    ///
    /// # Errors
    /// Every parameter that is not finite or outside its range. Whether the sinkage modulus is positive depends on the
    /// wheel and is checked with it.
    pub fn new(params: SoilParams) -> Result<Self, InvalidInput> {
        let mut checks = vec![
            (Parameter::Cohesion, params.cohesion, Requirement::NotNegative),
            (
                Parameter::FrictionAngle,
                params.friction_angle,
                Requirement::FromUpTo { min: 0.0, limit: std::f64::consts::FRAC_PI_2 },
            ),
        ];
        checks.extend(params.shear.requirements());
        checks.extend(params.pressure_sinkage.requirements());
        InvalidInput::check(&checks)?;
        Ok(Self { params, tan_friction: params.friction_angle.tan(), per_shear_scale: 1.0 / params.shear.scale() })
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

    /// tan φ (–).
    #[must_use]
    pub fn tan_friction(&self) -> f64 {
        self.tan_friction
    }

    /// Pressure–sinkage law.
    #[must_use]
    pub fn pressure_sinkage(&self) -> &PressureSinkage {
        &self.params.pressure_sinkage
    }

    /// Shear law.
    #[must_use]
    pub fn shear(&self) -> &ShearLaw {
        &self.params.shear
    }

    /// E (–) at a shear displacement j (m). Eq. (6).
    #[inline]
    pub(crate) fn mobilisation(&self, displacement: f64) -> f64 {
        self.params.shear.mobilisation(displacement * self.per_shear_scale)
    }

    /// Displacement (m) over which the shear law changes.
    pub(crate) fn shear_scale(&self) -> f64 {
        self.params.shear.scale()
    }
}
