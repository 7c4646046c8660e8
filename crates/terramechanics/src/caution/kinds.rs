//! What is watched: each kind with the range in which its model was tested, who found the range, and what to do beyond it.

use super::{Caution, CautionKind, TestedRange};
use crate::pressure_sinkage::{NEGATIVE_COHESIVE_MODULUS, SMALL_WHEEL, SinkageExponent};
use crate::rolling::WheelOnSoil;
use crate::soil::Soil;
use crate::wheel::Wheel;

/// Largest sinkage over radius (–) of the single-wheel tests of Yoshida et al. 2003: 30 mm under a wheel of 90 mm.
const LARGEST_SINKAGE_RATIO: f64 = 30.0 / 90.0;

/// Largest slip (–) of the single-wheel tests to which slip gains were fitted (Ding et al. 2010, 2011).
const LARGEST_FITTED_SLIP: f64 = 0.6;

/// Sinkage over diameter (–) up to which Bekker's estimates were found good (Wong, Theory of Ground Vehicles, ch. 2).
const MODERATE_DEPTH: f64 = 1.0 / 6.0;

/// Gravity (m/s²) of the tests, the standard acceleration (3rd General Conference on Weights and Measures, 1901).
const EARTH_GRAVITY: f64 = 9.80665;

/// Estimate of the relative integration error above which a result says so.
const LARGEST_INTEGRATION_ERROR: f64 = 1e-9;

/// Residual of the load balance over the load above which a result says so; a thousand times more is refused.
const LARGEST_LOAD_RESIDUAL: f64 = 1e-9;

/// Mobilised share of the pressure on the side wall below which the full pressure is more than twice the mobilised one.
const SMALLEST_MOBILISED_SHARE: f64 = 0.5;

