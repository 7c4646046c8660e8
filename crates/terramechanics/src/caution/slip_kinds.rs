//! What is watched of the slip and of the laws that follow it.

use super::{CautionKind, TestedRange};
use crate::pressure_sinkage::SinkageExponent;
use crate::rolling::WheelOnSoil;
use crate::slip_sinkage::LinearSlipSinkage;

/// Largest slip (–) of the single-wheel tests to which slip gains were fitted (Ding et al. 2010, 2011).
const LARGEST_FITTED_SLIP: f64 = 0.6;

kinds! {
    SLIP_BEYOND_FIT = CautionKind {
        code: "slip_beyond_fit",
        meaning: "The slip gain of the sinkage exponent was fitted to tests up to this slip and is extrapolated beyond it.",
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
        meaning: "No range is known for Lyasko's slip–sinkage law. At this slip, the largest of the tests named, wheels had \
                  sunk to 3 to 7 times the static sinkage, where the law gives 2.3 times.",
        advice: "Expect a deeper wheel than is computed.",
        parameter: None,
        range: Some(TestedRange {
            quantity: "slip",
            unit: "1",
            lower: None,
            upper: Some(LARGEST_FITTED_SLIP),
            source: "single-wheel tests of Ding et al. 2010; Lyasko 2010 was not read for a range",
        }),
    };
    SLIP_BEYOND_LINEAR = CautionKind {
        code: "slip_beyond_fit",
        meaning: "The linear slip–sinkage law was published without a range, and its gain is the caller's own. Single-wheel \
                  tests of sinkage over slip go up to this slip.",
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
        meaning: "The coupled forms come from authors whose single-wheel tests had driving wheels up to this slip.",
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
        meaning: "The slip–sinkage law was fitted to driving wheels and is applied to a braking one. It lets that rise where \
                  measured wheels sink: one with lugs to 1.6 times the static sinkage at a slip of −0.5 and 3.3 times when locked \
                  (Pavlov & Johnson 2024).",
        advice: "Give the sinkage itself or the load instead of a static sinkage, or the linear law with a skid gain.",
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
        meaning: "The linear slip–sinkage law was written for driving wheels and is applied to a braking one, because no skid gain is \
                  given. It lets that rise where measured wheels sink (Pavlov & Johnson 2024).",
        advice: "Give a skid gain, or the sinkage itself or the load instead of a static sinkage.",
        parameter: Some(&LinearSlipSinkage::SKID_GAIN),
        range: Some(TestedRange {
            quantity: "slip",
            unit: "1",
            lower: Some(0.0),
            upper: None,
            source: "Lines 2021",
        }),
    };
    SLIP_GAIN_UNUSED = CautionKind {
        code: "slip_gain_unused",
        meaning: "The sinkage exponent of this soil changes with slip, but the estimates use its value without slip, n0.",
        advice: "Compute the forces by the quadrature, which follows the exponent.",
        parameter: Some(&SinkageExponent::SLIP_GAIN),
        range: None,
    };
}
