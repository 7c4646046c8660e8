//! What is watched of gravity and of the resistive force method.

use super::{CautionKind, TestedRange};
use crate::slip::Slip;
use crate::soil::Soil;
use crate::wheel::Wheel;

/// Cohesion (Pa) that dry sands of test beds have at the most; beyond, what the method leaves out carries a good part of a light
/// wheel.
const LARGEST_COHESION_OF_GRAINS: f64 = 300.0;

kinds! {
    MODULI_OF_OTHER_GRAVITY = CautionKind {
        code: "moduli_of_other_gravity",
        meaning: "Bekker's moduli are those of the gravity in which they were measured, and this soil is taken to another one. \
                  Its weights follow gravity, its moduli do not.",
        advice: "Use moduli measured in this gravity, Reece's law, or the method `resistive_force`, whose stiffness follows \
                 gravity.",
        parameter: Some(&Soil::GRAVITY),
        range: None,
    };
    RESISTIVE_FORCE_BRAKING = CautionKind {
        code: "driving_only",
        meaning: "The resistive force method meets driving wheels. Its pull of braking wheels was found to be off by 0.8 of the \
                  load.",
        advice: "Use the quadrature for a braking wheel, with two zones where it has room for them.",
        parameter: Some(&Slip::RATIO),
        range: Some(TestedRange {
            quantity: "slip",
            unit: "1",
            lower: Some(0.0),
            upper: None,
            source: "comparison with public single-wheel tests of braking wheels",
        }),
    };
    COHESION_LEFT_OUT = CautionKind {
        code: "cohesion_left_out",
        meaning: "The resistive force method is made for dry grains and leaves the cohesion of the soil out.",
        advice: "Use the quadrature, which counts cohesion.",
        parameter: Some(&Soil::COHESION),
        range: Some(TestedRange {
            quantity: "cohesion",
            unit: "Pa",
            lower: None,
            upper: Some(LARGEST_COHESION_OF_GRAINS),
            source: "a choice: what is reported for dry sands of test beds",
        }),
    };
    ROUGH_CYLINDER = CautionKind {
        code: "rough_cylinder",
        meaning: "The resistive force method takes the rim of this wheel for a rough cylinder and leaves its lugs out. The torque \
                  suffers most.",
        advice: "Use the quadrature where the torque matters.",
        parameter: Some(&Wheel::LUG_HEIGHT),
        range: None,
    };
}
