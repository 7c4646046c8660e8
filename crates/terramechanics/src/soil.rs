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
    /// Unit weight γ (N/m³), greater than 0, if known.
    pub unit_weight: Option<f64>,
    /// Shear deformation modulus K_y across the direction of travel (m), greater than 0, if it differs from the one along it.
    pub lateral_shear_modulus: Option<f64>,
}

/// A soil whose parameters make sense.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Soil {
    params: SoilParams,
    tan_friction: f64,
    /// Reciprocal of the displacement by which the shear law scales (1/m).
    per_shear_scale: f64,
    /// Gravity where the soil lies (m/s²), if it is known.
    gravity: Option<f64>,
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
        for (parameter, value) in
            [(Parameter::SoilUnitWeight, params.unit_weight), (Parameter::LateralShearModulus, params.lateral_shear_modulus)]
        {
            checks.extend(value.map(|value| (parameter, value, Requirement::Positive)));
        }
        InvalidInput::check(&checks)?;
        let (tan_friction, per_shear_scale) = (params.friction_angle.tan(), 1.0 / params.shear.scale());
        Ok(Self { params, tan_friction, per_shear_scale, gravity: None, largest_fitted_slip: None })
    }

    /// The same soil, marked as one that lies in this gravity (m/s²). No force depends on it, as the weight of the wheel is
    /// given; results in a low one carry a [`crate::Caution`].
    #[must_use]
    pub fn in_gravity(self, gravity: f64) -> Self {
        Self { gravity: Some(gravity), ..self }
    }

    /// Gravity where the soil lies (m/s²), if it is known.
    #[must_use]
    pub fn gravity(&self) -> Option<f64> {
        self.gravity
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

    /// Unit weight γ (N/m³), if known: the soil's own, else the one in Reece's law.
    #[must_use]
    pub fn unit_weight(&self) -> Option<f64> {
        let in_the_law = match self.params.pressure_sinkage {
            PressureSinkage::Reece(law) => Some(law.unit_weight),
            _ => None,
        };
        self.params.unit_weight.or(in_the_law)
    }

    /// Shear deformation modulus across the direction of travel (m): its own, else the displacement by which the shear law
    /// scales (K for Janosi–Hanamoto).
    #[must_use]
    pub fn lateral_shear_modulus(&self) -> f64 {
        self.params.lateral_shear_modulus.unwrap_or_else(|| self.shear_scale())
    }

    /// E (–) at a shear displacement j (m). Eq. (6).
    #[inline]
    pub(crate) fn mobilisation(&self, displacement: f64) -> f64 {
        self.params.shear.mobilisation(displacement * self.per_shear_scale)
    }

    /// Reciprocal of the displacement by which the shear law scales along the wheel (1/m).
    #[inline]
    pub(crate) fn per_shear_scale(&self) -> f64 {
        self.per_shear_scale
    }

    /// The same across the wheel (1/m).
    #[inline]
    pub(crate) fn per_lateral_modulus(&self) -> f64 {
        1.0 / self.lateral_shear_modulus()
    }

    /// Displacement (m) over which the shear law changes.
    pub(crate) fn shear_scale(&self) -> f64 {
        self.params.shear.scale()
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
        shear: ShearLaw::JanosiHanamoto(JanosiHanamoto { modulus: 0.01 }),
        pressure_sinkage: PressureSinkage::Bekker(Bekker { k_c: 0.0, k_phi: 1e6, exponent: EXPONENT }),
        unit_weight: None,
        lateral_shear_modulus: None,
    };

    fn soil(params: SoilParams) -> Soil {
        Soil::new(params).expect("a soil")
    }

    #[test]
    fn the_unit_weight_is_the_soils_own_or_that_of_reeces_law() {
        let reece = PressureSinkage::Reece(Reece { k_c: 0.0, k_phi: 80.0, unit_weight: 1.5e4, exponent: EXPONENT });
        assert_eq!(soil(SOIL).unit_weight(), None);
        assert_eq!(soil(SoilParams { pressure_sinkage: reece, ..SOIL }).unit_weight(), Some(1.5e4));
        let own = SoilParams { pressure_sinkage: reece, unit_weight: Some(2e4), ..SOIL };
        assert_eq!(soil(own).unit_weight(), Some(2e4));
    }

    #[test]
    fn the_lateral_modulus_is_its_own_or_the_length_of_the_shear_law() {
        assert_eq!(soil(SOIL).lateral_shear_modulus(), 0.01);
        let peak = ShearLaw::WongPeak(WongPeak { peak_displacement: 0.02 });
        assert_eq!(soil(SoilParams { shear: peak, ..SOIL }).lateral_shear_modulus(), 0.02);
        assert_eq!(soil(SoilParams { lateral_shear_modulus: Some(0.03), ..SOIL }).lateral_shear_modulus(), 0.03);
    }
}
