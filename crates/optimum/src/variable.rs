//! A variable between its bounds. The search runs on its share of the way between them, so that a radius of centimetres and a
//! stiffness of megapascals count alike.

/// What is equally spaced between the bounds.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Spacing {
    /// The value.
    Linear,
    /// Its logarithm.
    Logarithmic,
}

/// A variable and its bounds.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Variable {
    /// The lower bound.
    pub from: f64,
    /// The upper bound.
    pub to: f64,
    /// Where the first search starts; the middle where none is given.
    pub start: Option<f64>,
    /// What is equally spaced.
    pub spacing: Spacing,
}

/// A share this near an end is the end.
const ROUNDING: f64 = 1e-12;

impl Variable {
    /// The value at a share of the way from the lower bound, from 0 to 1.
    #[must_use]
    pub fn at(&self, share: f64) -> f64 {
        let Self { from, to, spacing, .. } = *self;
        let value = match spacing {
            _ if share <= ROUNDING => from,
            _ if share >= 1.0 - ROUNDING => to,
            Spacing::Linear => from * (1.0 - share) + to * share,
            Spacing::Logarithmic => (from.ln() * (1.0 - share) + to.ln() * share).exp(),
        };
        value.clamp(from, to) // rounding may have left the bounds
    }

    /// The share of the way at which the value lies.
    pub(crate) fn share(&self, value: f64) -> f64 {
        let Self { from, to, spacing, .. } = *self;
        let share = match spacing {
            // Halves, because the distance of two bounds may overflow.
            Spacing::Linear => (0.5 * value - 0.5 * from) / (0.5 * to - 0.5 * from),
            Spacing::Logarithmic => (value.ln() - from.ln()) / (to.ln() - from.ln()),
        };
        share.clamp(0.0, 1.0)
    }

    /// Whether there is something to vary, and the start is within.
    pub(crate) fn is_proper(&self) -> bool {
        let Self { from, to, start, spacing } = *self;
        let has_ends = from.is_finite() && to.is_finite() && from < to;
        let has_logarithm = spacing == Spacing::Linear || from > 0.0;
        has_ends && has_logarithm && start.is_none_or(|start| (from..=to).contains(&start))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    const WIDTH: Variable = Variable { from: 0.03, to: 0.3, start: None, spacing: Spacing::Logarithmic };

    #[test]
    fn the_middle_of_a_decade_is_its_geometric_mean_and_the_ends_are_exact() {
        assert!((WIDTH.at(0.5) - 0.009_f64.sqrt()).abs() < 1e-15);
        assert_eq!((WIDTH.at(0.0), WIDTH.at(1.0)), (0.03, 0.3));
        assert_eq!((WIDTH.at(f64::EPSILON), WIDTH.at(1.0 - f64::EPSILON)), (0.03, 0.3));
        assert_eq!((WIDTH.share(0.03), WIDTH.share(0.3)), (0.0, 1.0));
        let linear = Variable { spacing: Spacing::Linear, ..WIDTH };
        assert!((linear.at(0.5) - 0.165).abs() < 1e-15 && (linear.share(0.165) - 0.5).abs() < 1e-15);
    }

    #[test]
    fn bounds_have_to_enclose_something_and_the_start() {
        assert!(WIDTH.is_proper());
        for improper in [
            Variable { to: 0.03, ..WIDTH },
            Variable { from: 0.0, ..WIDTH },
            Variable { from: f64::NAN, ..WIDTH },
            Variable { to: f64::INFINITY, ..WIDTH },
            Variable { start: Some(0.4), ..WIDTH },
            Variable { start: Some(f64::NAN), ..WIDTH },
        ] {
            assert!(!improper.is_proper(), "{improper:?}");
        }
    }
}
