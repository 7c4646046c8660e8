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

/// Estimate of the relative integration error above which a result says so.
const LARGEST_INTEGRATION_ERROR: f64 = 1e-9;

/// Residual of the load balance over the load above which a result says so.
const LARGEST_LOAD_RESIDUAL: f64 = 1e-9;

/// A reason to take a result with care.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Caution {
    /// What is watched.
    pub kind: &'static CautionKind,
    /// The value of the quantity, outside the kind's range.
    pub value: f64,
}

/// A quantity that is watched, and the range in which its model was tested.
#[derive(Debug, PartialEq)]
pub struct CautionKind {
    /// A name for programs.
    pub code: &'static str,
    /// The quantity, with its unit in parentheses.
    pub quantity: &'static str,
    /// Lower end of the range.
    pub lower: Option<f64>,
    /// Upper end of the range.
    pub upper: Option<f64>,
    /// What it means to be outside.
    pub meaning: &'static str,
    /// Where the range comes from.
    pub source: &'static str,
}

static SMALL_WHEEL: CautionKind = CautionKind {
    code: "small_wheel",
    quantity: "diameter (m)",
    lower: Some(SMALLEST_DIAMETER),
    upper: None,
    meaning: "Bekker's law was made for large plates and wheels; under small wheels it errs, the law `diameter` corrects for it",
    source: "Meirion-Griffith & Spenko 2011",
};

static DEEP_SINKAGE: CautionKind = CautionKind {
    code: "deep_sinkage",
    quantity: "sinkage over radius (–)",
    lower: None,
    upper: Some(LARGEST_SINKAGE_RATIO),
    meaning: "the wheel sinks deeper than in the tests of the model; the soil that piles up in front is not in it",
    source: "single-wheel tests of Yoshida et al. 2003 (30 mm of 90 mm) and Ding et al. 2011 (27 mm of 157 mm)",
};

static SLIP_BEYOND_FIT: CautionKind = CautionKind {
    code: "slip_beyond_fit",
    quantity: "slip (–)",
    lower: None,
    upper: Some(LARGEST_FITTED_SLIP),
    meaning: "what the sinkage gains with slip was fitted up to this slip and extrapolates beyond",
    source: "Ding et al. 2010, 2011",
};

static SLIP_GAIN_EXTRAPOLATED: CautionKind = CautionKind {
    code: "slip_gain_extrapolated",
    quantity: "slip (–)",
    lower: Some(0.0),
    upper: None,
    meaning: "the slip gain n1 of the sinkage exponent was fitted to driving wheels and is applied to a braking one, for which \
              no n2 is given",
    source: "Ding et al. 2010, 2011",
};

static SLIP_SINKAGE_EXTRAPOLATED: CautionKind = CautionKind {
    code: "slip_sinkage_extrapolated",
    quantity: "slip (–)",
    lower: Some(0.0),
    upper: None,
    meaning: "the slip–sinkage law was fitted to driving wheels and is applied to a braking one",
    source: "Lyasko 2010",
};

static NEGATIVE_COHESIVE_MODULUS: CautionKind = CautionKind {
    code: "negative_cohesive_modulus",
    quantity: "width over −k_c/k_φ (–)",
    lower: Some(SMALLEST_WIDTH_RATIO),
    upper: None,
    meaning: "k_c is negative, an artefact of its fit, and takes more than half of k_φ at this width; the modulus vanishes at 1",
    source: "K_s = k_c/b + k_φ (Bekker 1969), which is 0 at b = −k_c/k_φ",
};

static INTEGRATION_ERROR: CautionKind = CautionKind {
    code: "integration_error",
    quantity: "estimate of the error of the integrals over the scale of the forces (–)",
    lower: None,
    upper: Some(LARGEST_INTEGRATION_ERROR),
    meaning: "the integrals by quadrature may be off by more than they should",
    source: "the quadrature's own error estimate",
};

static LOAD_RESIDUAL: CautionKind = CautionKind {
    code: "load_residual",
    quantity: "normal force minus load, over the load (–)",
    lower: None,
    upper: Some(LARGEST_LOAD_RESIDUAL),
    meaning: "the normal force is a small difference of large parts, and balances the load no better than this",
    source: "the load balance itself",
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
    pub const KINDS: [&'static CautionKind; 8] = [
        &SMALL_WHEEL,
        &DEEP_SINKAGE,
        &SLIP_BEYOND_FIT,
        &SLIP_GAIN_EXTRAPOLATED,
        &SLIP_SINKAGE_EXTRAPOLATED,
        &NEGATIVE_COHESIVE_MODULUS,
        &INTEGRATION_ERROR,
        &LOAD_RESIDUAL,
    ];

    /// How far the value is outside the range, in the unit of the quantity.
    #[must_use]
    pub fn excess(&self) -> f64 {
        let below = self.kind.lower.map_or(0.0, |lower| lower - self.value);
        let above = self.kind.upper.map_or(0.0, |upper| self.value - upper);
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
        let CautionKind { quantity, lower, upper, meaning, source, .. } = self.kind;
        write!(f, "{quantity} is {}", Digits(self.value))?;
        match (lower, upper) {
            (Some(lower), _) if self.value < *lower => write!(f, ", below {}", Digits(*lower))?,
            (_, Some(upper)) => write!(f, ", above {}", Digits(*upper))?,
            _ => {}
        }
        write!(f, " ({source}): {meaning}")
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
        INTEGRATION_ERROR.of(outcome.integration_error),
        LOAD_RESIDUAL.of(residual),
    ]
    .into_iter()
    .flatten()
}
