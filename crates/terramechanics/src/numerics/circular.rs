//! Circular functions of half an arc of the contact, and their differences without cancellation.
//!
//! No arc of a contact is longer than π, so half of it needs no reduction of its range: Taylor series up to x²¹ and x²²,
//! whose remainders are below 1e-17 at π/2, give sine, cosine and the difference x − sin x in one go, faster than the
//! library's sine and cosine. The subtraction x − sin x would lose two digits in every decade as x falls; the series does not.

use super::lanes::Arithmetic;

/// Functions of an angle x in |x| ≤ 1.1 π/2.
#[derive(Debug, Clone, Copy)]
pub(crate) struct HalfArc<F = f64> {
    /// sin x.
    pub(crate) sin: F,
    /// 1 − cos x, to full relative precision.
    pub(crate) one_minus_cos: F,
    /// cos x.
    pub(crate) cos: F,
    /// x − sin x, to full relative precision.
    pub(crate) excess: F,
}

/// 1/n! for n from 0 to 22.
const RECIPROCAL_FACTORIALS: [f64; 23] = {
    let mut table = [1.0; 23];
    let (mut n, mut factorial) = (1, 1.0);
    while n < table.len() {
        factorial *= n as f64; // exact up to 22!
        table[n] = 1.0 / factorial;
        n += 1;
    }
    table
};

/// Σ (−1)^k y^k/(first + 2k)! up to the last factorial of the table.
///
/// Terms of even and odd k are summed apart: two short chains of dependent operations instead of a long one.
#[inline(always)]
fn alternating_series<F: Arithmetic>(y: F, first: usize) -> F {
    let square = y * y;
    series_of_every_fourth(square, first) - y * series_of_every_fourth(square, first + 2)
}

/// Σ z^k/(first + 4k)! up to the last factorial of the table, by pairs of terms so that few operations wait for one another. The
/// largest term comes last, so that the roundings of the others stay small beside it.
#[inline(always)]
fn series_of_every_fourth<F: Arithmetic>(z: F, first: usize) -> F {
    let pair = |n: usize| z * RECIPROCAL_FACTORIALS[n + 4] + RECIPROCAL_FACTORIALS[n];
    let z2 = z * z;
    let last = if first + 20 < RECIPROCAL_FACTORIALS.len() {
        z * RECIPROCAL_FACTORIALS[first + 20] + RECIPROCAL_FACTORIALS[first + 16]
    } else {
        z.like(RECIPROCAL_FACTORIALS[first + 16])
    };
    let rest = (z * RECIPROCAL_FACTORIALS[first + 4] + z2 * pair(first + 8)) + z2 * z2 * last;
    rest + RECIPROCAL_FACTORIALS[first]
}

impl<F: Arithmetic> HalfArc<F> {
    /// The functions at `x`.
    #[inline(always)]
    pub(crate) fn of(x: F) -> Self {
        let y = x * x;
        let excess = x * y * alternating_series(y, 3);
        let one_minus_cos = y * alternating_series(y, 2);
        Self { sin: x - excess, one_minus_cos, cos: -one_minus_cos + 1.0, excess }
    }
}

/// Means over an arc of the sine and of 1 − cosine.
#[derive(Debug, Clone, Copy)]
pub(crate) struct ArcMeans<F = f64> {
    /// ⟨sin⟩.
    pub(crate) sin: F,
    /// 1 − ⟨cos⟩, to full relative precision.
    pub(crate) one_minus_cos: F,
}

impl<F: Arithmetic> ArcMeans<F> {
    /// Over the arc from p − x to p + x, with p = `middle` in |p| ≤ π and x = `half` in 0 < x ≤ π/2: ⟨sin⟩ = sin p · sin x/x,
    /// ⟨cos⟩ = cos p · sin x/x.
    #[inline(always)]
    pub(crate) fn over(middle: F, half: F) -> Self {
        let HalfArc { sin, cos, .. } = HalfArc::of(middle * 0.5);
        let one_minus_cos_middle = sin * sin * 2.0;
        let one_minus_sinc = HalfArc::of(half).excess / half;
        Self {
            sin: sin * cos * 2.0 * (-one_minus_sinc + 1.0),
            one_minus_cos: one_minus_cos_middle + one_minus_sinc - one_minus_cos_middle * one_minus_sinc,
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_series_agree_with_the_library() {
        for i in -1000..=1000 {
            let x = std::f64::consts::FRAC_PI_2 * f64::from(i) / 1000.0;
            let arc = HalfArc::of(x);
            assert!((arc.sin - x.sin()).abs() < 3e-16 && (arc.cos - x.cos()).abs() < 3e-16, "{x}");
            assert!((arc.excess - (x - x.sin())).abs() < 3e-16, "{x}");
        }
    }

    #[test]
    fn the_excess_tends_to_its_leading_term() {
        for x in [1e-8, 1e-20, 1e-100] {
            assert!((HalfArc::of(x).excess / (x * x * x / 6.0) - 1.0).abs() < 1e-15);
        }
        assert_eq!(HalfArc::of(0.0).excess, 0.0);
    }

    #[test]
    fn the_means_are_those_of_an_arc() {
        // Mean of cos over [0.2, 0.8] is (sin 0.8 − sin 0.2)/0.6, of sin (cos 0.2 − cos 0.8)/0.6.
        let (a, b) = (0.2_f64, 0.8_f64);
        let means = ArcMeans::over(0.5, 0.3);
        assert!((means.one_minus_cos - (1.0 - (b.sin() - a.sin()) / 0.6)).abs() < 1e-15);
        assert!((means.sin - (a.cos() - b.cos()) / 0.6).abs() < 1e-15);
    }
}
