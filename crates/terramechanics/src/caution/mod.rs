//! Of what does a result warn?
//!
//! A caution changes no number: it names the quantity, its value, the range and who found the range. Each kind is listed in
//! [`Caution::KINDS`], so that a service can tell its users beforehand what it watches.

mod kinds;

pub(crate) use kinds::*;

use std::fmt;

use crate::error::Digits;

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
    /// A name for programs; kinds that say the same of different laws share it.
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

impl Caution {
    /// Everything that is watched.
    pub const KINDS: [&'static CautionKind; 21] = [
        &SMALL_WHEEL,
        &DEEP_SINKAGE,
        &SLIP_BEYOND_FIT,
        &SLIP_BEYOND_OWN_FIT,
        &SLIP_BEYOND_LYASKO,
        &SLIP_BEYOND_LINEAR,
        &SLIP_BEYOND_COUPLED_TESTS,
        &SLIP_GAIN_EXTRAPOLATED,
        &SLIP_SINKAGE_EXTRAPOLATED,
        &LINEAR_SLIP_SINKAGE_EXTRAPOLATED,
        &NEGATIVE_COHESIVE_MODULUS,
        &LOW_GRAVITY,
        &LUG_HEIGHT_ASSUMED,
        &PEAK_RULE_SET_ASIDE,
        &INTEGRATION_ERROR,
        &LOAD_RESIDUAL,
        &NEGATIVE_NORMAL_STRESS,
        &SINKAGE_BEYOND_ESTIMATES,
        &SLIP_GAIN_UNUSED,
        &BULLDOZING_LEFT_OUT,
        &BULLDOZING_NOT_MOBILISED,
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
    pub(crate) fn of(&'static self, value: f64) -> Option<Caution> {
        let caution = Caution { kind: self, value };
        (caution.excess() > 0.0).then_some(caution)
    }

    /// The caution, if what it is about is so.
    pub(crate) fn when(&'static self, is_so: bool) -> Option<Caution> {
        is_so.then_some(Caution { kind: self, value: 0.0 })
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
