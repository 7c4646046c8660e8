//! What an input may be.

use std::fmt;

/// The smallest and the largest number that an input may be; infinite where there is no bound.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Bounds {
    /// The smallest.
    pub lower: f64,
    /// The largest.
    pub upper: f64,
}

impl Bounds {
    /// Any number.
    pub const NONE: Self = Self { lower: f64::NEG_INFINITY, upper: f64::INFINITY };

    pub(crate) fn clamp(self, x: f64) -> f64 {
        x.max(self.lower).min(self.upper)
    }
}

impl fmt::Display for Bounds {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match (self.lower.is_finite(), self.upper.is_finite()) {
            (true, true) => write!(f, "from {} to {}", self.lower, self.upper),
            (true, false) => write!(f, "from {} up", self.lower),
            (false, true) => write!(f, "up to {}", self.upper),
            (false, false) => write!(f, "any number"),
        }
    }
}
