//! How wide is an interval of 95 %? Quantiles of Student's t distribution.
//!
//! For a whole number ν of degrees of freedom the distribution is a finite sum (Abramowitz & Stegun 1964, 26.7.3 and 26.7.4);
//! beyond 200 the expansion in 1/ν (26.7.5) is exact to 1e-9. Between whole numbers, which Welch's approximation gives, the
//! quantile is interpolated in 1/ν, in which it is nearly a straight line.

/// Quantile 0.975 of the normal distribution.
const NORMAL: f64 = 1.959_963_984_540_054;

/// Degrees of freedom beyond which the expansion is taken.
const MANY: f64 = 200.0;

/// t such that a variable of Student's distribution lies within ±t with a probability of 95 %; `freedom` is at least 1.
#[must_use]
pub fn quantile_95(freedom: f64) -> f64 {
    let freedom = freedom.max(1.0);
    if freedom >= MANY {
        return expansion(freedom);
    }
    let (below, above) = (freedom.floor(), freedom.floor() + 1.0);
    let share = (1.0 / below - 1.0 / freedom) / (1.0 / below - 1.0 / above);
    (1.0 - share) * of_whole(below) + share * of_whole(above)
}

fn expansion(freedom: f64) -> f64 {
    let x = NORMAL;
    let terms = [
        (x.powi(3) + x) / 4.0,
        (5.0 * x.powi(5) + 16.0 * x.powi(3) + 3.0 * x) / 96.0,
        (3.0 * x.powi(7) + 19.0 * x.powi(5) + 17.0 * x.powi(3) - 15.0 * x) / 384.0,
        (79.0 * x.powi(9) + 776.0 * x.powi(7) + 1482.0 * x.powi(5) - 1920.0 * x.powi(3) - 945.0 * x) / 92160.0,
    ];
    terms.iter().rev().fold(0.0, |sum, term| (sum + term) / freedom) + x
}

/// Bisection: P(|T| < t) grows with t from 0 at 0, and exceeds 0.95 at 13 even for one degree of freedom.
fn of_whole(freedom: f64) -> f64 {
    let (mut low, mut high) = (1.9, 13.0);
    for _ in 0..60 {
        let middle = 0.5 * (low + high);
        if within(middle, freedom as u32) < 0.95 { low = middle } else { high = middle }
    }
    0.5 * (low + high)
}

/// P(|T| < t) for ν degrees of freedom.
fn within(t: f64, freedom: u32) -> f64 {
    let angle = (t / f64::from(freedom).sqrt()).atan();
    let (sin, cos) = angle.sin_cos();
    let is_odd = freedom % 2 == 1;
    // cos θ (1 + 2/3 cos²θ + …) for odd ν, 1 + 1/2 cos²θ + … for even ν, each up to cos^(ν−2) θ.
    let (mut term, mut power) = if is_odd { (cos, 1) } else { (1.0, 0) };
    let mut sum = 0.0;
    while power + 2 <= freedom {
        sum += term;
        term *= cos * cos * f64::from(power + 1) / f64::from(power + 2);
        power += 2;
    }
    if is_odd { std::f64::consts::FRAC_2_PI * (angle + sin * sum) } else { sin * sum }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Printed tables of t(0.975).
    #[test]
    fn quantiles_are_those_of_the_tables() {
        for (freedom, expected) in [
            (1.0, 12.706),
            (2.0, 4.303),
            (3.0, 3.182),
            (5.0, 2.571),
            (10.0, 2.228),
            (30.0, 2.042),
            (120.0, 1.980),
            (1000.0, 1.962),
            (1e9, 1.960),
        ] {
            assert!((quantile_95(freedom) - expected).abs() < 5.1e-4, "{freedom}: {}", quantile_95(freedom));
        }
    }

    /// ν = 1 and ν = 2 have closed forms: tan(0.475 π), and 0.95 √(2/(1 − 0.95²)).
    #[test]
    fn one_and_two_degrees_of_freedom_are_exact() {
        assert!((quantile_95(1.0) - (0.475 * std::f64::consts::PI).tan()).abs() < 1e-12);
        assert!((quantile_95(2.0) - 0.95 * (2.0_f64 / (1.0 - 0.9025)).sqrt()).abs() < 1e-12);
    }

    #[test]
    fn sum_and_expansion_meet() {
        assert!((of_whole(MANY) - expansion(MANY)).abs() < 1e-9);
        assert!(quantile_95(7.5) < quantile_95(7.0) && quantile_95(7.5) > quantile_95(8.0));
    }
}
