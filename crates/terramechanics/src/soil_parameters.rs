//! What a soil is made of that is no law's: the parameters of strength and weight, and what a fit may find of them.

use std::f64::consts::FRAC_PI_2;

use crate::fittable::{Fittable, Step, Tolerance};
use crate::parameter::{Parameter, Presence, Requirement};
use crate::soil::Soil;

impl Soil {
    /// c.
    pub const COHESION: Parameter = Parameter {
        name: "cohesion_pa",
        symbol: "c",
        unit: "Pa",
        meaning: "Cohesion.",
        requirement: Requirement::NotNegative,
        least: 0.0,
        most: 1e8,
        presence: Presence::Required,
    };

    /// φ.
    pub const FRICTION_ANGLE: Parameter = Parameter {
        name: "friction_angle_rad",
        symbol: "φ",
        unit: "rad",
        meaning: "Internal friction angle.",
        requirement: Requirement::FromUpTo { min: 0.0, limit: FRAC_PI_2 },
        least: 0.0,
        most: FRAC_PI_2,
        presence: Presence::Required,
    };

    /// K_y.
    pub const LATERAL_SHEAR_MODULUS: Parameter = Parameter {
        name: "lateral_shear_modulus_m",
        symbol: "K_y",
        unit: "m",
        meaning: "Shear deformation modulus across the direction of travel; unless given, that along it, or the length of another shear law.",
        requirement: Requirement::Positive,
        least: 1e-6,
        most: 10.0,
        presence: Presence::Optional,
    };

    /// γ.
    pub const UNIT_WEIGHT: Parameter = Parameter {
        name: "unit_weight_n_m3",
        symbol: "γ",
        unit: "N/m3",
        meaning: "Unit weight, for what lies beside and in front of the wheel; that of the pressure–sinkage law unless given.",
        requirement: Requirement::Positive,
        least: 1.0,
        most: 1e6,
        presence: Presence::Optional,
    };

    /// What a soil has besides the parameters of its laws.
    pub const PARAMETERS: &'static [Parameter] = &[
        Self::COHESION,
        Self::FRICTION_ANGLE,
        Self::LATERAL_SHEAR_MODULUS,
        Self::UNIT_WEIGHT,
        Self::BULK_DENSITY,
        Self::GRAVITY,
        Self::GRANULAR_STIFFNESS,
    ];

    /// Its strength in a fit, and its stiffness by the resistive force method.
    pub const FITTABLE: &'static [Fittable] = &[
        Fittable {
            parameter: Self::COHESION,
            bounds: [0.0, 1e6],
            usual: [0.0, 3e3],
            typical: 200.0,
            tolerance: Tolerance::SizeOr(500.0),
            step: Step::Linear(1e3),
        },
        Fittable {
            parameter: Self::FRICTION_ANGLE,
            bounds: [0.0, 1.5],
            usual: [0.3, 0.8],
            typical: 0.5,
            tolerance: Tolerance::Fixed(0.2),
            step: Step::ONE,
        },
        // Grains of 1 to 3 g/cm³ under 0.1 to 2 times the Earth's gravity; the usual values are those of sands on Earth and the Moon.
        Fittable {
            parameter: Self::GRANULAR_STIFFNESS,
            bounds: [1e2, 1e9],
            usual: [1e5, 1e7],
            typical: 1.5e6,
            tolerance: Tolerance::Size,
            step: Step::Logarithmic(&Step::OfStart(1.0)),
        },
    ];
}
