//! A place of the rim, with the circular functions that the formulas need.
//!
//! All differences of circular functions are written as products, so that a light wheel on firm ground (z/r = 1e-6) keeps its
//! digits.

use crate::numerics::circular::HalfArc;

/// The entry of a contact, from which the places of the rim are counted.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct RimEntry {
    sin: f64,
    cos: f64,
}

impl RimEntry {
    /// The entry of a contact with `depth_ratio` = z/r: cos θ1 = 1 − z/r. Eq. (3) at θ = 0.
    #[inline]
    pub(crate) fn at_depth(depth_ratio: f64) -> Self {
        Self { sin: (depth_ratio * (2.0 - depth_ratio)).sqrt(), cos: 1.0 - depth_ratio }
    }

    /// cos θ1.
    #[inline]
    pub(crate) fn cos(&self) -> f64 {
        self.cos
    }

    /// The place at an arc δ = θ1 − θ (rad) behind the entry.
    ///
    /// All functions follow from those of the half arc x and of the entry: a = θ1 − x, θ = a − x.
    #[inline]
    pub(crate) fn place(&self, arc: f64) -> RimPoint {
        let half_arc = 0.5 * arc;
        let HalfArc { sin, cos, excess } = HalfArc::of(half_arc);
        let sin_middle = self.sin * cos - self.cos * sin;
        let cos_middle = self.cos * cos + self.sin * sin;
        RimPoint {
            half_arc,
            sin_half_arc: sin,
            excess,
            sin_middle,
            one_minus_cos_middle: sin_middle * sin_middle / (1.0 + cos_middle),
            sin: sin_middle * cos - cos_middle * sin,
            cos: cos_middle * cos + sin_middle * sin,
        }
    }
}

/// A place of the rim, by its arc δ behind the entry, with the circular functions that the formulas need.
#[derive(Debug, Clone, Copy)]
pub(crate) struct RimPoint {
    /// x = δ/2, sin x and x − sin x.
    pub(crate) half_arc: f64,
    pub(crate) sin_half_arc: f64,
    pub(crate) excess: f64,
    /// sin a and 1 − cos a of a = (θ1 + θ)/2.
    pub(crate) sin_middle: f64,
    pub(crate) one_minus_cos_middle: f64,
    /// sin θ.
    pub(crate) sin: f64,
    /// cos θ.
    pub(crate) cos: f64,
}

impl RimPoint {
    /// The arc δ = θ1 − θ (rad) behind the entry.
    #[inline]
    pub(crate) fn arc(&self) -> f64 {
        2.0 * self.half_arc
    }
}
