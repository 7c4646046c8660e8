//! What is found of one unknown.

use crate::design::DesignGap;
use crate::unknown::Unknown;

/// Which bound an estimate lies at.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Bound {
    /// The lower one.
    Lower,
    /// The upper one.
    Upper,
}

/// What the data tell of one unknown; the gravest finding.
#[derive(Debug, Clone, PartialEq)]
pub enum Identifiability {
    /// It is determined.
    Determined,
    /// The data would have it beyond the bound.
    AtBound,
    /// The data do not change with it.
    WithoutEffect,
    /// It can change together with the others, and the data stay the same.
    Inseparable(Vec<Unknown>),
    /// Only the assumed shape of the stresses tells it from the others at these operating points.
    Unseparated(DesignGap, Vec<Unknown>),
    /// Another start led to a different value that explains the data as well.
    SeveralSolutions {
        /// That value.
        other: f64,
    },
    /// The data bound it from one side alone: that of the bound named.
    OneSided(Bound),
    /// The interval is too wide for the estimate to be of use, or no interval can be stated.
    Uncertain,
}

impl Identifiability {
    /// Whether the data determine the unknown, if need be up to a bound.
    #[must_use]
    pub fn is_determined(&self) -> bool {
        matches!(self, Self::Determined | Self::AtBound)
    }
}

/// What was found of one unknown.
#[derive(Debug, Clone, PartialEq)]
pub struct Estimate {
    /// The unknown.
    pub unknown: Unknown,
    /// Its value.
    pub value: f64,
    /// Standard error; none where the data leave the unknown open or the error overflows. At a bound it is the error without
    /// the bound.
    pub standard_error: Option<f64>,
    /// 95 % interval, not cut at the bounds. Where the data bound the unknown on one side alone, the other end is its bound. None
    /// where an end overflows.
    pub interval: Option<[f64; 2]>,
    /// The bound at which it lies.
    pub at_bound: Option<Bound>,
    /// What the data tell of it.
    pub identifiability: Identifiability,
}
