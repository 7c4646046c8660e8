//! When does a result leave the range in which its model was tested?
//!
//! A caution changes no number. It is data: the quantity, its value, the range, the source of the range, and what to do. Whoever
//! shows it makes the sentence. [`Caution::KINDS`] lists every kind, so a service can tell its users what it watches.

/// Declares kinds and lists them, so that none is left out of the list; those of one law alone stand with the law.
macro_rules! kinds {
    ($($name:ident $(= $kind:expr)?;)+) => {
        $($(pub(crate) static $name: CautionKind = $kind;)?)+

        /// The kinds of this file.
        pub(super) const KINDS: &[&CautionKind] = &[$(&$name),+];
    };
}

mod grain_kinds;
mod kinds;
mod list;
mod load_kinds;
mod slip_kinds;

pub(crate) use grain_kinds::*;
pub(crate) use kinds::*;
pub(crate) use load_kinds::*;
pub(crate) use slip_kinds::*;

use crate::parameter::Parameter;

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
    /// What it means, in sentences.
    pub meaning: &'static str,
    /// What to do about it, in a sentence.
    pub advice: &'static str,
    /// The input that a user may want to change, where it is one.
    pub parameter: Option<&'static Parameter>,
    /// The range that is left, where it is about one.
    pub range: Option<TestedRange>,
}

/// The range of a quantity in which a model was tested.
#[derive(Debug, PartialEq)]
pub struct TestedRange {
    /// The quantity.
    pub quantity: &'static str,
    /// Its unit, by the Unified Code for Units of Measure; 1 for a ratio.
    pub unit: &'static str,
    /// Lower end.
    pub lower: Option<f64>,
    /// Upper end.
    pub upper: Option<f64>,
    /// Where the range comes from.
    pub source: &'static str,
}

impl Caution {
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
