//! How far has the soil been sheared at a place of the rim, where a contact has one zone? (letter, Eq. 6)
//!
//! j(θ) = j(θ1) + r_j [(θ1 − θ) − κ (sin θ1 − sin θ)], κ = v/(r_j ω), where j(θ1) is what the circle of the displacement has sheared
//! before the rim comes in (`patch.rs`).

use crate::circles::Kinematics;
use crate::contact::angle_at_depth;
use crate::numerics::circular::HalfArc;
use crate::numerics::elementary::Number;
use crate::numerics::lanes::Beside;
use crate::rim::{RimEntry, RimPoint};

/// What the circle of the displacement is ahead of the rim by: nothing where it is the rim.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Lead<K = f64> {
    /// θ1' − θ1 (rad).
    pub(crate) arc: K,
    /// j(θ1) (m); 0 for a wheel that does not turn.
    displacement: K,
}

impl Lead {
    pub(crate) const NONE: Self = Self { arc: 0.0, displacement: 0.0 };

    /// The same of a wheel that does not turn.
    pub(crate) fn without_displacement(self) -> Self {
        Self { displacement: 0.0, ..self }
    }
}

impl<K: Number> Lead<K> {
    /// [`Lead::NONE`] in the lanes of another number.
    #[inline(always)]
    pub(crate) fn none(like: K) -> Self {
        Self { arc: like.like(0.0), displacement: like.like(0.0) }
    }

    /// On a turning wheel of `radius` r (m) at `sinkage` z (m) that enters at `entry` θ1 (rad).
    ///
    /// cos θ1 − cos θ1' = (r − z)(1/r − 1/r_j) = 2 sin a sin x, with the half arc x and the middle a between both entries, gives x
    /// without cancellation.
    #[inline]
    pub(crate) fn of(kinematics: &Kinematics<K>, radius: K, sinkage: K, entry: K) -> Self {
        let Kinematics { radius: outer, offset, ratio, complement, .. } = *kinematics;
        let outer_entry = angle_at_depth((offset + sinkage) / outer);
        let middle = HalfArc::of((entry + outer_entry) * 0.5);
        let sin = (radius - sinkage) * offset / (radius * outer) * 0.5 / middle.sin;
        let half_arc = sin.arcsin();
        let excess = HalfArc::of(half_arc).excess;
        let displacement = outer * 2.0 * (complement * half_arc + ratio * (excess + sin * middle.one_minus_cos));
        Self { arc: half_arc * 2.0, displacement }
    }
}

/// The way along which a turning wheel shears the soil.
#[derive(Clone, Copy)]
pub(crate) struct Way<K = f64> {
    pub(crate) kinematics: Kinematics<K>,
    pub(crate) lead: Lead<K>,
}

impl<K: Number> Way<K> {
    /// Shear displacement j (m) at a place of the rim. Eq. (6).
    ///
    /// j − j(θ1) = r_j [(1 − κ) δ + κ (δ − sin θ1 + sin θ)]: neither bracket cancels.
    #[inline(always)]
    pub(crate) fn displacement<F: Beside<K>>(&self, point: &RimPoint<F>) -> F {
        let Kinematics { radius, ratio, complement, .. } = self.kinematics;
        (point.half_arc * complement + point.lag * ratio) * (radius * 2.0) + self.lead.displacement
    }

    /// dθ1'/dθ1 (–) as a wheel of `radius` r (m) sinks: how the circle of the displacement enters the soil.
    #[inline(always)]
    pub(crate) fn entry_turn(&self, [radius, sinkage]: [K; 2], entry: &RimEntry<K>) -> K {
        let Kinematics { radius: outer, offset, .. } = self.kinematics;
        let outer_entry = RimEntry::at_depth((offset + sinkage) / outer);
        radius / outer * entry.sin() / outer_entry.sin()
    }

    /// dj/dθ1 (m/rad) as a wheel of `radius` r (m) sinks, at a place that moves at `turn` = dθ/dθ1.
    ///
    /// dj/dθ1 = r_j [dθ1'/dθ1 − dθ/dθ1 − κ (cos θ1' dθ1'/dθ1 − cos θ dθ/dθ1)], with cos θ1' = (r − z)/r_j.
    #[inline(always)]
    pub(crate) fn displacement_rate<F: Beside<K>>(
        &self,
        [radius, sinkage]: [K; 2],
        entry: &RimEntry<K>,
        point: &RimPoint<F>,
        turn: F,
    ) -> F {
        let Kinematics { radius: outer, ratio, .. } = self.kinematics;
        let outward = radius / outer;
        let entry_rate = self.entry_turn([radius, sinkage], entry) * (-(ratio * outward * entry.cos()) + 1.0);
        (point.cos * turn * ratio - turn + entry_rate) * outer
    }
}
