//! ln x, e^x, 1 − e^−x and arcsin x, for the arguments that contacts and stresses have.
//!
//! One number takes them from the library. Its tables and branches answer a single question soonest, but have no place in lanes.
//! There the argument is reduced by a power of two, and a series gives the rest, with terms enough that its remainder is below a tenth
//! of an ulp. Both agree within two ulp over the whole range, as the tests measure.

use super::lanes::{Arithmetic, exponent_and_mantissa, power_of_two};
use fearless_simd::{Simd, f64x8};

/// A number, or one in each lane, with the functions that formulas ask for.
pub(crate) trait Number: Arithmetic {
    /// e^x for x ≤ 700.
    fn exp(self) -> Self;
    /// ln x of a normal number greater than 0.
    fn ln(self) -> Self;
    /// 1 − e^−x for x ≥ 0, to full relative precision.
    fn saturation(self) -> Self;
    /// arcsin x for x² ≤ 0.6.
    fn arcsin(self) -> Self;
    /// arcsin √y for y from 0 to 0.6.
    fn arcsin_root(self) -> Self;
}

impl Number for f64 {
    #[inline(always)]
    fn exp(self) -> Self {
        self.exp()
    }

    #[inline(always)]
    fn ln(self) -> Self {
        self.ln()
    }

    #[inline(always)]
    fn saturation(self) -> Self {
        // Where 1 outweighs e^−x nothing cancels, and the plain exponential is the faster one.
        if self > std::f64::consts::LN_2 { 1.0 - (-self).exp() } else { -(-self).exp_m1() }
    }

    #[inline(always)]
    fn arcsin(self) -> Self {
        self.asin()
    }

    #[inline(always)]
    fn arcsin_root(self) -> Self {
        self.sqrt().asin()
    }
}

impl<S: Simd> Number for f64x8<S> {
    #[inline(always)]
    fn exp(self) -> Self {
        exp(self)
    }

    #[inline(always)]
    fn ln(self) -> Self {
        ln(self)
    }

    #[inline(always)]
    fn saturation(self) -> Self {
        saturation(self)
    }

    #[inline(always)]
    fn arcsin(self) -> Self {
        self + self * arcsin_excess(self * self)
    }

    #[inline(always)]
    fn arcsin_root(self) -> Self {
        let root = Arithmetic::sqrt(self);
        root + root * arcsin_excess(self) // the rounding of the root stays out of the series
    }
}

/// ln 2 in two parts. The first has zeros enough at its end that its product with the exponent of a double is exact.
const LN_2: [f64; 2] = [0.693_147_180_369_123_8, 1.908_214_929_270_587_7e-10];

/// 1.5 · 2^52: added to a small number it leaves the nearest integer in the last bits.
const ROUND: f64 = 6_755_399_441_055_744.0;

/// Below this e^x is no normal number, and next to nothing beside any other.
const LOWEST: f64 = -708.0;

/// Above this e^−x is less than half an ulp of 1.
const SATURATED: f64 = 40.0;

/// 1/n!, of n from 0.
const RECIPROCAL_FACTORIALS: [f64; 14] = {
    let mut table = [1.0; 14];
    let (mut n, mut factorial) = (1, 1.0);
    while n < table.len() {
        factorial *= n as f64;
        table[n] = 1.0 / factorial;
        n += 1;
    }
    table
};

/// x = k ln 2 + r with |r| ≤ ln 2/2: 2^k and e^r − 1.
#[inline(always)]
fn reduced<S: Simd>(x: f64x8<S>) -> (f64x8<S>, f64x8<S>) {
    let rounded = x * std::f64::consts::LOG2_E + ROUND;
    let k = rounded - ROUND;
    let r = (x - k * LN_2[0]) - k * LN_2[1];
    (power_of_two(rounded), r + r * r * exp_remainder(r))
}

/// (e^r − 1 − r)/r², by pairs of terms so that few operations wait for one another.
#[inline(always)]
fn exp_remainder<F: Arithmetic>(r: F) -> F {
    let (r2, c) = (r * r, &RECIPROCAL_FACTORIALS);
    let r4 = r2 * r2;
    four_terms(c, 2, r, r2) + r4 * (four_terms(c, 6, r, r2) + r4 * four_terms(c, 10, r, r2))
}

