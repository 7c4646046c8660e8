//! ln x, e^x and 1 − e^−x in lanes, for the arguments that the stresses have.
//!
//! The argument is reduced by a power of two; a series gives the rest, with terms enough that its remainder is below a tenth of an
//! ulp. The errors are measured in the tests: below two ulp over the whole range.

use fearless_simd::prelude::*;
use fearless_simd::{Simd, f64x8, u64x8};

/// ln 2 in two parts. The first has zeros enough at its end that its product with the exponent of a double is exact.
const LN_2: [f64; 2] = [0.693_147_180_369_123_8, 1.908_214_929_270_587_7e-10];

/// 1.5 · 2^52: added to a small number it leaves the nearest integer in the last bits.
const ROUND: f64 = 6_755_399_441_055_744.0;

/// 2^52, and its bits: set above those of a small integer they make it a double.
const TWO_52: f64 = 4_503_599_627_370_496.0;

const MANTISSA_BITS: u32 = 52;
const BIAS: u64 = 1023;
const ONE: u64 = 1.0_f64.to_bits();

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
    let power = ((rounded.bitcast::<u64x8<S>>() + BIAS) << MANTISSA_BITS).bitcast();
    (power, r + r * r * exp_remainder(r))
}

/// (e^r − 1 − r)/r², by pairs of terms so that few operations wait for one another.
#[inline(always)]
fn exp_remainder<S: Simd>(r: f64x8<S>) -> f64x8<S> {
    #[inline(always)]
    fn four<S: Simd>(r: f64x8<S>, r2: f64x8<S>, n: usize) -> f64x8<S> {
        let c = &RECIPROCAL_FACTORIALS;
        (r * c[n + 1] + c[n]) + r2 * (r * c[n + 3] + c[n + 2])
    }
    let r2 = r * r;
    let r4 = r2 * r2;
    four(r, r2, 2) + r4 * (four(r, r2, 6) + r4 * four(r, r2, 10))
}

/// e^x for x ≤ 700.
#[inline(always)]
pub(super) fn exp<S: Simd>(x: f64x8<S>) -> f64x8<S> {
    let lowest = f64x8::splat(x.simd, LOWEST);
    let (power, rest) = reduced(x.simd_lt(lowest).select(lowest, x)); // NaN stays
    power + power * rest
}

/// 1 − e^−x for x ≥ 0, to full relative precision.
#[inline(always)]
pub(super) fn saturation<S: Simd>(x: f64x8<S>) -> f64x8<S> {
    let saturated = f64x8::splat(x.simd, SATURATED);
    let (power, rest) = reduced(-x.simd_gt(saturated).select(saturated, x)); // NaN stays
    (-power + 1.0) - power * rest
}

/// ln x of a normal number greater than 0.
///
/// x = 2^k (1 + f) with 1 + f from √½ to √2, and ln (1 + f) = 2 artanh s = f − s (f − R), s = f/(2 + f), R = 2 (s²/3 + s⁴/5 + …).
#[inline(always)]
pub(super) fn ln<S: Simd>(x: f64x8<S>) -> f64x8<S> {
    const LOWEST_MANTISSA: u64 = std::f64::consts::FRAC_1_SQRT_2.to_bits();
    let shifted = x.bitcast::<u64x8<S>>() + (ONE - LOWEST_MANTISSA);
    let k = ((shifted >> MANTISSA_BITS) | TWO_52.to_bits()).bitcast::<f64x8<S>>() - (TWO_52 + BIAS as f64);
    let mantissa = (shifted & ((1 << MANTISSA_BITS) - 1)) + LOWEST_MANTISSA;
    let f = mantissa.bitcast::<f64x8<S>>() - 1.0;
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
fn pair<S: Simd>(s2: f64x8<S>, n: i32) -> f64x8<S> {
    s2 * (2.0 / f64::from(n + 2)) + 2.0 / f64::from(n)
}

#[cfg(test)]
mod tests {
    use super::*;
    use fearless_simd::{Level, dispatch};

    /// What the lanes give for each of `arguments`.
    fn of(arguments: &[f64], function: Function) -> Vec<f64> {
        let level = Level::new();
        arguments
            .iter()
            .flat_map(|&x| dispatch!(level, simd => <[f64; 8]>::from(function.of(f64x8::splat(simd, x)))).into_iter().take(1))
            .collect()
    }

    #[derive(Clone, Copy)]
    enum Function {
        Exp,
        Ln,
        Saturation,
    }

    impl Function {
        #[inline(always)]
        fn of<S: Simd>(self, x: f64x8<S>) -> f64x8<S> {
            match self {
                Self::Exp => exp(x),
                Self::Ln => ln(x),
                Self::Saturation => saturation(x),
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
