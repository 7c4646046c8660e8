//! How firm is the soil under a plate? Bekker (1956, 1969; source 2): p = (k_c/b + k_φ) z^n, with b the smaller side of the plate.
//!
//! Units: k_c in N/m^(n+1), k_φ in N/m^(n+2), so that the moduli of two soils compare at one exponent only. The letter prints
//! them per m^(3+1) and m^(3+2) in the caption of its Fig. 1, which is an error of print (erratum 12).
//!
//! Validity: the law was made for large plates and wheels. Under wheels of less than half a metre in diameter it errs
//! (Meirion-Griffith & Spenko 2011, source 13): see [`Diameter`](super::Diameter).
//!
//! Departures: the exponent may grow with slip, N for n (letter, Eq. 1). The books were not read; the formula is printed in the
//! letter and in the works that use it.

use super::{Plate, SinkageExponent};
use crate::caution::{Caution, CautionKind, TestedRange};
use crate::fittable::{Fittable, Step, Tolerance};
use crate::law::Declared;
use crate::parameter::{Parameter, Parametrised, Presence, Requirement};
use crate::sources::{BEKKER, Citation, LETTER};
use crate::wheel::Wheel;

/// Smallest diameter (m) for which Bekker's law holds without a correction (Meirion-Griffith & Spenko 2011).
const SMALLEST_DIAMETER: f64 = 0.5;

/// Width over the width −k_c/k_φ at which the sinkage modulus vanishes. Below this ratio a negative k_c takes away more than
/// half of k_φ, and the modulus is an extrapolation.
const SMALLEST_WIDTH_RATIO: f64 = 2.0;

pub(crate) static SMALL_WHEEL: CautionKind = CautionKind {
    code: "small_wheel",
    meaning: "Bekker's law was made for large plates and wheels and loses accuracy under small ones.",
    advice: "Use moduli that were fitted to a plate or a wheel of about this size. Where load and sinkage are measured, the \
             coupled forms need no moduli.",
    parameter: Some(&Wheel::RADIUS),
    range: Some(TestedRange {
        quantity: "diameter",
        unit: "m",
        lower: Some(SMALLEST_DIAMETER),
        upper: None,
        source: "Meirion-Griffith & Spenko 2011",
    }),
};

pub(crate) static NEGATIVE_COHESIVE_MODULUS: CautionKind = CautionKind {
    code: "negative_cohesive_modulus",
    meaning: "A negative k_c is an artefact of its fit. At this width it takes away more than half of k_phi, and at a \
              ratio of 1 the modulus vanishes.",
    advice: "Use a k_c that was fitted to plates of this width, or the law `direct`.",
    parameter: Some(&Bekker::K_C),
    range: Some(TestedRange {
        quantity: "width over −k_c/k_φ",
        unit: "1",
        lower: Some(SMALLEST_WIDTH_RATIO),
        upper: None,
        source: "K_s = k_c/b + k_φ (Bekker 1969), which is 0 at b = −k_c/k_φ",
    }),
};

/// Bekker's law: K_s = k_c/b + k_φ.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Bekker {
    /// Cohesive modulus k_c (N/m^(n+1)); may be negative where a fit gave that, as long as K_s stays positive.
    pub k_c: f64,
    /// Frictional modulus k_φ (N/m^(n+2)).
    pub k_phi: f64,
    /// Sinkage exponent.
    pub exponent: SinkageExponent,
}

impl Bekker {
    /// k_c.
    pub const K_C: Parameter = Parameter {
        name: "k_c",
        symbol: "k_c",
        unit: "N/m^(n+1)",
        meaning: "Cohesive modulus; may be negative, an artefact of its fit, as long as the sinkage modulus is positive.",
        requirement: Requirement::Finite,
        least: -1e9,
        most: 1e9,
        presence: Presence::Required,
    };

    /// k_φ.
    pub const K_PHI: Parameter = Parameter {
        name: "k_phi",
        symbol: "k_φ",
        unit: "N/m^(n+2)",
        meaning: "Frictional modulus.",
        requirement: Requirement::Finite,
        least: -1e9,
        most: 1e12,
        presence: Presence::Required,
    };

    /// k_c in a fit. An interval that holds 0 leaves its sign open, unless its effect is slight either way.
    pub const FITTABLE_K_C: Fittable = Fittable {
        parameter: Self::K_C,
        bounds: [-1e8, 1e8],
        usual: [-1e4, 1e5],
        typical: 0.0,
        tolerance: Tolerance::SizeOrShare { share: 0.01, of: Self::K_PHI.name },
        step: Step::OfStart(1e4),
    };

    /// k_φ in a fit.
    pub const FITTABLE_K_PHI: Fittable = Fittable {
        parameter: Self::K_PHI,
        bounds: [1.0, 1e11],
        usual: [3e4, 3e7],
        typical: 1e6,
        tolerance: Tolerance::Size,
        step: Step::Logarithmic(&Step::OfStart(1e4)),
    };

    pub(super) fn exponent(&self) -> SinkageExponent {
        self.exponent
    }

    pub(super) fn sinkage_modulus(&self, plate: &Plate, _exponent: f64) -> f64 {
        self.k_c / plate.width + self.k_phi // letter, caption of Fig. 1
    }

    /// Warns of a small wheel, and of a negative k_c that takes much of the modulus.
    pub(super) fn cautions(&self, plate: &Plate) -> [Option<Caution>; 2] {
        let width_ratio = (self.k_c < 0.0).then(|| -plate.width * self.k_phi / self.k_c);
        [SMALL_WHEEL.of(plate.diameter), width_ratio.and_then(|ratio| NEGATIVE_COHESIVE_MODULUS.of(ratio))]
    }
}

impl Parametrised for Bekker {
    const PARAMETERS: &'static [Parameter] =
        &[Self::K_C, Self::K_PHI, SinkageExponent::BASE, SinkageExponent::SLIP_GAIN, SinkageExponent::SKID_GAIN];

    fn from_values(values: &[Option<f64>]) -> Option<Self> {
        let &[k_c, k_phi, ref exponent @ ..] = values else { return None };
        Some(Self { k_c: k_c?, k_phi: k_phi?, exponent: SinkageExponent::from_values(exponent)? })
    }

    fn values(&self) -> Vec<Option<f64>> {
        [vec![Some(self.k_c), Some(self.k_phi)], self.exponent.values()].concat()
    }
}

impl Declared for Bekker {
    const NAME: &'static str = "bekker";
    const DOC: &'static str = "Bekker's law: a cohesive modulus over the width and a frictional modulus.";
    const FORMULA: &'static str = "K_s = k_c/b + k_phi";
    const SOURCES: &'static [Citation] = &[BEKKER.cited(), LETTER.at("caption of Fig. 1")];
    const FITTABLE: &'static [Fittable] =
        &[Self::FITTABLE_K_C, Self::FITTABLE_K_PHI, SinkageExponent::FITTABLE_BASE, SinkageExponent::FITTABLE_SLIP_GAIN];
}
