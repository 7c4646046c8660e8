//! What pull is asked of a wheel, and how does a pull that was found lie to it?

use crate::parameter::{Parameter, Presence, Requirement};

/// A pull that is asked for.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Pull {
    /// Longitudinal force F_x (N).
    Force(f64),
    /// Drawbar coefficient F_x/F_z (–).
    Coefficient(f64),
}

impl Pull {
    /// F_x.
    pub const FORCE: Parameter = Parameter {
        name: "longitudinal_force_n",
        symbol: "F_x",
        unit: "N",
        meaning: "Longitudinal force that the wheel gives; negative where it has to be pulled.",
        requirement: Requirement::Finite,
        least: -1e12,
        most: 1e12,
        presence: Presence::Optional,
    };

    /// F_x/F_z.
    pub const COEFFICIENT: Parameter = Parameter {
        name: "drawbar_coefficient",
        symbol: "F_x/F_z",
        unit: "1",
        meaning: "Longitudinal force that the wheel gives, over its normal force.",
        requirement: Requirement::Finite,
        least: -1e3,
        most: 1e3,
        presence: Presence::Optional,
    };

    /// What may be asked for.
    pub const PARAMETERS: &'static [Parameter] = &[Self::FORCE, Self::COEFFICIENT];

    /// What is asked for, as it is declared.
    #[must_use]
    pub fn parameter(&self) -> &'static Parameter {
        match self {
            Self::Force(_) => &Self::FORCE,
            Self::Coefficient(_) => &Self::COEFFICIENT,
        }
    }

    /// Its value, in the unit of the parameter.
    #[must_use]
    pub fn value(&self) -> f64 {
        match *self {
            Self::Force(value) | Self::Coefficient(value) => value,
        }
    }
}

/// How the pull that came nearest to the value lies to all others.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Nearest {
    /// It is the largest.
    Largest,
    /// It is the least.
    Least,
    /// The pull jumps past the value.
    AtJump,
}

impl Nearest {
    /// In a word for a sentence.
    #[must_use]
    pub fn in_words(self) -> &'static str {
        match self {
            Self::Largest => "the largest",
            Self::Least => "the least",
            Self::AtJump => "the nearest",
        }
    }
}
