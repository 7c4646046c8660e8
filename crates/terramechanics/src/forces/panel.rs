//! The sums of the stresses over one panel of the rim, eight nodes side by side, and how they change as the wheel sinks.

use super::panels::{ROUNDING, Resolved, error_of};
use super::shearing::{Pressing, Rim, Shearing};
use crate::contact::AngleRates;
use crate::numerics::gauss_legendre::LaneNodes;
use crate::numerics::lanes::{Arithmetic, LANES, sum};
use crate::rim::RimPoint;
use fearless_simd::prelude::*;
use fearless_simd::{Simd, f64x8};

/// The integrals of Eq. (10), or their changes.
#[derive(Clone, Copy, Default)]
pub(super) struct Integrals {
    /// ∫ σ cos θ dθ.
    pub(super) normal_cos: f64,
    /// ∫ σ sin θ dθ.
    pub(super) normal_sin: f64,
    /// ∫ τ cos θ dθ.
    pub(super) shear_cos: f64,
    /// ∫ τ sin θ dθ.
    pub(super) shear_sin: f64,
    /// ∫ τ dθ.
    pub(super) shear_plain: f64,
}

impl Integrals {
    #[inline]
    pub(super) fn add(&mut self, other: &Self) {
        self.normal_cos += other.normal_cos;
        self.normal_sin += other.normal_sin;
        self.shear_cos += other.shear_cos;
        self.shear_sin += other.shear_sin;
        self.shear_plain += other.shear_plain;
    }

    #[inline(always)]
    pub(super) fn of<L: Simd>([normal_cos, normal_sin, shear_cos, shear_sin, shear_plain]: [f64x8<L>; 5]) -> Self {
        // Each by a call of its own: what maps an array is not compiled for the lanes.
        Self {
            normal_cos: sum(normal_cos),
            normal_sin: sum(normal_sin),
            shear_cos: sum(shear_cos),
            shear_sin: sum(shear_sin),
            shear_plain: sum(shear_plain),
        }
    }
}

/// Sums over a panel, or over all of them.
#[derive(Clone, Copy, Default)]
pub(super) struct Sums {
    pub(super) integrals: Integrals,
    /// ∫ |τ| dθ, the scale of the shear's error.
    shear_size: f64,
    /// Error estimates, comparable with normal_cos and with shear_size.
    normal_error: f64,
    shear_error: f64,
}

impl Resolved for Sums {
    #[inline]
    fn add(&mut self, other: &Self) {
        self.integrals.add(&other.integrals);
        self.shear_size += other.shear_size;
        self.normal_error += other.normal_error;
        self.shear_error += other.shear_error;
    }

    #[inline]
    fn relative_error(&self) -> f64 {
        let share = |error: f64, size: f64| if size > 0.0 { error / size } else { 0.0 };
        ROUNDING + share(self.normal_error, self.integrals.normal_cos).max(share(self.shear_error, self.shear_size))
    }

    fn error_share(&self, total: &Self) -> f64 {
        (self.normal_error / total.integrals.normal_cos).max(self.shear_error / total.shear_size.max(f64::MIN_POSITIVE))
    }
}

#[inline(always)]
fn in_lanes<L: Simd>(simd: L, values: &[f64; LANES]) -> f64x8<L> {
    f64x8::simd_from(simd, *values)
}

/// Nodes on both sides of the peak, mirrored to one another, and what is found there.
#[derive(Clone, Copy)]
pub(super) struct Spot<L: Simd> {
    t: f64x8<L>,
    /// dt.
    weight: f64x8<L>,
    pub(super) front: RimPoint<f64x8<L>>,
    rear: RimPoint<f64x8<L>>,
    /// σ (Pa).
    pub(super) normal: f64x8<L>,
    /// E (–).
    front_share: f64x8<L>,
    rear_share: f64x8<L>,
}

