//! What is watched of the wheel, the soil and the numbers: each kind with the range in which its model was tested, who found the
//! range, and what to do beyond it.

use super::{CautionKind, TestedRange};
use crate::gravity::{ROUNDING, STANDARD_GRAVITY};
use crate::pressure_sinkage::{NEGATIVE_COHESIVE_MODULUS, SMALL_WHEEL};
use crate::soil::Soil;
use crate::wheel::Wheel;

/// Largest sinkage over radius (–) of the single-wheel tests of Yoshida et al. 2003: 30 mm under a wheel of 90 mm.
const LARGEST_SINKAGE_RATIO: f64 = 30.0 / 90.0;

/// Sinkage over diameter (–) up to which Bekker's estimates were found good (Wong, Theory of Ground Vehicles, ch. 2).
const MODERATE_DEPTH: f64 = 1.0 / 6.0;

/// Estimate of the relative integration error above which a result says so.
const LARGEST_INTEGRATION_ERROR: f64 = 1e-9;

/// Mobilised share of the pressure on the side wall below which the full pressure is more than twice the mobilised one.
const SMALLEST_MOBILISED_SHARE: f64 = 0.5;

kinds! {
    SMALL_WHEEL;
    DEEP_SINKAGE = CautionKind {
        code: "deep_sinkage",
        meaning: "The wheel sinks deeper than in the tests named. Only one wheel was tested deeper (Pavlov & Johnson 2024, up \
                  to 0.87), with a soil that was tuned to those tests. The model leaves out the soil that piles up in front \
                  of the wheel.",
        advice: "Take the forces as a rough estimate.",
        parameter: None,
        range: Some(TestedRange {
            quantity: "sinkage over radius",
            unit: "1",
            lower: None,
            upper: Some(LARGEST_SINKAGE_RATIO),
            source: "single-wheel tests of Yoshida et al. 2003 (30 mm of 90 mm) and Ding et al. 2011 (27 mm of 157 mm)",
        }),
    };
    NEGATIVE_COHESIVE_MODULUS;
    LOW_GRAVITY = CautionKind {
        code: "low_gravity",
        meaning: "The laws of pressure and shear were tested in Earth gravity. How sinkage changes in a lower gravity \
                  is an open question.",
        advice: "Allow a margin on the sinkage.",
        parameter: Some(&Soil::GRAVITY),
        range: Some(TestedRange {
            quantity: "gravity",
            unit: "m/s2",
            lower: Some((1.0 - ROUNDING) * STANDARD_GRAVITY),
            upper: None,
            source: "Kobayashi et al. 2010, Wong 2012",
        }),
    };
    LUG_HEIGHT_ASSUMED = CautionKind {
        code: "lug_height_assumed",
        meaning: "The wheel has or may have lugs, but their height is not published, so it is computed as smooth.",
        advice: "Give the lug height if it is known.",
        parameter: Some(&Wheel::LUG_HEIGHT),
        range: None,
    };
    INTERFACE_OF_LUGGED_WHEEL = CautionKind {
        code: "interface_of_lugged_wheel",
        meaning: "The contact has an interface, which is that of a bare rim, and the wheel has lugs. The soil between lugs shears \
                  against the soil beneath, with the strength of the soil. The interface is counted all the same.",
        advice: "Leave the interface out for a wheel with lugs.",
        parameter: Some(&Wheel::LUG_HEIGHT),
        range: None,
    };
    PEAK_RULE_SET_ASIDE = CautionKind {
        code: "peak_rule_set_aside",
        meaning: "The largest stress of a braking wheel with two zones lies where the zones meet, so the contact's rule for \
                  the angle of maximum stress is not used at negative slip.",
        advice: "Choose one zone to keep that rule.",
        parameter: None,
        range: None,
    };
    INTEGRATION_ERROR = CautionKind {
        code: "integration_error",
        meaning: "The integrals of the stresses are less accurate than usual.",
        advice: "Trust no more digits than this error leaves.",
        parameter: None,
        range: Some(TestedRange {
            quantity: "estimate of the error of the integrals over the scale of the forces",
            unit: "1",
            lower: None,
            upper: Some(LARGEST_INTEGRATION_ERROR),
            source: "the quadrature's own error estimate",
        }),
    };
    SINKAGE_BEYOND_ESTIMATES = CautionKind {
        code: "sinkage_beyond_estimates",
        meaning: "The wheel sinks deeper than the depth up to which Bekker's estimates were found good.",
        advice: "Compute the forces by the quadrature instead.",
        parameter: None,
        range: Some(TestedRange {
            quantity: "sinkage over diameter",
            unit: "1",
            lower: None,
            upper: Some(MODERATE_DEPTH),
            source: "Bekker, as reported by Wong, Theory of Ground Vehicles, ch. 2",
        }),
    };
    BULLDOZING_LEFT_OUT = CautionKind {
        code: "bulldozing_left_out",
        meaning: "The soil has no unit weight, so the lateral force leaves out the soil that the side wall pushes aside.",
        advice: "Give the unit weight of the soil.",
        parameter: Some(&Soil::UNIT_WEIGHT),
        range: None,
    };
    BULLDOZING_NOT_MOBILISED = CautionKind {
        code: "bulldozing_not_mobilised",
        meaning: "The full pressure on the side wall is counted, as published, although the wheel moves too little sideways \
                  to mobilise half of it.",
        advice: "Choose mobilised bulldozing, which counts the mobilised share alone.",
        parameter: None,
        range: Some(TestedRange {
            quantity: "mobilised share of the pressure on the side wall",
            unit: "1",
            lower: Some(SMALLEST_MOBILISED_SHARE),
            upper: None,
            source: "derived here, not published: the share that the shear law mobilises at the sideways displacement; the \
                     limit of one half is a choice",
        }),
    };
}
