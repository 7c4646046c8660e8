//! When does a result leave the range in which its model was tested?
//!
//! A caution changes no number: it names the quantity, its value, the range and who found the range. Each kind is listed in
//! [`Caution::KINDS`], so that a service can tell its users beforehand what it watches.

use std::fmt;

use crate::error::Digits;
use crate::operation::{Operation, Sinkage};
use crate::pressure_sinkage::PressureSinkage;
use crate::slip::Slip;

/// Smallest diameter (m) for which Bekker's law holds without a correction (Meirion-Griffith & Spenko 2011).
const SMALLEST_DIAMETER: f64 = 0.5;

/// Largest sinkage over radius (–) of the single-wheel tests that the model was compared with: 30 mm under a wheel of 90 mm
/// (Yoshida et al. 2003).
const LARGEST_SINKAGE_RATIO: f64 = 0.3;

/// Largest slip (–) of the tests to which slip gains were fitted (Ding et al. 2010, 2011).
const LARGEST_FITTED_SLIP: f64 = 0.6;

/// Width over the width −k_c/k_φ at which the sinkage modulus vanishes, below which the modulus hangs on the extrapolation
/// of a negative k_c: there it is less than half of k_φ.
const SMALLEST_WIDTH_RATIO: f64 = 2.0;

/// Gravity (m/s²) of the tests, the standard acceleration (3rd General Conference on Weights and Measures, 1901).
const EARTH_GRAVITY: f64 = 9.80665;

/// Estimate of the relative integration error above which a result says so.
const LARGEST_INTEGRATION_ERROR: f64 = 1e-9;

/// Residual of the load balance over the load above which a result says so.
const LARGEST_LOAD_RESIDUAL: f64 = 1e-9;

/// A reason to take a result with care.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Caution {
    /// What is watched.
    pub kind: &'static CautionKind,
    /// The value of the quantity, outside the kind's range; 0 where it has none.
    pub value: f64,
}

/// Something that is watched.
#[derive(Debug, PartialEq)]
pub struct CautionKind {
    /// A name for programs.
    pub code: &'static str,
    /// What it means.
    pub meaning: &'static str,
    /// The range that is left, where it is about one.
    pub range: Option<TestedRange>,
}

/// The range of a quantity in which a model was tested.
#[derive(Debug, PartialEq)]
pub struct TestedRange {
    /// The quantity, with its unit in parentheses.
    pub quantity: &'static str,
    /// Lower end.
    pub lower: Option<f64>,
    /// Upper end.
    pub upper: Option<f64>,
    /// Where the range comes from.
    pub source: &'static str,
}

static SMALL_WHEEL: CautionKind = CautionKind {
    code: "small_wheel",
    meaning: "Bekker's law was made for large plates and wheels; under small wheels it errs, the law `diameter` corrects for it",
    range: Some(TestedRange {
        quantity: "diameter (m)",
        lower: Some(SMALLEST_DIAMETER),
        upper: None,
        source: "Meirion-Griffith & Spenko 2011",
    }),
};

static DEEP_SINKAGE: CautionKind = CautionKind {
    code: "deep_sinkage",
    meaning: "the wheel sinks deeper than in the tests of the model; the soil that piles up in front is not in it",
    range: Some(TestedRange {
        quantity: "sinkage over radius (–)",
        lower: None,
        upper: Some(LARGEST_SINKAGE_RATIO),
        source: "single-wheel tests of Yoshida et al. 2003 (30 mm of 90 mm) and Ding et al. 2011 (27 mm of 157 mm)",
    }),
};

static SLIP_BEYOND_FIT: CautionKind = CautionKind {
    code: "slip_beyond_fit",
    meaning: "what the sinkage gains with slip was fitted up to this slip and extrapolates beyond",
    range: Some(TestedRange {
        quantity: "slip (–)",
        lower: None,
        upper: Some(LARGEST_FITTED_SLIP),
        source: "Ding et al. 2010, 2011",
    }),
};

static SLIP_GAIN_EXTRAPOLATED: CautionKind = CautionKind {
    code: "slip_gain_extrapolated",
    meaning: "the slip gain n1 of the sinkage exponent was fitted to driving wheels and is applied to a braking one, for which \
              no n2 is given",
    range: Some(TestedRange { quantity: "slip (–)", lower: Some(0.0), upper: None, source: "Ding et al. 2010, 2011" }),
};

static SLIP_SINKAGE_EXTRAPOLATED: CautionKind = CautionKind {
    code: "slip_sinkage_extrapolated",
    meaning: "the slip–sinkage law was fitted to driving wheels and is applied to a braking one",
    range: Some(TestedRange { quantity: "slip (–)", lower: Some(0.0), upper: None, source: "Lyasko 2010" }),
};

static NEGATIVE_COHESIVE_MODULUS: CautionKind = CautionKind {
    code: "negative_cohesive_modulus",
    meaning: "k_c is negative, an artefact of its fit, and takes more than half of k_φ at this width; the modulus vanishes at 1",
    range: Some(TestedRange {
        quantity: "width over −k_c/k_φ (–)",
        lower: Some(SMALLEST_WIDTH_RATIO),
        upper: None,
        source: "K_s = k_c/b + k_φ (Bekker 1969), which is 0 at b = −k_c/k_φ",
    }),
};

