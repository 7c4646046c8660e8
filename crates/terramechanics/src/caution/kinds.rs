//! What is watched: each with the range in which its model was tested, and who found the range.

use super::{CautionKind, TestedRange};

/// Smallest diameter (m) for which Bekker's law holds without a correction (Meirion-Griffith & Spenko 2011).
const SMALLEST_DIAMETER: f64 = 0.5;

/// Largest sinkage over radius (–) of the single-wheel tests of Yoshida et al. 2003: 30 mm under a wheel of 90 mm.
const LARGEST_SINKAGE_RATIO: f64 = 30.0 / 90.0;

/// Largest slip (–) of the single-wheel tests to which slip gains were fitted (Ding et al. 2010, 2011).
const LARGEST_FITTED_SLIP: f64 = 0.6;

/// Width over the width −k_c/k_φ at which the sinkage modulus vanishes, below which the modulus hangs on the extrapolation
/// of a negative k_c: there it is less than half of k_φ.
const SMALLEST_WIDTH_RATIO: f64 = 2.0;

/// Sinkage over diameter (–) up to which Bekker's estimates were found good (Wong, Theory of Ground Vehicles, ch. 2).
const MODERATE_DEPTH: f64 = 1.0 / 6.0;

/// Gravity (m/s²) of the tests, the standard acceleration (3rd General Conference on Weights and Measures, 1901).
const EARTH_GRAVITY: f64 = 9.80665;

/// Estimate of the relative integration error above which a result says so.
const LARGEST_INTEGRATION_ERROR: f64 = 1e-9;

/// Residual of the load balance over the load above which a result says so.
const LARGEST_LOAD_RESIDUAL: f64 = 1e-9;

/// Share of the pressure on the side wall below which all of it is more than twice what is there.
const SMALLEST_MOBILISED_SHARE: f64 = 0.5;

pub(crate) static SMALL_WHEEL: CautionKind = CautionKind {
    code: "small_wheel",
    meaning: "Bekker's law was made for large plates and wheels; under small wheels it errs, the law `diameter` corrects for it",
    range: Some(TestedRange {
        quantity: "diameter (m)",
        lower: Some(SMALLEST_DIAMETER),
        upper: None,
        source: "Meirion-Griffith & Spenko 2011",
    }),
};

pub(crate) static DEEP_SINKAGE: CautionKind = CautionKind {
    code: "deep_sinkage",
    meaning: "the wheel sinks deeper than in the tests named; deeper ones are known of one wheel alone (Pavlov & Johnson 2024, up to \
              0.87), whose soil was tuned to them; the soil that piles up in front is not in the model",
    range: Some(TestedRange {
        quantity: "sinkage over radius (–)",
        lower: None,
        upper: Some(LARGEST_SINKAGE_RATIO),
        source: "single-wheel tests of Yoshida et al. 2003 (30 mm of 90 mm) and Ding et al. 2011 (27 mm of 157 mm)",
    }),
};

pub(crate) static SLIP_BEYOND_FIT: CautionKind = CautionKind {
    code: "slip_beyond_fit",
    meaning: "the gain of the sinkage exponent with slip was fitted to tests up to this slip and extrapolates beyond",
    range: Some(TestedRange {
        quantity: "slip (–)",
        lower: None,
        upper: Some(LARGEST_FITTED_SLIP),
        source: "Ding et al. 2010, 2011",
    }),
};

pub(crate) static SLIP_BEYOND_OWN_FIT: CautionKind = CautionKind {
    code: "slip_beyond_fit",
    meaning: "the slip is beyond the tests to which the gain of this soil's sinkage exponent was fitted",
    range: None,
};

pub(crate) static SLIP_BEYOND_LYASKO: CautionKind = CautionKind {
    code: "slip_beyond_fit",
    meaning: "no range is known here for Lyasko's slip–sinkage law; at this slip, the largest of the tests named, wheels had sunk to \
              3 to 7 times the static sinkage, where the law gives 2.3 times",
    range: Some(TestedRange {
        quantity: "slip (–)",
        lower: None,
        upper: Some(LARGEST_FITTED_SLIP),
        source: "single-wheel tests of Ding et al. 2010; Lyasko 2010 was not read for a range",
    }),
};

pub(crate) static SLIP_BEYOND_LINEAR: CautionKind = CautionKind {
    code: "slip_beyond_fit",
    meaning: "no range was published with the linear slip–sinkage law, whose gain is the request's own; single-wheel tests of how the \
              sinkage grows with slip go up to this slip",
    range: Some(TestedRange {
        quantity: "slip (–)",
        lower: None,
        upper: Some(LARGEST_FITTED_SLIP),
        source: "single-wheel tests of Ding et al. 2010, 2011; none for the law of Lines 2021",
    }),
};

pub(crate) static SLIP_BEYOND_COUPLED_TESTS: CautionKind = CautionKind {
    code: "slip_beyond_fit",
    meaning: "the coupled forms come from authors whose single-wheel tests had driving wheels up to this slip",
    range: Some(TestedRange {
        quantity: "slip (–)",
        lower: Some(0.0),
        upper: Some(LARGEST_FITTED_SLIP),
        source: "single-wheel tests of Ding et al. 2011",
    }),
};

