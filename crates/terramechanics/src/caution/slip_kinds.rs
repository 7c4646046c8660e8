//! What is watched of the slip and of the laws that follow it.

use super::{CautionKind, TestedRange};
use crate::pressure_sinkage::SinkageExponent;
use crate::rolling::WheelOnSoil;

/// Largest slip (–) of the single-wheel tests to which slip gains were fitted (Ding et al. 2010, 2011).
const LARGEST_FITTED_SLIP: f64 = 0.6;

kinds! {
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
        meaning: "The slip–sinkage law was fitted to driving wheels and is applied to a braking one. It lets that rise where \
                  measured wheels sink: to 1.6 times the static sinkage at a slip of −0.5 and 3.3 times when locked, on the mean of \
                  two wheels (Pavlov & Johnson 2024).",
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
        parameter: Some(&WheelOnSoil::STATIC_SINKAGE),
        range: Some(TestedRange { quantity: "slip", unit: "1", lower: Some(0.0), upper: None, source: "Lines 2021" }),
    };
    SLIP_GAIN_UNUSED = CautionKind {
        code: "slip_gain_unused",
        meaning: "The sinkage exponent of this soil changes with slip, but the estimates use its value without slip, n0.",
        advice: "Compute the forces by the quadrature, which follows the exponent.",
        parameter: Some(&SinkageExponent::SLIP_GAIN),
        range: None,
    };
}
