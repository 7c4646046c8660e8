//! What shape is the wheel? A rigid cylinder, with or without lugs (letter, Eq. 9).

use crate::fault::InvalidInput;
use crate::parameter::{Parameter, Parametrised, Presence, Requirement, present};

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

impl Parametrised for WheelParams {
    const PARAMETERS: &'static [Parameter] = &[Wheel::RADIUS, Wheel::WIDTH, Wheel::LUG_HEIGHT, Wheel::LUG_COEFFICIENT];

    fn from_values(values: &[Option<f64>]) -> Option<Self> {
        let &[radius, width, lug_height, lug_coefficient] = values else { return None };
        Some(Self { radius: radius?, width: width?, lug_height: lug_height?, lug_coefficient: lug_coefficient? })
    }

    fn values(&self) -> Vec<Option<f64>> {
        [self.radius, self.width, self.lug_height, self.lug_coefficient].map(Some).to_vec()
    }
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

    /// r.
    pub const RADIUS: Parameter = Parameter {
        name: "radius_m",
        symbol: "r",
        unit: "m",
        meaning: "Rim radius.",
        requirement: Requirement::Positive,
        least: 1e-3,
        most: 100.0,
        presence: Presence::Required,
    };

    /// b.
    pub const WIDTH: Parameter = Parameter {
        name: "width_m",
        symbol: "b",
        unit: "m",
        meaning: "Width.",
        requirement: Requirement::Positive,
        least: 1e-3,
        most: 100.0,
        presence: Presence::Required,
    };

    /// h.
    pub const LUG_HEIGHT: Parameter = Parameter {
        name: "lug_height_m",
        symbol: "h",
        unit: "m",
        meaning: "Lug height; 0 for a smooth wheel.",
        requirement: Requirement::NotNegative,
        least: 0.0,
        most: 10.0,
        presence: Presence::Default(0.0),
    };

    /// λ_s.
    pub const LUG_COEFFICIENT: Parameter = Parameter {
        name: "lug_coefficient",
        symbol: "λ_s",
        unit: "1",
        meaning: "Lug coefficient: the shear stress acts at r + λ_s h.",
        requirement: Requirement::Within { min: 0.0, max: 1.0 },
        least: 0.0,
        most: 1.0,
        presence: Presence::Default(Self::TYPICAL_LUG_COEFFICIENT),
    };

    /// Checks the dimensions.
    ///
    /// # Errors
    /// Every dimension that is not finite or outside its range.
    pub fn new(params: WheelParams) -> Result<Self, InvalidInput> {
        InvalidInput::check(present(WheelParams::PARAMETERS, params.values()))?;
        Ok(Self { params, lug_height_is_assumed: false })
    }

    /// The dimensions it was made of.
    #[must_use]
    pub fn params(&self) -> &WheelParams {
        &self.params
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
        self.params.radius + self.shearing_offset() // Eq. (9)
    }

    /// r_s − r = λ_s h (m), with all its digits.
    pub(crate) fn shearing_offset(&self) -> f64 {
        self.params.lug_coefficient * self.params.lug_height
    }

    /// Radius of the lug tips, r + h (m).
    #[must_use]
    pub fn lug_tip_radius(&self) -> f64 {
        self.params.radius + self.params.lug_height
    }
}
