//! What is watched of gravity and of the resistive force method.

use super::{CautionKind, TestedRange};
use crate::slip::Slip;
use crate::soil::Soil;
use crate::wheel::Wheel;

/// Cohesion (Pa) that dry sands of test beds have at the most; beyond, what the method leaves out carries a good part of a light
/// wheel.
const LARGEST_COHESION_OF_GRAINS: f64 = 300.0;

/// Difference of a unit weight from density times gravity, over the latter, beyond which they are no roundings of each other; a choice.
const LARGEST_WEIGHT_DIFFERENCE: f64 = 0.05;

kinds! {
    UNIT_WEIGHTS_DIFFER = CautionKind {
        code: "unit_weights_differ",
        meaning: "The unit weight of the soil, or the one in Reece's law, is not its bulk density times gravity, by this share. Each is \
                  used where it is asked for, so that parts of the answer belong to different soils.",
        advice: "Give one of them, or check both and the gravity in which they hold.",
        parameter: Some(&Soil::UNIT_WEIGHT),
        range: Some(TestedRange {
            quantity: "relative difference of the unit weight from density times gravity",
            unit: "1",
            lower: Some(-LARGEST_WEIGHT_DIFFERENCE),
            upper: Some(LARGEST_WEIGHT_DIFFERENCE),
            source: "density times gravity; the bound is a choice",
        }),
    };
    MODULI_OF_OTHER_GRAVITY = CautionKind {
        code: "moduli_of_other_gravity",
        meaning: "Bekker's moduli are those of the gravity in which they were measured, and here the soil is in another one. \
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
        advice: "Use the quadrature for a braking wheel, with `two_zone` for its `braking`.",
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
