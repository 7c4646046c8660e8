//! Numbers in lanes: one formula for a single number and for eight side by side.
//!
//! A formula that is written over [`Number`] serves a place of the rim and eight nodes of an integral alike. Eight doubles are one
//! register of AVX-512, two of AVX2 and four of SSE2 or NEON; which of them there are is found when the program runs. Every step is an
//! addition, a multiplication or a division of its own, never a fused one, and sums are formed in one order, so that the lanes give
//! the same bits on each of these machines.
//!
//! What has lanes must be inlined into the function that was compiled for them, hence `inline(always)` throughout.

use super::elementary;
use fearless_simd::prelude::*;
use fearless_simd::{Simd, f64x8};
use std::ops::{Add, Div, Mul, Neg, Sub};

/// Lanes side by side.
pub(crate) const LANES: usize = 8;

/// A number, or one in each lane.
pub(crate) trait Number:
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
    /// e^x for x ≤ 700.
    fn exp(self) -> Self;
    /// ln x of a normal number greater than 0.
    fn ln(self) -> Self;
    /// 1 − e^−x for x ≥ 0, to full relative precision.
    fn saturation(self) -> Self;
    /// What `f` gives for each lane.
    fn by_lane(self, f: impl FnMut(usize) -> f64) -> Self;
    /// The number in a lane.
    fn lane(&self, lane: usize) -> f64;
}

impl Number for f64 {
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
    fn exp(self) -> Self {
        self.exp()
    }

    #[inline(always)]
    fn ln(self) -> Self {
        self.ln()
    }

    #[inline(always)]
    fn saturation(self) -> Self {
        // The subtraction costs one digit at 0.1 and all of them at 0; exp_m1 does not, but takes three times as long.
        if self > 0.1 { 1.0 - (-self).exp() } else { -(-self).exp_m1() }
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

impl<S: Simd> Number for f64x8<S> {
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
    fn exp(self) -> Self {
        elementary::exp(self)
    }

    #[inline(always)]
    fn ln(self) -> Self {
        elementary::ln(self)
    }

    #[inline(always)]
    fn saturation(self) -> Self {
        elementary::saturation(self)
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

/// The sum over the lanes, by halves: in the same order on every machine.
#[inline(always)]
pub(crate) fn sum<S: Simd>(x: f64x8<S>) -> f64 {
    let (low, high) = x.split();
    let (low, high) = (low + high).split();
    let pair = low + high;
    pair[0] + pair[1]
}
