//! How far has the soil been sheared in the two zones of a braking wheel? Wong & Reece 1967, part II, source 21.
//!
//! | quantity | here |
//! |---|---|
//! | ahead of θ0: j = r κ [(θ1 − θ) (sin θ1 − sin θ0)/(θ1 − θ0) − (sin θ1 − sin θ)] | [`Zones::displacement_ahead`] |
//! | behind it: j = r [(θ0 − θ) − κ (sin θ0 − sin θ)] | [`Zones::displacement_behind`] |
//!
//! The paper's 1 + i is κ = 1/(1 + s) here, and its K_v is put in. The displacements were not read in the paper: two public
//! implementations agree on them (Madsen's of 2013, Pavlov & Johnson's of 2022). What was derived and checked: j ahead is r κ
//! times the height of sin θ above its chord, so it is 0 at both ends and positive between. j behind falls from 0 at θ0, because
//! κ cos θ0 − 1 = κ m sin θ0 > 0 with m = tan(π/4 − φ/2), and turns only behind θ = −arccos(1 + s). The paper takes |j| and puts
//! the signs into its integrals; with the signs of j the letter's integrals (10) are the paper's W, towing force and torque.
//!
//! Both are those of the circle on which the displacement is counted, with its r and κ; ahead they count from where that circle
//! enters the soil, θ1' for θ1 (see `circles.rs`).
//!
//! On a locked wheel E is what an endless displacement leaves, + ahead and − behind.

use crate::circles::Kinematics;
use crate::numerics::circular::{ArcMeans, HalfArc};
use crate::numerics::elementary::Number;
use crate::rim::RimPoint;
use crate::rolling::Rolling;

/// The two zones of a contact.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Zones {
    /// θ0 (rad).
    reversal: f64,
    /// (θ1' − θ0)/2 (rad).
    half_front: f64,
    /// (θ1' − θ1)/2 (rad): the circle of the displacement enters that much before the rim.
    half_lead: f64,
    sin: f64,
    cos: f64,
}

impl Zones {
    /// The zones of a contact that enters the soil at `entry` and parts at `reversal` (rad); the displacement is counted from `lead`
    /// (rad) ahead of the entry.
    #[cold]
    #[inline(never)]
    pub(crate) fn new(entry: f64, lead: f64, reversal: f64) -> Self {
        let half_front = 0.5 * (entry + lead - reversal);
        Self { reversal, half_front, half_lead: 0.5 * lead, sin: reversal.sin(), cos: reversal.cos() }
    }

    /// Half of the arc (rad) of a place behind the entry of the circle of the displacement.
    #[inline(always)]
    fn half_arc<F: Number>(&self, point: &RimPoint<F>) -> F {
        point.half_arc + self.half_lead
    }

    /// E (–) at a place of the rim on either side of θ0.
    pub(crate) fn mobilisation(&self, rolling: &Rolling<'_>, point: &RimPoint) -> f64 {
        if self.half_arc(point) < self.half_front {
            self.mobilisation_ahead(rolling, point)
        } else {
            self.mobilisation_behind(rolling, point)
        }
    }

    /// E (–) ahead of θ0.
    #[inline(always)]
    pub(crate) fn mobilisation_ahead<F: Number>(&self, rolling: &Rolling<'_>, point: &RimPoint<F>) -> F {
        if rolling.slip.is_locked() {
            point.half_arc.like(rolling.shear().residual())
        } else {
            rolling.mobilisation(self.displacement_ahead(rolling, point))
        }
    }

    /// E (–) behind θ0; 0 at it.
    #[inline(always)]
    pub(crate) fn mobilisation_behind<F: Number>(&self, rolling: &Rolling<'_>, point: &RimPoint<F>) -> F {
        if rolling.slip.is_locked() {
            let short = -self.half_arc(point) + self.half_front; // of θ0, by half of the arc
            short.if_not_negative(short.like(0.0), short.like(-rolling.shear().residual()))
        } else {
            rolling.mobilisation(self.displacement_behind(rolling, point))
        }
    }

    /// j (m) at a place of the rim on a wheel that turns; without end on one that does not.
    pub(crate) fn displacement(&self, rolling: &Rolling<'_>, point: &RimPoint) -> f64 {
        let ahead = self.half_arc(point) < self.half_front;
        if rolling.slip.is_locked() {
            let behind = self.half_arc(point) > self.half_front;
            if ahead {
                f64::INFINITY
            } else if behind {
                f64::NEG_INFINITY
            } else {
                0.0
            }
        } else if ahead {
            self.displacement_ahead(rolling, point)
        } else {
            self.displacement_behind(rolling, point)
        }
    }

