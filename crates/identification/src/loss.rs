//! How much does a residual count? Its square, or less than that for an outlier (Huber 1981, Robust Statistics).
//!
//! With u the residual in units of its scale, least squares on v = sgn(u) √ρ(u) minimise the sum of ρ(u). Near zero
//! every loss is u². The tuning constants are those that keep 95 % of the efficiency where the noise is normal (Holland &
//! Welsch 1977 for Huber and Cauchy); soft L1 takes 1, where it turns from squares to absolute values.

/// What a residual costs.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum Loss {
    /// u².
    #[default]
    LeastSquares,
    /// u² up to a = 1.345, then straight: 2 a |u| − a².
    Huber,
    /// 2 (√(1 + u²) − 1).
    SoftL1,
    /// a² ln(1 + (u/a)²) with a = 2.385.
    Cauchy,
}

/// Where Huber's loss turns straight.
const HUBER: f64 = 1.345;
/// The scale of Cauchy's loss.
const CAUCHY: f64 = 2.385;

/// A residual as the least-squares method sees it.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Transformed {
    /// v = sgn(u) √ρ(u).
    pub(crate) value: f64,
    /// dv/du.
    pub(crate) slope: f64,
}

impl Loss {
    /// ρ(u).
    #[must_use]
    pub fn of(self, u: f64) -> f64 {
        match self {
            Self::LeastSquares => u * u,
            Self::Huber if u.abs() <= HUBER => u * u,
            Self::Huber => HUBER * (2.0 * u.abs() - HUBER),
            // √(1 + u²) − 1 without cancellation.
            Self::SoftL1 => 2.0 * u * u / (1.0 + u.hypot(1.0)),
            Self::Cauchy => CAUCHY * CAUCHY * (u / CAUCHY).powi(2).ln_1p(),
        }
    }

    /// ψ(u) = ρ'(u)/2.
    #[must_use]
    pub fn influence(self, u: f64) -> f64 {
        match self {
            Self::LeastSquares => u,
            Self::Huber => u.clamp(-HUBER, HUBER),
            Self::SoftL1 => u / u.hypot(1.0),
            Self::Cauchy => u / (1.0 + (u / CAUCHY).powi(2)),
        }
    }

    /// ψ'(u).
    #[must_use]
    pub fn curvature(self, u: f64) -> f64 {
        match self {
            Self::LeastSquares => 1.0,
            Self::Huber => f64::from(u.abs() <= HUBER),
            Self::SoftL1 => u.hypot(1.0).powi(-3),
            Self::Cauchy => {
                let share = (u / CAUCHY).powi(2);
                if share.is_infinite() {
                    return 0.0; // the limit
                }
                (1.0 - share) / (1.0 + share).powi(2)
            }
        }
    }

    pub(crate) fn transformed(self, u: f64) -> Transformed {
        if self == Self::LeastSquares {
            return Transformed { value: u, slope: 1.0 };
        }
        let size = self.of(u).sqrt();
        let slope = if size > 0.0 { self.influence(u).abs() / size } else { 1.0 };
        Transformed { value: size.copysign(u), slope }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    const ROBUST: [Loss; 3] = [Loss::Huber, Loss::SoftL1, Loss::Cauchy];

    #[test]
    fn every_loss_is_a_square_near_zero_and_less_far_away() {
        for loss in ROBUST {
            assert!((loss.of(1e-4) / 1e-8 - 1.0).abs() < 1e-7, "{loss:?}");
            assert!(loss.of(30.0) < 0.2 * 900.0 && loss.of(30.0) > 1.0, "{loss:?}");
        }
    }

    /// Derivatives against differences of the functions they belong to.
    #[test]
    fn influence_curvature_and_slope_are_the_derivatives() {
        const STEP: f64 = 1e-6;
        for loss in ROBUST {
            for u in [-7.0, -1.0, -0.1, 0.3, 1.2, 5.0] {
                let difference = |f: &dyn Fn(f64) -> f64| (f(u + STEP) - f(u - STEP)) / (2.0 * STEP);
                assert!((0.5 * difference(&|u| loss.of(u)) - loss.influence(u)).abs() < 1e-8);
                assert!((difference(&|u| loss.influence(u)) - loss.curvature(u)).abs() < 1e-8);
                assert!((difference(&|u| loss.transformed(u).value) - loss.transformed(u).slope).abs() < 1e-8);
                assert!((loss.transformed(u).value.powi(2) - loss.of(u)).abs() < 1e-13);
            }
        }
    }

    #[test]
    fn hubers_loss_is_continuous_where_it_turns_straight() {
        let (below, above) = (Loss::Huber.of(HUBER), Loss::Huber.of(HUBER.next_up()));
        assert!((below - above).abs() < 1e-14);
    }
}