/// c_n + c_(n+1) x + c_(n+2) x² + c_(n+3) x³.
#[inline(always)]
fn four_terms<F: Arithmetic>(c: &[f64], n: usize, x: F, x2: F) -> F {
    (x * c[n + 1] + c[n]) + x2 * (x * c[n + 3] + c[n + 2])
}

#[inline(always)]
fn exp<S: Simd>(x: f64x8<S>) -> f64x8<S> {
    let (power, rest) = reduced(x.at_least(LOWEST));
    power + power * rest
}

#[inline(always)]
fn saturation<S: Simd>(x: f64x8<S>) -> f64x8<S> {
    let (power, rest) = reduced(-x.at_most(SATURATED));
    (-power + 1.0) - power * rest
}

/// x = 2^k (1 + f) with 1 + f from √½ to √2, and ln (1 + f) = 2 artanh s = f − s (f − R), s = f/(2 + f), R = 2 (s²/3 + s⁴/5 + …).
#[inline(always)]
fn ln<S: Simd>(x: f64x8<S>) -> f64x8<S> {
    let (k, mantissa) = exponent_and_mantissa(x);
    let f = mantissa - 1.0;
    let s = f / (f + 2.0);
    let s2 = s * s;
    let s4 = s2 * s2;
    let s8 = s4 * s4;
    let series = s2 * ((pair(s2, 3) + s4 * pair(s2, 7)) + s8 * ((pair(s2, 11) + s4 * pair(s2, 15)) + s8 * pair(s2, 19)));
    let half_square = f * f * 0.5;
    k * LN_2[0] - ((half_square - (s * (half_square + series) + k * LN_2[1])) - f)
}

/// Two terms 2/n + 2 s²/(n + 2) of the series of 2 artanh s.
#[inline(always)]
fn pair<F: Arithmetic>(s2: F, n: i32) -> F {
    s2 * (2.0 / f64::from(n + 2)) + 2.0 / f64::from(n)
}

/// (arcsin √y/√y − 1)/y as a polynomial in 0 ≤ y ≤ 0.6, through the function at its Chebyshev nodes, found at 80 digits: with these
/// coefficients arcsin √y is off by less than 1e-17 of itself.
const ARCSIN: [f64; 24] = [
    0.166_666_666_666_666_66,
    0.074_999_999_999_994_34,
    0.044_642_857_144_514_575,
    0.030_381_944_252_033_867,
    0.022_372_170_915_836_02,
    0.017_352_319_408_008_722,
    0.013_976_033_173_175_577,
    0.011_352_761_851_029_625,
    0.012_367_621_371_947_232,
    -0.017_444_567_697_797_866,
    0.205_228_924_264_478_28,
    -1.182_296_094_344_996_5,
    5.658_439_186_488_941,
    -21.395_874_255_399_59,
    64.628_617_732_915_06,
    -155.290_816_142_879,
    294.953_743_414_131_34,
    -437.149_411_100_898_65,
    495.072_318_635_138_8,
    -413.959_041_053_627_5,
    241.100_471_365_309,
    -87.479_728_444_721_12,
    14.939_418_818_370_358,
    0.0,
];

/// arcsin x/x − 1 at y = x².
#[inline(always)]
fn arcsin_excess<F: Arithmetic>(y: F) -> F {
    let (y2, c) = (y * y, &ARCSIN);
    let y4 = y2 * y2;
    let y8 = y4 * y4;
    let low = four_terms(c, 0, y, y2) + y4 * four_terms(c, 4, y, y2);
    let middle = four_terms(c, 8, y, y2) + y4 * four_terms(c, 12, y, y2);
    let high = four_terms(c, 16, y, y2) + y4 * four_terms(c, 20, y, y2);
    y * (low + y8 * (middle + y8 * high))
}

#[cfg(test)]
mod tests {
    use super::*;
    use fearless_simd::prelude::*;
    use fearless_simd::{Level, dispatch, f64x8};

    /// What the function gives for each of `arguments` in lanes.
    fn of(arguments: &[f64], function: Function) -> Vec<f64> {
        let level = Level::new();
        let in_a_lane = |&x: &f64| {
            let [first, ..] = dispatch!(level, simd => <[f64; 8]>::from(function.of(f64x8::splat(simd, x))));
            first
        };
        arguments.iter().map(in_a_lane).collect()
    }