impl<L: Simd> Spot<L> {
    #[inline(always)]
    fn zero(simd: L) -> Self {
        let zero = f64x8::splat(simd, 0.0);
        let place = RimPoint { half_arc: zero, lag: zero, rise: zero, sin: zero, cos: zero };
        Self { t: zero, weight: zero, front: place, rear: place, normal: zero, front_share: zero, rear_share: zero }
    }
}

/// A side of the peak: its arc (rad), and how that changes against the entry angle.
struct Side {
    arc: f64,
    arc_rate: f64,
}

/// Changes of the integrals against the entry angle, at fixed t.
struct Changes<L: Simd>([f64x8<L>; 5]);

impl<L: Simd> Changes<L> {
    /// Adds those of nodes of one side: `turn` = dθ/dθ1, and the stresses (σ, τ) with their rates.
    #[inline(always)]
    fn add(&mut self, weight: f64x8<L>, side: &Side, place: &RimPoint<f64x8<L>>, turn: f64x8<L>, stresses: [[f64x8<L>; 2]; 2]) {
        let RimPoint { sin, cos, .. } = *place;
        let [[normal, normal_rate], [shear, shear_rate]] = stresses;
        let sweep = weight * turn * side.arc;
        let (grown, swept) = (weight * (normal * side.arc_rate + normal_rate * side.arc), sweep * normal);
        self.0[0] += grown * cos - swept * sin;
        self.0[1] += grown * sin + swept * cos;
        let (grown, swept) = (weight * (shear * side.arc_rate + shear_rate * side.arc), sweep * shear);
        self.0[2] += grown * cos - swept * sin;
        self.0[3] += grown * sin + swept * cos;
        self.0[4] += grown;
    }
}

