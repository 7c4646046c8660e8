//! What shape is the wheel? A rigid cylinder, with or without lugs (letter, Eq. 9).

use crate::error::{InvalidInput, Parameter, Requirement};

/// Dimensions of a rigid wheel.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct WheelParams {
    /// Rim radius r (m), greater than 0.
    pub radius: f64,
    /// Width b (m), greater than 0.
    pub width: f64,
    /// Lug height h (m), 0 for a smooth wheel.
    pub lug_height: f64,
    /// Lug coefficient λ_s, from 0 to 1: the share of the lug height at which the shear stress acts.
    pub lug_coefficient: f64,
}

/// A wheel whose dimensions make sense.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Wheel {
    params: WheelParams,
    /// Whether the lug height is a stand-in for one that nobody knows.
    lug_height_is_assumed: bool,
}

impl Wheel {
    /// Lug coefficient where none is known ("typically set to 0.5", letter, below Eq. 9).
    pub const TYPICAL_LUG_COEFFICIENT: f64 = 0.5;

    /// Checks the dimensions.
    ///
    /// # Errors
    /// Every dimension that is not finite or outside its range.
    pub fn new(params: WheelParams) -> Result<Self, InvalidInput> {
        InvalidInput::check(&[
            (Parameter::Radius, params.radius, Requirement::Positive),
            (Parameter::Width, params.width, Requirement::Positive),
            (Parameter::LugHeight, params.lug_height, Requirement::NotNegative),
            (Parameter::LugCoefficient, params.lug_coefficient, Requirement::Within { min: 0.0, max: 1.0 }),
        ])?;
        Ok(Self { params, lug_height_is_assumed: false })
    }

    /// The same wheel, marked as one whose lug height is not known: its results carry a [`crate::Caution`] that says so.
    #[must_use]
    pub fn with_unknown_lug_height(self) -> Self {
        Self { lug_height_is_assumed: true, ..self }
    }

    /// Whether the lug height stands in for one that is not known.
    #[must_use]
    pub fn lug_height_is_assumed(&self) -> bool {
        self.lug_height_is_assumed
    }

    /// Rim radius r (m).
    #[must_use]
    pub fn radius(&self) -> f64 {
        self.params.radius
    }

    /// Width b (m).
    #[must_use]
    pub fn width(&self) -> f64 {
        self.params.width
    }

    /// Lug height h (m).
    #[must_use]
    pub fn lug_height(&self) -> f64 {
        self.params.lug_height
    }

    /// Radius at which the shear stress acts, r_s = r + λ_s h (m). Eq. (9).
    ///
    /// ```
    /// # use terramechanics::{Wheel, WheelParams};
    /// let wheel = Wheel::new(WheelParams { radius: 0.2, width: 0.1, lug_height: 0.01, lug_coefficient: 0.5 })?;
    /// assert!((wheel.shearing_radius() - 0.205).abs() < 1e-15);
    /// # Ok::<(), terramechanics::InvalidInput>(())
    /// ```
    #[must_use]
    pub fn shearing_radius(&self) -> f64 {
        self.params.radius + self.params.lug_coefficient * self.params.lug_height // Eq. (9)
    }
}