static INTEGRATION_ERROR: CautionKind = CautionKind {
    code: "integration_error",
    meaning: "the integrals by quadrature may be off by more than they should",
    range: Some(TestedRange {
        quantity: "estimate of the error of the integrals over the scale of the forces (–)",
        lower: None,
        upper: Some(LARGEST_INTEGRATION_ERROR),
        source: "the quadrature's own error estimate",
    }),
};

static LOAD_RESIDUAL: CautionKind = CautionKind {
    code: "load_residual",
    meaning: "the normal force is a small difference of large parts, and balances the load no better than this",
    range: Some(TestedRange {
        quantity: "normal force minus load, over the load (–)",
        lower: None,
        upper: Some(LARGEST_LOAD_RESIDUAL),
        source: "the load balance itself",
    }),
};

static LUG_HEIGHT_ASSUMED: CautionKind = CautionKind {
    code: "lug_height_assumed",
    meaning: "the wheel has or may have lugs, but their height is not published; without a lug height it is computed as smooth",
    range: None,
};

static LOW_GRAVITY: CautionKind = CautionKind {
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

/// What a caution is judged by, besides the operation.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Outcome {
    /// The slip.
    pub slip: Slip,
    /// Sinkage z (m).
    pub sinkage: f64,
    /// Normal force F_z (N), where it is known.
    pub normal: Option<f64>,
    /// Estimate of the relative error of the integrals (–).
    pub integration_error: f64,
}

impl Caution {
    /// Everything that is watched.
    pub const KINDS: [&'static CautionKind; 10] = [
        &SMALL_WHEEL,
        &DEEP_SINKAGE,
        &SLIP_BEYOND_FIT,
        &SLIP_GAIN_EXTRAPOLATED,
        &SLIP_SINKAGE_EXTRAPOLATED,
        &NEGATIVE_COHESIVE_MODULUS,
        &LOW_GRAVITY,
        &LUG_HEIGHT_ASSUMED,
        &INTEGRATION_ERROR,
        &LOAD_RESIDUAL,
    ];

    /// How far the value is outside the range, in the unit of the quantity.
    #[must_use]
    pub fn excess(&self) -> f64 {
        let Some(TestedRange { lower, upper, .. }) = self.kind.range else { return 0.0 };
        let below = lower.map_or(0.0, |lower| lower - self.value);
        let above = upper.map_or(0.0, |upper| self.value - upper);
        below.max(above)
    }
}

impl CautionKind {
    /// The caution, if the value is outside the range.
    fn of(&'static self, value: f64) -> Option<Caution> {
        let caution = Caution { kind: self, value };
        (caution.excess() > 0.0).then_some(caution)
    }
}

impl fmt::Display for Caution {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let CautionKind { meaning, ref range, .. } = *self.kind;
        if let Some(TestedRange { quantity, lower, upper, source }) = range {
            write!(f, "{quantity} is {}", Digits(self.value))?;
            match (lower, upper) {
                (Some(lower), _) if self.value < *lower => write!(f, ", below {}", Digits(*lower))?,
                (_, Some(upper)) => write!(f, ", above {}", Digits(*upper))?,
                _ => {}
            }
            write!(f, " ({source}): ")?;
        }
        f.write_str(meaning)
    }
}

/// The cautions that apply to the outcome of `operation`.
pub fn cautions(operation: &Operation, outcome: &Outcome) -> impl Iterator<Item = Caution> {
    let Operation { system, sinkage, .. } = operation;
    let slip = outcome.slip.ratio();
    let law = system.soil.pressure_sinkage();
    let exponent = law.exponent();
    let is_bekker = matches!(law, PressureSinkage::Bekker(_));
    let from_static = matches!(sinkage, Sinkage::FromStatic { .. });
    let gains = exponent.slip_gain != 0.0;
    let width_ratio = match law {
        PressureSinkage::Bekker(bekker) if bekker.k_c < 0.0 => Some(-system.wheel.width() * bekker.k_phi / bekker.k_c),
        _ => None,
    };
    let residual = match (sinkage, outcome.normal) {
        (Sinkage::CarryingLoad(load), Some(normal)) => (normal - load).abs() / load,
        _ => 0.0,
    };
    [
        is_bekker.then(|| SMALL_WHEEL.of(2.0 * system.wheel.radius())).flatten(),
        DEEP_SINKAGE.of(outcome.sinkage / system.wheel.radius()),
        (gains || from_static).then(|| SLIP_BEYOND_FIT.of(slip)).flatten(),
        (gains && exponent.skid_gain.is_none()).then(|| SLIP_GAIN_EXTRAPOLATED.of(slip)).flatten(),
        from_static.then(|| SLIP_SINKAGE_EXTRAPOLATED.of(slip)).flatten(),
        width_ratio.and_then(|ratio| NEGATIVE_COHESIVE_MODULUS.of(ratio)),
        system.soil.gravity().and_then(|gravity| LOW_GRAVITY.of(gravity)),
        system.wheel.lug_height_is_assumed().then_some(Caution { kind: &LUG_HEIGHT_ASSUMED, value: 0.0 }),
        INTEGRATION_ERROR.of(outcome.integration_error),
        LOAD_RESIDUAL.of(residual),
    ]
    .into_iter()
    .flatten()
}
