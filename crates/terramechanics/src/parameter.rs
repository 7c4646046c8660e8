//! What is a number of the model called, in which unit does it come, and which values may it have?
//!
//! Each parameter is declared once, beside the thing that has it: a law's in the file of the law, those of a wheel in `wheel.rs`.
//! All that has parameters implements [`Parametrised`], so that a service, a catalogue or a fit can be made from the tables.

use std::fmt;

/// A number of the model, as it is declared.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Parameter {
    /// Its name for programs, with the SI unit as a suffix where there is a plain one: `shear_modulus_m`.
    pub name: &'static str,
    /// Its symbol in formulas.
    pub symbol: &'static str,
    /// Its unit as a UCUM code, `1` for a number without one. UCUM has no powers that vary: where the unit depends on an
    /// exponent, that stands in parentheses, as in `N/m^(n+1)`.
    pub unit: &'static str,
    /// What it means, in one sentence.
    pub meaning: &'static str,
    /// What physics asks of it.
    pub requirement: Requirement,
    /// Smallest value that a reader of untrusted input should take: far below anything that was ever measured.
    pub least: f64,
    /// Largest such value; itself allowed unless the requirement excludes it.
    pub most: f64,
    /// Whether it has to be there.
    pub presence: Presence,
}

/// Whether a parameter has to be there.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Presence {
    /// Nothing can be computed without it.
    Required,
    /// It may be absent, which has a meaning of its own.
    Optional,
    /// Where it is absent this value is taken.
    Default(f64),
}

/// What a value has to satisfy.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Requirement {
    /// A finite number.
    Finite,
    /// Finite and greater than zero.
    Positive,
    /// Finite and not below zero.
    NotNegative,
    /// Finite and within the closed range.
    Within {
        /// Smallest value allowed.
        min: f64,
        /// Largest value allowed.
        max: f64,
    },
    /// Finite, at least `min` and strictly below `limit`.
    FromUpTo {
        /// Smallest value allowed.
        min: f64,
        /// First value not allowed.
        limit: f64,
    },
}

/// What is made of numbers that are declared in a table.
pub trait Parametrised: Sized {
    /// The table.
    const PARAMETERS: &'static [Parameter];

    /// The thing from its values in the order of the table; none where a required one is absent or their number is wrong.
    /// Whether the values make sense is checked where the thing is put to use.
    fn from_values(values: &[Option<f64>]) -> Option<Self>;

    /// Its values in the order of the table.
    fn values(&self) -> Vec<Option<f64>>;
}

impl Parameter {
    /// Whether the largest value of a reader is itself not allowed.
    #[must_use]
    pub const fn is_open_above(&self) -> bool {
        matches!(self.requirement, Requirement::FromUpTo { limit, .. } if self.most >= limit)
    }

    /// Whether it has to be there.
    #[must_use]
    pub const fn is_required(&self) -> bool {
        matches!(self.presence, Presence::Required)
    }

    /// What is taken where it is absent.
    #[must_use]
    pub const fn default(&self) -> Option<f64> {
        match self.presence {
            Presence::Default(value) => Some(value),
            Presence::Required | Presence::Optional => None,
        }
    }
}

impl Requirement {
    /// Whether `value` satisfies the requirement; a NaN never does.
    #[must_use]
    pub fn holds(&self, value: f64) -> bool {
        value.is_finite()
            && match *self {
                Self::Finite => true,
                Self::Positive => value > 0.0,
                Self::NotNegative => value >= 0.0,
                Self::Within { min, max } => (min..=max).contains(&value),
                Self::FromUpTo { min, limit } => (min..limit).contains(&value),
            }
    }
}

impl fmt::Display for Requirement {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match *self {
            Self::Finite => write!(f, "must be a finite number"),
            Self::Positive => write!(f, "must be greater than 0"),
            Self::NotNegative => write!(f, "must not be negative"),
            Self::Within { min, max } => write!(f, "must be from {min} to {max}"),
            Self::FromUpTo { min, limit } => write!(f, "must be at least {min} and less than {limit}"),
        }
    }
}

/// The values that are there, each with its parameter.
pub(crate) fn present(
    parameters: &'static [Parameter],
    values: Vec<Option<f64>>,
) -> impl Iterator<Item = (&'static Parameter, f64)> {
    parameters.iter().zip(values).filter_map(|(parameter, value)| Some((parameter, value?)))
}
