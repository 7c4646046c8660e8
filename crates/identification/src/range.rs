//! Which numbers can a fit square, multiply and divide without leaving the range of f64?
//!
//! A least-squares fit squares its residuals, sums the squares and divides by products of them. A measured quantity from
//! 1e-100 to 1e100 leaves room for that on both sides, and no measurement comes near either end.

/// Sizes between which the largest value of a measured quantity has to lie.
const SIZES: std::ops::RangeInclusive<f64> = 1e-100..=1e100;

/// The squares of larger residuals and derivatives could overflow when summed.
pub(crate) const LARGEST: f64 = 1e100;

/// What an error message says about numbers beyond the range.
pub(crate) const WORDS: &str = "must be from 1e-100 to 1e100";

/// The largest size among numbers.
pub(crate) fn largest(values: impl IntoIterator<Item = f64>) -> f64 {
    values.into_iter().fold(0.0, |largest, value| largest.max(value.abs()))
}

/// Whether a size can be squared and divided by.
pub(crate) fn is_usable(size: f64) -> bool {
    SIZES.contains(&size)
}

/// Whether the square of a residual or of a derivative can be summed; that of a NaN cannot.
pub(crate) fn is_summable(value: f64) -> bool {
    value.abs() <= LARGEST
}

/// The number, unless it overflowed or is not a number.
pub(crate) fn finite(value: f64) -> Option<f64> {
    value.is_finite().then_some(value)
}

/// The ends of an interval, unless one overflowed or is not a number.
pub(crate) fn finite_ends(ends: [f64; 2]) -> Option<[f64; 2]> {
    ends.iter().all(|end| end.is_finite()).then_some(ends)
}
