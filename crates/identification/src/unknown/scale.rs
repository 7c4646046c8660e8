//! On which scale does a fit move a value?

use terramechanics::Step;

use super::Range;

/// The scale on which the fit moves a value, with numbers of about one.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) enum Scale {
    /// value/unit.
    Linear { unit: f64 },
    /// ln value.
    Logarithmic,
}

impl Scale {
    /// The scale of a value that starts at `start` and stays within bounds.
    pub(super) fn of(step: &Step, bounds: &Range, start: f64) -> Self {
        match step {
            Step::Linear(unit) => Self::Linear { unit: *unit },
            Step::OfStart(least) => Self::Linear { unit: start.abs().max(*least) },
            Step::Logarithmic(_) if bounds.lower > 0.0 => Self::Logarithmic,
            Step::Logarithmic(otherwise) => Self::of(otherwise, bounds, start),
        }
    }

    pub(crate) fn inward(self, value: f64) -> f64 {
        match self {
            Self::Linear { unit } => value / unit,
            Self::Logarithmic => value.ln(),
        }
    }

    pub(crate) fn outward(self, scaled: f64) -> f64 {
        match self {
            Self::Linear { unit } => scaled * unit,
            Self::Logarithmic => scaled.exp(),
        }
    }

    /// d value/d scaled.
    pub(crate) fn slope(self, value: f64) -> f64 {
        match self {
            Self::Linear { unit } => unit,
            Self::Logarithmic => value,
        }
    }
}