    /// j (m) ahead of θ0.
    ///
    /// With the half arcs x to the entry and y to θ0, the height of sin θ above its chord is
    /// (x + y)⁻¹ {2 sin θ [x sin² y + y sin² x] + cos θ [y (2x − sin 2x) − x (2y − sin 2y)]}: nothing large cancels.
    #[inline(always)]
    pub(crate) fn displacement_ahead<F: Number>(&self, rolling: &Rolling<'_>, point: &RimPoint<F>) -> F {
        let half_arc = self.half_arc(point);
        let rest = -half_arc + self.half_front;
        let (x, y) = (HalfArc::of(half_arc), HalfArc::of(rest));
        // 2x − sin 2x = 2 (x − sin x) + 2 sin x (1 − cos x).
        let (x_excess, y_excess) = (x.excess + x.sin * x.one_minus_cos, y.excess + y.sin * y.one_minus_cos);
        let rise = point.sin * (half_arc * y.sin * y.sin + rest * x.sin * x.sin);
        let tilt = point.cos * (rest * x_excess - half_arc * y_excess);
        (rise + tilt) * (2.0 * rolling.kinematics.ratio * rolling.kinematics.radius / self.half_front)
    }

    /// j (m) behind θ0: that of a driving wheel whose contact begins at θ0.
    #[inline(always)]
    pub(crate) fn displacement_behind<F: Number>(&self, rolling: &Rolling<'_>, point: &RimPoint<F>) -> F {
        let Kinematics { radius, ratio, complement, .. } = rolling.kinematics;
        let half_arc = self.half_arc(point) - self.half_front;
        let HalfArc { sin, cos, excess, .. } = HalfArc::of(half_arc);
        let sin_middle = cos * self.sin - sin * self.cos;
        let cos_middle = cos * self.cos + sin * self.sin;
        let one_minus_cos_middle = sin_middle * sin_middle / (cos_middle + 1.0);
        (half_arc * complement + (excess + sin * one_minus_cos_middle) * ratio) * (2.0 * radius)
    }

    /// dj/dθ1 (m/rad) ahead of θ0 as a turning wheel sinks, at a place that moves at `turn` = dθ/dθ1, where the circle of the
    /// displacement enters the soil at `entry_turn` = dθ1'/dθ1.
    ///
    /// The chord of sin θ has the slope S = (sin θ1' − sin θ0)/(θ1' − θ0), whose own rate is (cos θ1' − S)/(θ1' − θ0) dθ1'/dθ1.
    #[inline(always)]
    pub(crate) fn displacement_rate_ahead<F: Number>(
        &self,
        kinematics: &Kinematics,
        point: &RimPoint<F>,
        [turn, entry_turn]: [F; 2],
    ) -> F {
        let arc = 2.0 * self.half_front;
        let HalfArc { sin: sin_arc, one_minus_cos, cos, .. } = HalfArc::of(self.half_front);
        let (sin_arc, one_minus_cos_arc) = (2.0 * sin_arc * cos, 2.0 * one_minus_cos * (1.0 + cos));
        let sin_entry_beyond = self.cos * sin_arc - self.sin * one_minus_cos_arc; // sin θ1' − sin θ0
        let slope = sin_entry_beyond / arc;
        let cos_entry = self.cos * (1.0 - one_minus_cos_arc) - self.sin * sin_arc;
        let from_entry = (self.half_arc(point) * (2.0 / arc) - 1.0) * (cos_entry - slope) * entry_turn;
        ((point.cos - slope) * turn + from_entry) * (kinematics.ratio * kinematics.radius)
    }

    /// The same behind θ0, which stays where it is.
    #[inline(always)]
    pub(crate) fn displacement_rate_behind<F: Number>(&self, kinematics: &Kinematics, point: &RimPoint<F>, turn: F) -> F {
        (point.cos * kinematics.ratio - 1.0) * turn * kinematics.radius
    }

    /// Arcs (rad) over which E changes behind the entry, ahead of θ0 and behind it: the displacement by which its law scales,
    /// over |dj/dθ| there, in a contact of that sinkage (m). Infinite on a locked wheel, whose E is constant on each side.
    pub(crate) fn shear_layers(&self, rolling: &Rolling<'_>, sinkage: f64) -> [f64; 3] {
        if rolling.slip.is_locked() {
            return [f64::INFINITY; 3];
        }
        let Kinematics { radius, ratio, complement, .. } = rolling.kinematics;
        let chord = ArcMeans::over(self.reversal + self.half_front, self.half_front).one_minus_cos; // 1 − mean of cos
        let at_entry = ratio * (sinkage / rolling.system.wheel.radius() - chord);
        let one_minus_cos = self.sin * self.sin / (1.0 + self.cos);
        let at_reversal = [ratio * (chord - one_minus_cos), complement + ratio * one_minus_cos];
        [at_entry, at_reversal[0], at_reversal[1]].map(|growth| rolling.strength.shear_scale / (radius * growth.abs()))
    }
}
