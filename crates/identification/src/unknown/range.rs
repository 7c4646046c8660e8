//! Bounds of a value.

/// A closed range of values.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Range {
    /// Smallest value.
    pub lower: f64,
    /// Largest value.
    pub upper: f64,
}

impl Range {
    /// A range between two values.
    #[must_use]
    pub const fn new(lower: f64, upper: f64) -> Self {
        Self { lower, upper }
    }

    /// Whether both ends are finite and the lower one is below the upper one.
    #[must_use]
    pub fn is_proper(&self) -> bool {
        self.lower.is_finite() && self.upper.is_finite() && self.lower < self.upper
    }

    /// Whether a value is inside.
    #[must_use]
    pub fn contains(&self, value: f64) -> bool {
        (self.lower..=self.upper).contains(&value)
    }

    /// The overlap of two ranges; this one where they do not overlap.
    pub(super) fn shared_with(&self, other: &Self) -> Self {
        let shared = Self::new(self.lower.max(other.lower), self.upper.min(other.upper));
        if shared.is_proper() { shared } else { *self }
    }
}
