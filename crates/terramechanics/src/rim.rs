//! A place of the rim, with the circular functions that the formulas need.
//!
//! All differences of circular functions are written as products, or as differences of small numbers that do not cancel, so that a
//! light wheel on firm ground (z/r = 1e-6) keeps its digits.

use crate::numerics::circular::HalfArc;
use crate::numerics::elementary::Number;
use crate::numerics::lanes::Beside;

/// The entry of a contact, from which the places of the rim are counted.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct RimEntry<K = f64> {
    sin: K,
    cos: K,
    /// z/r = 1 − cos θ1.
    depth_ratio: K,
}

impl<K: Number> RimEntry<K> {
    /// The entry of a contact with `depth_ratio` = z/r: cos θ1 = 1 − z/r. Eq. (3) at θ = 0.
    #[inline(always)]
    pub(crate) fn at_depth(depth_ratio: K) -> Self {
        Self { sin: (depth_ratio * (-depth_ratio + 2.0)).sqrt(), cos: -depth_ratio + 1.0, depth_ratio }
    }

    /// sin θ1.
    #[inline(always)]
    pub(crate) fn sin(&self) -> K {
        self.sin
    }

    /// cos θ1.
    #[inline(always)]
    pub(crate) fn cos(&self) -> K {
        self.cos
    }

    /// The place at an arc δ = θ1 − θ (rad) behind the entry.
    ///
    /// All functions follow from those of the half arc x and of the entry: a = θ1 − x, θ = a − x.
    #[inline(always)]
    pub(crate) fn place<F: Beside<K>>(&self, arc: F) -> RimPoint<F> {
        let half_arc = arc * 0.5;
        let HalfArc { sin, one_minus_cos, cos, excess } = HalfArc::of(half_arc);
        let sin_middle = cos * self.sin - sin * self.cos;
        let cos_middle = cos * self.cos + sin * self.sin;
        // 1 − cos a = (1 − cos θ1) + cos θ1 (1 − cos x) − sin θ1 sin x.
        let one_minus_cos_middle = one_minus_cos * self.cos - sin * self.sin + self.depth_ratio;
        RimPoint {
            half_arc,
            lag: excess + sin * one_minus_cos_middle,
            rise: sin_middle * sin,
            sin: sin_middle * cos - cos_middle * sin,
            cos: cos_middle * cos + sin_middle * sin,
        }
    }
}

impl RimEntry {
    /// The place at `angle` θ (rad), where that is a part of θ1 = `entry` (rad) not near to the whole.
    ///
    /// sin θ1 − sin θ and cos θ − cos θ1 follow from θ − sin θ and 1 − cos θ, which are small beside those of the entry.
    #[inline(always)]
    pub(crate) fn place_at<F: Number>(&self, entry: &EntryArc, angle: F) -> RimPoint<F> {
        let HalfArc { sin, one_minus_cos, cos, excess } = HalfArc::of(angle);
        RimPoint {
            half_arc: (-angle + entry.angle) * 0.5,
            lag: (-excess + entry.excess) * 0.5,
            rise: (-one_minus_cos + self.depth_ratio) * 0.5,
            sin,
            cos,
        }
    }
}

/// The entry angle as places far behind it need it.
#[derive(Debug, Clone, Copy)]
pub(crate) struct EntryArc {
    /// θ1 (rad) and θ1 − sin θ1.
    angle: f64,
    excess: f64,
}

impl EntryArc {
    /// Of an entry at `angle` θ1 (rad).
    #[inline(always)]
    pub(crate) fn of(angle: f64) -> Self {
        Self { angle, excess: HalfArc::of(angle).excess }
    }
}

/// A place of the rim, by its arc δ behind the entry, with the circular functions that the formulas need.
#[derive(Debug, Clone, Copy)]
pub(crate) struct RimPoint<F = f64> {
    /// δ/2.
    pub(crate) half_arc: F,
    /// (δ − sin θ1 + sin θ)/2 = (x − sin x) + sin x (1 − cos a), with the half arc x = δ/2 and the middle a = (θ1 + θ)/2.
    pub(crate) lag: F,
    /// (cos θ − cos θ1)/2 = sin a sin x.
    pub(crate) rise: F,
    /// sin θ.
    pub(crate) sin: F,
    /// cos θ.
    pub(crate) cos: F,
}

impl<F: Number> RimPoint<F> {
    /// The arc δ = θ1 − θ (rad) behind the entry.
    #[inline(always)]
    pub(crate) fn arc(&self) -> F {
        self.half_arc * 2.0
    }

    /// What `f` gives at the place of each lane: for a formula without lanes.
    #[inline(always)]
    pub(crate) fn by_lane(&self, mut f: impl FnMut(&RimPoint) -> f64) -> F {
        let Self { half_arc, lag, rise, sin, cos } = *self;
        half_arc.by_lane(|i| {
            let (half_arc, lag, rise) = (half_arc.lane(i), lag.lane(i), rise.lane(i));
            f(&RimPoint { half_arc, lag, rise, sin: sin.lane(i), cos: cos.lane(i) })
        })
    }
}