pub(crate) static SLIP_GAIN_EXTRAPOLATED: CautionKind = CautionKind {
    code: "slip_gain_extrapolated",
    meaning: "the slip gain n1 of the sinkage exponent was fitted to driving wheels and is applied to a braking one, for which \
              no n2 is given",
    range: Some(TestedRange { quantity: "slip (–)", lower: Some(0.0), upper: None, source: "Ding et al. 2010, 2011" }),
};

pub(crate) static SLIP_SINKAGE_EXTRAPOLATED: CautionKind = CautionKind {
    code: "slip_sinkage_extrapolated",
    meaning: "the slip–sinkage law was fitted to driving wheels and is applied to a braking one",
    range: Some(TestedRange { quantity: "slip (–)", lower: Some(0.0), upper: None, source: "Lyasko 2010" }),
};

pub(crate) static LINEAR_SLIP_SINKAGE_EXTRAPOLATED: CautionKind = CautionKind {
    code: "slip_sinkage_extrapolated",
    meaning: "the linear slip–sinkage law was written for driving wheels and is applied to a braking one",
    range: Some(TestedRange { quantity: "slip (–)", lower: Some(0.0), upper: None, source: "Lines 2021" }),
};

pub(crate) static NEGATIVE_COHESIVE_MODULUS: CautionKind = CautionKind {
    code: "negative_cohesive_modulus",
    meaning: "k_c is negative, an artefact of its fit, and takes more than half of k_φ at this width; the modulus vanishes at 1",
    range: Some(TestedRange {
        quantity: "width over −k_c/k_φ (–)",
        lower: Some(SMALLEST_WIDTH_RATIO),
        upper: None,
        source: "K_s = k_c/b + k_φ (Bekker 1969), which is 0 at b = −k_c/k_φ",
    }),
};

pub(crate) static INTEGRATION_ERROR: CautionKind = CautionKind {
    code: "integration_error",
    meaning: "the integrals by quadrature may be off by more than they should",
    range: Some(TestedRange {
        quantity: "estimate of the error of the integrals over the scale of the forces (–)",
        lower: None,
        upper: Some(LARGEST_INTEGRATION_ERROR),
        source: "the quadrature's own error estimate",
    }),
};

pub(crate) static LOAD_RESIDUAL: CautionKind = CautionKind {
    code: "load_residual",
    meaning: "the normal force is a small difference of large parts, and balances the load no better than this",
    range: Some(TestedRange {
        quantity: "normal force minus load, over the load (–)",
        lower: None,
        upper: Some(LARGEST_LOAD_RESIDUAL),
        source: "the load balance itself",
    }),
};

pub(crate) static LUG_HEIGHT_ASSUMED: CautionKind = CautionKind {
    code: "lug_height_assumed",
    meaning: "the wheel has or may have lugs, but their height is not published; without a lug height it is computed as smooth",
    range: None,
};

pub(crate) static LOW_GRAVITY: CautionKind = CautionKind {
    code: "low_gravity",
    meaning: "the laws of pressure and shear were tested in the Earth's gravity; how the sinkage changes in a lower one is not \
              settled",
    range: Some(TestedRange {
        quantity: "gravity (m/s²)",
        lower: Some(EARTH_GRAVITY),
        upper: None,
        source: "Kobayashi et al. 2010, Wong 2012",
    }),
};

pub(crate) static NEGATIVE_NORMAL_STRESS: CautionKind = CautionKind {
    code: "negative_normal_stress",
    meaning: "load and torque leave a normal stress that pulls, which soil cannot do: they do not belong together at this slip and \
              sinkage",
    range: Some(TestedRange {
        quantity: "normal stress at the peak (Pa)",
        lower: Some(0.0),
        upper: None,
        source: "letter, Eq. 11, solved for the stresses",
    }),
};

pub(crate) static SINKAGE_BEYOND_ESTIMATES: CautionKind = CautionKind {
    code: "sinkage_beyond_estimates",
    meaning: "the wheel sinks deeper than Bekker's estimates were found good for",
    range: Some(TestedRange {
        quantity: "sinkage over diameter (–)",
        lower: None,
        upper: Some(MODERATE_DEPTH),
        source: "Bekker, as reported by Wong, Theory of Ground Vehicles, ch. 2",
    }),
};

pub(crate) static SLIP_GAIN_UNUSED: CautionKind = CautionKind {
    code: "slip_gain_unused",
    meaning: "the sinkage exponent of this soil changes with slip; the estimates are those of its exponent at rest, n0",
    range: None,
};

pub(crate) static PEAK_RULE_SET_ASIDE: CautionKind = CautionKind {
    code: "peak_rule_set_aside",
    meaning: "a braking wheel with two zones has its largest stress where they part; the contact's own rule for that angle is not \
              used at negative slip",
    range: None,
};

pub(crate) static BULLDOZING_LEFT_OUT: CautionKind = CautionKind {
    code: "bulldozing_left_out",
    meaning: "the soil has no unit weight, so the lateral force lacks the soil bulldozed by the side wall",
    range: None,
};

pub(crate) static BULLDOZING_NOT_MOBILISED: CautionKind = CautionKind {
    code: "bulldozing_not_mobilised",
    meaning: "all of the pressure on the side wall is counted, as published, though the wheel moves too little sideways to \
              mobilise half of it",
    range: Some(TestedRange {
        quantity: "mobilised share of the pressure on the side wall (–)",
        lower: Some(SMALLEST_MOBILISED_SHARE),
        upper: None,
        source: "derived here, not published: the share that the shear law mobilises at the sideways displacement; the half is a \
                 choice",
    }),
};
