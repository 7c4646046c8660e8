//! Of what does a result warn?
//!
//! A caution changes no number. It is data: the quantity, its value, the range, who found the range, and what to do; whoever
//! shows it makes the sentence. Each kind is listed in [`Caution::KINDS`], so that a service can tell its users beforehand what
//! it watches.

/// Declares kinds and lists them, so that none is left out of the list.
macro_rules! kinds {
    ($($name:ident = $kind:expr;)+) => {
        $(pub(crate) static $name: CautionKind = $kind;)+

        /// The kinds of this file.
        pub(super) const KINDS: &[&CautionKind] = &[$(&$name),+];
    };
}

mod grain_kinds;
mod kinds;
mod load_kinds;
mod slip_kinds;

pub(crate) use grain_kinds::{COHESION_LEFT_OUT, MODULI_OF_OTHER_GRAVITY, RESISTIVE_FORCE_BRAKING, ROUGH_CYLINDER};
pub(crate) use kinds::{
    BULLDOZING_LEFT_OUT, BULLDOZING_NOT_MOBILISED, DEEP_SINKAGE, INTEGRATION_ERROR, LOW_GRAVITY, LUG_HEIGHT_ASSUMED,
    NEGATIVE_COHESIVE_MODULUS, PEAK_RULE_SET_ASIDE, SINKAGE_BEYOND_ESTIMATES, SMALL_WHEEL,
};
pub(crate) use load_kinds::{LOAD_RESIDUAL, NEGATIVE_NORMAL_STRESS, NORMAL_FORCE_DRIFTS, TORQUE_AGAINST_SLIP};
pub(crate) use slip_kinds::{
    LINEAR_SLIP_SINKAGE_EXTRAPOLATED, SLIP_BEYOND_COUPLED_TESTS, SLIP_BEYOND_FIT, SLIP_BEYOND_LINEAR, SLIP_BEYOND_LYASKO,
    SLIP_BEYOND_OWN_FIT, SLIP_GAIN_EXTRAPOLATED, SLIP_GAIN_UNUSED, SLIP_SINKAGE_EXTRAPOLATED,
};

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
    /// Everything that is watched.
    pub const KINDS: &'static [&'static CautionKind] = {
        const PARTS: [&[&CautionKind]; 4] = [kinds::KINDS, slip_kinds::KINDS, load_kinds::KINDS, grain_kinds::KINDS];
        const COUNT: usize = PARTS[0].len() + PARTS[1].len() + PARTS[2].len() + PARTS[3].len();
        &joined::<COUNT>(PARTS)
    };

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

/// The kinds of all parts, one after another.
const fn joined<const COUNT: usize>(parts: [&'static [&'static CautionKind]; 4]) -> [&'static CautionKind; COUNT] {
    let mut all = [parts[0][0]; COUNT];
    let (mut part, mut place) = (0, 0);
    while part < parts.len() {
        let mut i = 0;
        while i < parts[part].len() {
            all[place] = parts[part][i];
            place += 1;
            i += 1;
        }
        part += 1;
    }
    all
}
