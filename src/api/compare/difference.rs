//! How far columns are apart.

use serde::Serialize;
use utoipa::ToSchema;

/// The difference of a column from a reference over the rows in which both have a value; null where there are none.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, ToSchema)]
pub(super) struct Difference {
    /// Root of the mean square.
    rms: Option<f64>,
    /// Largest absolute value.
    max_abs: Option<f64>,
    /// Mean with its sign: positive where the reference is lower.
    mean: Option<f64>,
    /// The rms over that of the reference (–); null where that is zero.
    relative: Option<f64>,
    /// Rows in which both have a value.
    rows: usize,
}

/// The highest minus the lowest of several columns over the rows in which all have a value; null where there are none.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, ToSchema)]
pub(super) struct Spread {
    /// Root of the mean square.
    rms: Option<f64>,
    /// Largest value.
    max_abs: Option<f64>,
    /// The rms over that of the first series (–); null where that is zero.
    relative: Option<f64>,
    /// Rows in which all have a value.
    rows: usize,
}

impl Difference {
    pub(super) fn between(column: &[f64], reference: &[f64]) -> Self {
        let pairs = column.iter().zip(reference).filter(|(a, b)| (*a - *b).is_finite());
        let (differences, references): (Vec<f64>, Vec<f64>) = pairs.map(|(a, b)| (a - b, *b)).unzip();
        let rms = root_mean_square(&differences);
        Self {
            rms,
            max_abs: largest(&differences),
            mean: mean(&differences),
            relative: share(rms, root_mean_square(&references)),
            rows: differences.len(),
        }
    }
}

impl Spread {
    /// That of columns of one length, the first of which is the reference.
    pub(super) fn of(columns: &[&[f64]]) -> Self {
        let rows = columns.first().map_or(0, |first| first.len());
        let (mut spreads, mut references) = (Vec::new(), Vec::new());
        for row in 0..rows {
            let values = || columns.iter().map(|column| column[row]);
            // A maximum passes over NaN, so a row in which a value is missing is looked for.
            let spread = values().fold(f64::NEG_INFINITY, f64::max) - values().fold(f64::INFINITY, f64::min);
            if values().all(f64::is_finite) && spread.is_finite() {
                spreads.push(spread);
                references.push(columns[0][row]);
            }
        }
        let rms = root_mean_square(&spreads);
        let relative = share(rms, root_mean_square(&references));
        Self { rms, max_abs: largest(&spreads), relative, rows: spreads.len() }
    }
}

fn largest(values: &[f64]) -> Option<f64> {
    values.iter().map(|value| value.abs()).reduce(f64::max)
}

/// Scaled by the largest, so that the squares neither overflow nor vanish.
fn root_mean_square(values: &[f64]) -> Option<f64> {
    let scale = largest(values)?;
    let squares: f64 = values.iter().map(|value| (value / scale.max(f64::MIN_POSITIVE)).powi(2)).sum();
    Some(scale * (squares / values.len() as f64).sqrt())
}

/// Divided before they are summed, so that the sum does not overflow.
fn mean(values: &[f64]) -> Option<f64> {
    let count = values.len() as f64;
    (!values.is_empty()).then(|| values.iter().map(|value| value / count).sum())
}

fn share(part: Option<f64>, whole: Option<f64>) -> Option<f64> {
    Some(part? / whole?).filter(|share| share.is_finite())
}

#[cfg(test)]
mod tests {
    use super::*;

    const NONE: f64 = f64::NAN;

    fn is_near(found: Option<f64>, expected: f64) {
        let found = found.expect("a value");
        assert!((found - expected).abs() < 1e-15 * expected.abs(), "{found}, not {expected}");
    }

    #[test]
    fn differences_are_taken_where_both_have_a_value() {
        // 0, −3 and 4 from 1, 5 and 4.
        let difference = Difference::between(&[1.0, 2.0, NONE, 8.0, 1.0], &[1.0, 5.0, 3.0, 4.0, NONE]);
        assert_eq!((difference.max_abs, difference.rows), (Some(4.0), 3));
        is_near(difference.rms, (25.0_f64 / 3.0).sqrt());
        is_near(difference.mean, 1.0 / 3.0);
        is_near(difference.relative, (25.0_f64 / 42.0).sqrt());
    }

    #[test]
    fn what_is_undefined_has_no_number() {
        let none = Difference { rms: None, max_abs: None, mean: None, relative: None, rows: 0 };
        assert_eq!(Difference::between(&[NONE], &[1.0]), none);
        let equal = Difference { rms: Some(0.0), max_abs: Some(0.0), mean: Some(0.0), relative: Some(0.0), rows: 1 };
        assert_eq!(Difference::between(&[2.0], &[2.0]), equal);
        assert_eq!(Difference::between(&[0.0], &[0.0]), Difference { relative: None, ..equal });
        assert_eq!(Difference::between(&[1.0], &[0.0]).relative, None);
        let huge = Difference::between(&[1e300, 1e300], &[-1e300, 1.0]);
        assert!(huge.rms.is_some_and(f64::is_finite) && huge.mean.is_some_and(f64::is_finite));
    }

    #[test]
    fn the_spread_is_of_the_rows_that_all_have() {
        // 3 and 4 beside 1 and 2 of the first.
        let spread = Spread::of(&[&[1.0, 2.0, 5.0], &[2.0, 6.0, NONE], &[-1.0, 3.0, 9.0]]);
        assert_eq!((spread.max_abs, spread.rows), (Some(4.0), 2));
        is_near(spread.rms, (25.0_f64 / 2.0).sqrt());
        is_near(spread.relative, 5.0_f64.sqrt());
        assert_eq!(Spread::of(&[&[NONE]]), Spread { rms: None, max_abs: None, relative: None, rows: 0 });
    }
}