/// Declares the kinds and lists them, so that none is left out of the list; those of one law alone stand with the law.
macro_rules! kinds {
    ($($name:ident $(= $kind:expr)?;)+) => {
        $($(pub(crate) static $name: CautionKind = $kind;)?)+

        impl Caution {
            /// Everything that is watched.
            pub const KINDS: &'static [&'static CautionKind] = &[$(&$name),+];
        }
    };
}

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
    SLIP_BEYOND_FIT = CautionKind {
        code: "slip_beyond_fit",
        meaning: "The slip gain n1 of the sinkage exponent was fitted to tests up to that slip and is extrapolated here.",
        advice: "Check the sinkage against a test at this slip.",
        parameter: Some(&SinkageExponent::SLIP_GAIN),
        range: Some(TestedRange {
            quantity: "slip",
            unit: "1",
            lower: None,
            upper: Some(LARGEST_FITTED_SLIP),
            source: "Ding et al. 2010, 2011",
        }),
    };
    SLIP_BEYOND_OWN_FIT = CautionKind {
        code: "slip_beyond_fit",
        meaning: "The slip is beyond the tests to which the slip gain of this soil was fitted.",
        advice: "Check the sinkage against a test at this slip.",
        parameter: Some(&SinkageExponent::SLIP_GAIN),
        range: None,
    };
    SLIP_BEYOND_LYASKO = CautionKind {
        code: "slip_beyond_fit",
        meaning: "No tested range is known for Lyasko's slip–sinkage law. At the largest slip of the tests named, wheels \
                  sank 3 to 7 times as deep as at rest; the law gives 2.3 times.",
        advice: "Expect the wheel to sink deeper than computed.",
        parameter: None,
        range: Some(TestedRange {
            quantity: "slip",
            unit: "1",
            lower: None,
            upper: Some(LARGEST_FITTED_SLIP),
            source: "single-wheel tests of Ding et al. 2010; the range of Lyasko 2010 is not known",
        }),
    };
    SLIP_BEYOND_LINEAR = CautionKind {
        code: "slip_beyond_fit",
        meaning: "The linear slip–sinkage law was published without a range, and you choose its gain. Single-wheel tests of \
                  sinkage over slip end at that slip.",
        advice: "Check the gain against a test at this slip.",
        parameter: None,
        range: Some(TestedRange {
            quantity: "slip",
            unit: "1",
            lower: None,
            upper: Some(LARGEST_FITTED_SLIP),
            source: "single-wheel tests of Ding et al. 2010, 2011; none for the law of Lines 2021",
        }),
    };
    SLIP_BEYOND_COUPLED_TESTS = CautionKind {
        code: "slip_beyond_fit",
        meaning: "The authors of the coupled forms tested driving wheels only, and no higher slips.",
        advice: "Take torque and pull as a rough estimate.",
        parameter: None,
        range: Some(TestedRange {
            quantity: "slip",
            unit: "1",
            lower: Some(0.0),
            upper: Some(LARGEST_FITTED_SLIP),
            source: "single-wheel tests of Ding et al. 2011",
        }),
    };
    SLIP_GAIN_EXTRAPOLATED = CautionKind {
        code: "slip_gain_extrapolated",
        meaning: "The slip gain n1 of the sinkage exponent was fitted to driving wheels and is applied to a braking one, \
                  because no n2 is given.",
        advice: "Give n2 if it is known for this soil.",
        parameter: Some(&SinkageExponent::SKID_GAIN),
        range: Some(TestedRange {
            quantity: "slip",
            unit: "1",
            lower: Some(0.0),
            upper: None,
            source: "Ding et al. 2010, 2011",
        }),
    };
    SLIP_SINKAGE_EXTRAPOLATED = CautionKind {
        code: "slip_sinkage_extrapolated",
        meaning: "The slip–sinkage law was fitted to driving wheels and is applied to a braking one.",
        advice: "Give the sinkage itself or the load instead of a static sinkage.",
        parameter: Some(&WheelOnSoil::STATIC_SINKAGE),
        range: Some(TestedRange {
            quantity: "slip",
            unit: "1",
            lower: Some(0.0),
            upper: None,
            source: "Lyasko 2010",
        }),
    };
    LINEAR_SLIP_SINKAGE_EXTRAPOLATED = CautionKind {
        code: "slip_sinkage_extrapolated",
        meaning: "The linear slip–sinkage law was written for driving wheels and is applied to a braking one.",
        advice: "Give the sinkage itself or the load instead of a static sinkage.",
        parameter: Some(&WheelOnSoil::STATIC_SINKAGE),
        range: Some(TestedRange {
            quantity: "slip",
            unit: "1",
            lower: Some(0.0),
            upper: None,
            source: "Lines 2021",
        }),
    };
    NEGATIVE_COHESIVE_MODULUS;
    LOW_GRAVITY = CautionKind {
        code: "low_gravity",
        meaning: "The laws of pressure and shear were tested in Earth gravity. How sinkage changes in a lower gravity \
                  is an open question.",
        advice: "Allow a margin on the sinkage.",
        parameter: None,
        range: Some(TestedRange {
            quantity: "gravity",
            unit: "m/s2",
            lower: Some(EARTH_GRAVITY),
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
    LOAD_RESIDUAL = CautionKind {
        code: "load_residual",
        meaning: "The normal force is a small difference of large parts and balances the load only to within this residual.",
        advice: "Trust no more digits of the forces than this residual leaves.",
        parameter: Some(&WheelOnSoil::NORMAL_LOAD),
        range: Some(TestedRange {
            quantity: "normal force minus load, over the load",
            unit: "1",
            lower: None,
            upper: Some(LARGEST_LOAD_RESIDUAL),
            source: "the load balance itself",
        }),
    };
    NEGATIVE_NORMAL_STRESS = CautionKind {
        code: "negative_normal_stress",
        meaning: "With this load and torque the soil would have to pull the wheel down, which it cannot do. The two do not \
                  fit together at this slip and sinkage.",
        advice: "Check the measured torque, load, slip and sinkage.",
        parameter: Some(&WheelOnSoil::TORQUE),
        range: Some(TestedRange {
            quantity: "normal stress at the peak",
            unit: "Pa",
            lower: Some(0.0),
            upper: None,
            source: "letter, Eq. 11, solved for the stresses",
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
    SLIP_GAIN_UNUSED = CautionKind {
        code: "slip_gain_unused",
        meaning: "The sinkage exponent of this soil changes with slip, but the estimates use its value without slip, n0.",
        advice: "Compute the forces by the quadrature, which follows the exponent.",
        parameter: Some(&SinkageExponent::SLIP_GAIN),
        range: None,
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