impl<P: Pressing> Rim<'_, P> {
    /// The sums over a range of u.
    #[inline(always)]
    pub(super) fn sums<L: Simd, S: Shearing<P>, const N: usize>(
        &self,
        simd: L,
        nodes: &[LaneNodes; N],
        shearing: &S,
        [from, to]: [f64; 2],
    ) -> Sums {
        self.sums_and_changes::<L, S, N, false>(simd, nodes, shearing, [from, to], &AngleRates::FIXED).0
    }

    /// The same, and if `CHANGING` the changes of the integrals against the entry angle, by how the angles and the shear law change.
    #[inline(always)]
    pub(super) fn sums_and_changes<L: Simd, S: Shearing<P>, const N: usize, const CHANGING: bool>(
        &self,
        simd: L,
        nodes: &[LaneNodes; N],
        shearing: &S,
        [from, to]: [f64; 2],
        rates: &AngleRates,
    ) -> (Sums, Integrals) {
        let mut spots = self.spots(simd, nodes, [from, to]);
        let deepest = [self.patch.sinkage, self.curve.pressure(self.patch.sinkage)];
        for spot in &mut spots {
            // Eqs. (3), (4): the same on both sides.
            spot.normal = self.curve.pressures(self.patch.geometric_depth(&spot.front), deepest);
        }
        self.sums_over::<L, S, N, CHANGING>(simd, nodes, &mut spots, shearing, rates)
    }

    /// Nodes over a range of u, without stresses.
    #[inline(always)]
    pub(super) fn spots<L: Simd, const N: usize>(&self, simd: L, nodes: &[LaneNodes; N], [from, to]: [f64; 2]) -> [Spot<L>; N] {
        let patch = self.patch;
        let length = to - from;
        let mut spots = [Spot::zero(simd); N];
        for (spot, nodes) in spots.iter_mut().zip(nodes) {
            let u = in_lanes(simd, &nodes.place) * length + from;
            let cube = u * u * u;
            spot.t = cube * u;
            spot.weight = in_lanes(simd, &nodes.weight) * cube * (4.0 * length); // du → dt
            spot.front = patch.rim_point(spot.t * self.front);
            spot.rear = patch.entry.place_at(&self.entry, spot.t * self.rear + patch.angles.exit);
        }
        spots
    }

    /// The sums over nodes that are pressed, and if `CHANGING` the changes of the integrals.
    ///
    /// Step by step over all nodes: the steps of one vector wait for one another, those of several do not.
    #[inline(always)]
    pub(super) fn sums_over<L: Simd, S: Shearing<P>, const N: usize, const CHANGING: bool>(
        &self,
        simd: L,
        nodes: &[LaneNodes; N],
        spots: &mut [Spot<L>; N],
        shearing: &S,
        rates: &AngleRates,
    ) -> (Sums, Integrals) {
        let Self { patch, curve, .. } = *self;
        let front_side = Side { arc: self.front, arc_rate: 1.0 - rates.peak };
        let rear_side = Side { arc: self.rear, arc_rate: rates.peak - rates.exit };
        let zero = f64x8::splat(simd, 0.0);
        let [mut normal_cos, mut normal_sin, mut shear_cos, mut shear_sin, mut shear_plain, mut shear_size] = [zero; 6];
        let [mut normal_null, mut shear_null] = [[zero; 2]; 2];
        let mut changes = Changes([zero; 5]);
        for spot in spots.iter_mut() {
            (spot.front_share, spot.rear_share) = (shearing.ahead(&spot.front), shearing.behind(&spot.rear)); // Eq. (6)
        }
        for (spot, LaneNodes { null, .. }) in spots.iter().zip(nodes) {
            let Spot { t, weight, front, rear, normal, front_share, rear_share } = *spot;
            let strength = patch.rolling.shear_strength(normal);
            let (front_weight, rear_weight) = (weight * front_side.arc, weight * rear_side.arc);
            let (front_stress, rear_stress) = (front_share * strength, rear_share * strength); // Eq. (5)
            let (front_shear, rear_shear) = (front_weight * front_stress, rear_weight * rear_stress);
            let both_shear = front_shear + rear_shear;
            let both_normal = (front_weight + rear_weight) * normal;
            normal_cos += normal * (front_weight * front.cos + rear_weight * rear.cos);
            normal_sin += normal * (front_weight * front.sin + rear_weight * rear.sin);
            shear_cos += front_shear * front.cos + rear_shear * rear.cos;
            shear_sin += front_shear * front.sin + rear_shear * rear.sin;
            shear_plain += both_shear;
            shear_size += Arithmetic::abs(front_shear) + Arithmetic::abs(rear_shear);
            let (high, higher) = (in_lanes(simd, &null[0]), in_lanes(simd, &null[1]));
            normal_null[0] += both_normal * high;
            normal_null[1] += both_normal * higher;
            shear_null[0] += both_shear * high;
            shear_null[1] += both_shear * higher;
            if CHANGING {
                let front_turn = -(t * front_side.arc_rate) + 1.0;
                let rear_turn = t * rear_side.arc_rate + rates.exit;
                let deepening = (-(front.sin * front_turn) + patch.entry.sin()) / (front.rise * 2.0); // d ln z(θ)/dθ1
                let normal_rate = normal * deepening * curve.exponent();
                let strength_rate = normal_rate * patch.rolling.strength.tan_friction;
                let front_rate = shearing.rate_ahead(&front, front_share, front_turn) * strength + front_share * strength_rate;
                let rear_rate = shearing.rate_behind(&rear, rear_share, rear_turn) * strength + rear_share * strength_rate;
                changes.add(weight, &front_side, &front, front_turn, [[normal, normal_rate], [front_stress, front_rate]]);
                changes.add(weight, &rear_side, &rear, rear_turn, [[normal, normal_rate], [rear_stress, rear_rate]]);
            }
        }
        let integrals = Integrals::of([normal_cos, normal_sin, shear_cos, shear_sin, shear_plain]);
        let shear_size = sum(shear_size);
        let normal_error = error_of([sum(normal_null[0]), sum(normal_null[1])], integrals.normal_cos);
        let shear_error = error_of([sum(shear_null[0]), sum(shear_null[1])], shear_size);
        (Sums { integrals, shear_size, normal_error, shear_error }, Integrals::of(changes.0))
    }
}
