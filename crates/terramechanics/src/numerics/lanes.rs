//! Numbers in lanes: one formula for a single number and for eight side by side.
//!
//! A formula that is written over [`Arithmetic`] serves a place of the rim and eight nodes of an integral alike. Eight doubles are one
//! register of AVX-512, two of AVX2 and four of SSE2 or NEON; which of them there are is found when the program runs. Every step is an
//! addition, a multiplication or a division of its own, never a fused one, and sums are formed in one order, so that the lanes give
//! the same bits on each of these machines.
//!
//! What has lanes must be inlined into the function that was compiled for them, hence `inline(always)` throughout.

use fearless_simd::prelude::*;
use fearless_simd::{Simd, f64x8, u64x8};
use std::ops::{Add, Div, Mul, Neg, Sub};

/// Lanes side by side.
pub(crate) const LANES: usize = 8;

/// What a number, or one in each lane, is reckoned with.
pub(crate) trait Arithmetic:
    Copy
    + Neg<Output = Self>
    + Add<Output = Self>
    + Sub<Output = Self>
    + Mul<Output = Self>
    + Div<Output = Self>
    + Add<f64, Output = Self>
    + Sub<f64, Output = Self>
    + Mul<f64, Output = Self>
{
    /// `value` in each lane.
    fn like(self, value: f64) -> Self;
    /// |x|.
    fn abs(self) -> Self;
    /// |x| with the sign of `sign`.
    fn copysign(self, sign: Self) -> Self;
    /// √x.
    fn sqrt(self) -> Self;
    /// The larger of x and `least`; NaN stays.
    fn at_least(self, least: f64) -> Self;
    /// The smaller of x and `most`; NaN stays.
    fn at_most(self, most: f64) -> Self;
    /// `this` where x ≥ 0, and the `other` elsewhere.
    fn if_not_negative(self, this: Self, other: Self) -> Self;
    /// Whether no number is larger than `most`, nor NaN.
    fn all_at_most(self, most: f64) -> bool;
    /// What `f` gives for each lane.
    fn by_lane(self, f: impl FnMut(usize) -> f64) -> Self;
    /// The number in a lane.
    fn lane(&self, lane: usize) -> f64;
}

/// Numbers that go together with one of kind `K`: the same for all lanes, or with lanes of its own.
pub(crate) trait Beside<K>: Arithmetic + Add<K, Output = Self> + Sub<K, Output = Self> + Mul<K, Output = Self> {}

impl<K, F: Arithmetic + Add<K, Output = F> + Sub<K, Output = F> + Mul<K, Output = F>> Beside<K> for F {}

const MANTISSA_BITS: u32 = 52;
const MANTISSA: u64 = (1 << MANTISSA_BITS) - 1;
const BIAS: u64 = 1023;

/// √½, from which mantissas begin, and how far 1 lies above it in bits.
const LEAST_MANTISSA: u64 = std::f64::consts::FRAC_1_SQRT_2.to_bits();
const TO_ONE: u64 = 1.0_f64.to_bits() - LEAST_MANTISSA;

/// 2^52: its bits set above those of a small integer make it a double.
const TWO_52: f64 = 4_503_599_627_370_496.0;

impl Arithmetic for f64 {
    #[inline(always)]
    fn like(self, value: f64) -> Self {
        value
    }

    #[inline(always)]
    fn abs(self) -> Self {
        self.abs()
    }

    #[inline(always)]
    fn copysign(self, sign: Self) -> Self {
        self.copysign(sign)
    }

    #[inline(always)]
    fn sqrt(self) -> Self {
        self.sqrt()
    }

    #[inline(always)]
    fn at_least(self, least: f64) -> Self {
        if self < least { least } else { self }
    }

    #[inline(always)]
    fn at_most(self, most: f64) -> Self {
        if self > most { most } else { self }
    }

    #[inline(always)]
    fn if_not_negative(self, this: Self, other: Self) -> Self {
        if self >= 0.0 { this } else { other }
    }

    #[inline(always)]
    fn all_at_most(self, most: f64) -> bool {
        self <= most
    }

    #[inline(always)]
    fn by_lane(self, mut f: impl FnMut(usize) -> f64) -> Self {
        f(0)
    }

    #[inline(always)]
    fn lane(&self, _: usize) -> f64 {
        *self
    }
}

impl<S: Simd> Arithmetic for f64x8<S> {
    #[inline(always)]
    fn like(self, value: f64) -> Self {
        Self::splat(self.simd, value)
    }

    #[inline(always)]
    fn abs(self) -> Self {
        self.simd.abs_f64x8(self)
    }

    #[inline(always)]
    fn copysign(self, sign: Self) -> Self {
        self.simd.copysign_f64x8(self, sign)
    }

    #[inline(always)]
    fn sqrt(self) -> Self {
        self.simd.sqrt_f64x8(self)
    }

    #[inline(always)]
    fn at_least(self, least: f64) -> Self {
        let least = Self::splat(self.simd, least);
        self.simd_lt(least).select(least, self)
    }

    #[inline(always)]
    fn at_most(self, most: f64) -> Self {
        let most = Self::splat(self.simd, most);
        self.simd_gt(most).select(most, self)
    }

    #[inline(always)]
    fn if_not_negative(self, this: Self, other: Self) -> Self {
        self.simd_ge(Self::splat(self.simd, 0.0)).select(this, other)
    }

    #[inline(always)]
    fn all_at_most(self, most: f64) -> bool {
        self.simd_le(Self::splat(self.simd, most)).all_true()
    }

    #[inline(always)]
    fn by_lane(self, f: impl FnMut(usize) -> f64) -> Self {
        Self::from_fn(self.simd, f)
    }

    #[inline(always)]
    fn lane(&self, lane: usize) -> f64 {
        self[lane]
    }
}

/// 2^k of a whole number k that lies in the last bits.
#[inline(always)]
pub(super) fn power_of_two<S: Simd>(k: f64x8<S>) -> f64x8<S> {
    ((k.bitcast::<u64x8<S>>() + BIAS) << MANTISSA_BITS).bitcast()
}

/// k and m with x = 2^k m and m from √½ to √2, of a normal number greater than 0.
#[inline(always)]
pub(super) fn exponent_and_mantissa<S: Simd>(x: f64x8<S>) -> (f64x8<S>, f64x8<S>) {
    let shifted = x.bitcast::<u64x8<S>>() + TO_ONE;
    let exponent = ((shifted >> MANTISSA_BITS) | TWO_52.to_bits()).bitcast::<f64x8<S>>() - (TWO_52 + BIAS as f64);
    (exponent, ((shifted & MANTISSA) + LEAST_MANTISSA).bitcast())
}

/// The sum over the lanes, by halves: in the same order on every machine.
#[inline(always)]
pub(crate) fn sum<S: Simd>(x: f64x8<S>) -> f64 {
    let (low, high) = x.split();
    let (low, high) = (low + high).split();
    let pair = low + high;
    pair[0] + pair[1]
}