    #[derive(Clone, Copy)]
    enum Function {
        Exp,
        Ln,
        Saturation,
        Arcsin,
        ArcsinRoot,
    }

    impl Function {
        #[inline(always)]
        fn of<F: Number>(self, x: F) -> F {
            match self {
                Self::Exp => Number::exp(x),
                Self::Ln => Number::ln(x),
                Self::Saturation => x.saturation(),
                Self::Arcsin => x.arcsin(),
                Self::ArcsinRoot => x.arcsin_root(),
            }
        }
    }

    /// Largest difference from `library` in ulp of it. The library's own functions are within one ulp.
    fn largest_error(arguments: &[f64], function: Function, library: impl Fn(f64) -> f64) -> f64 {
        let error = |(&x, found): (&f64, f64)| {
            let expected = library(x);
            let ulp = (expected.abs().next_up() - expected.abs()).max(f64::MIN_POSITIVE);
            (found - expected).abs() / ulp
        };
        arguments.iter().zip(of(arguments, function)).map(error).fold(0.0, f64::max)
    }

    /// Powers of ten between two, and as many numbers evenly between the same two.
    fn spread(least: f64, most: f64) -> Vec<f64> {
        let share = |i: i32| f64::from(i) / 20_000.0;
        let logarithmic = (0..=20_000).map(|i| least * (most / least).powf(share(i)));
        let linear = (0..=20_000).map(|i| least + (most - least) * share(i));
        logarithmic.chain(linear).filter(|x| (least..=most).contains(x)).collect()
    }

    #[test]
    fn the_functions_are_within_two_ulp_of_the_library() {
        let positive = spread(1e-300, 1e300);
        let negative: Vec<f64> = spread(1e-20, 700.0).iter().map(|x| -x).collect();
        assert!(largest_error(&positive, Function::Ln, f64::ln) <= 2.0);
        assert!(largest_error(&spread(0.4, 2.5), Function::Ln, f64::ln) <= 2.0);
        assert!(largest_error(&negative, Function::Exp, f64::exp) <= 2.0);
        assert!(largest_error(&spread(1e-20, 700.0), Function::Exp, f64::exp) <= 2.0);
        assert!(largest_error(&spread(1e-300, 1e6), Function::Saturation, |x| -(-x).exp_m1()) <= 2.0);
        assert!(largest_error(&spread(1e-3, 50.0), Function::Saturation, |x| -(-x).exp_m1()) <= 2.0);
    }

    #[test]
    fn the_arcsine_of_a_root_is_within_two_ulp_of_the_library() {
        let library = |y: f64| {
            let root = y.sqrt();
            let rounded_off = (-root).mul_add(root, y) / (2.0 * root); // what the root fell short by
            root.asin() + rounded_off / (1.0 - y).sqrt()
        };
        assert!(largest_error(&spread(1e-30, 0.6), Function::ArcsinRoot, library) <= 2.0);
        assert!(largest_error(&spread(1e-15, 0.77), Function::Arcsin, f64::asin) <= 2.0);
        assert_eq!(of(&[0.0], Function::ArcsinRoot), [0.0]);
    }

    /// One number has what its lane would have.
    #[test]
    fn one_number_has_the_same_functions() {
        let same = |arguments: &[f64], function: Function| largest_error(arguments, function, |x| function.of(x)) <= 2.0;
        assert!(same(&spread(1e-300, 1e300), Function::Ln));
        assert!(same(&spread(1e-20, 700.0), Function::Exp));
        assert!(same(&spread(1e-300, 50.0), Function::Saturation));
        assert!(same(&spread(1e-15, 0.77), Function::Arcsin));
        assert!(same(&spread(1e-30, 0.6), Function::ArcsinRoot));
    }

    #[test]
    fn the_ends_of_the_range_are_met() {
        assert_eq!(of(&[0.0, f64::INFINITY], Function::Saturation), [0.0, 1.0]);
        assert_eq!(of(&[0.0], Function::Exp), [1.0]);
        assert_eq!(of(&[1.0], Function::Ln), [0.0]);
        assert!(of(&[f64::NEG_INFINITY, -1e9], Function::Exp).iter().all(|&e| (0.0..1e-300).contains(&e)));
        for function in [Function::Exp, Function::Saturation] {
            assert!(of(&[f64::NAN], function)[0].is_nan());
        }
    }
}
