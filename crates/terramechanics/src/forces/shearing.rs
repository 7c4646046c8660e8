//! The arcs of a contact, and how the soil is sheared along them.

use super::panels::Edges;
use crate::contact::Angles;
use crate::numerics::elementary::Number;
use crate::patch::ContactPatch;
use crate::pressure_sinkage::PressureCurve;
use crate::rim::{EntryArc, RimPoint};
use crate::stress::StressField;

/// Layers of [`ContactPatch::shear_layer`] after which E is saturated: e to the minus this of a small share is left.
pub(super) const LAYERS: f64 = 20.0;

/// Share of the range of u that the layer has to fall short of, to be split off; else the points resolve it.
const THIN: f64 = 0.7;

/// How the soil presses on the rim at a depth.
pub(super) trait Pressing {
    /// Normal stress (Pa) under a depth (m).
    fn pressure(&self, depth: f64) -> f64;

    /// The same in lanes, where the pressure (Pa) at the `deepest` depth (m) is known.
    #[inline(always)]
    fn pressures<F: Number>(&self, depth: F, _deepest: [f64; 2]) -> F {
        depth.by_lane(|i| self.pressure(depth.lane(i)))
    }

    /// d ln σ/d ln z (–); NaN where it is not the same at all depths.
    fn exponent(&self) -> f64 {
        f64::NAN
    }
}

impl Pressing for PressureCurve {
    #[inline(always)]
    fn pressure(&self, depth: f64) -> f64 {
        PressureCurve::pressure(self, depth)
    }

    #[inline(always)]
    fn pressures<F: Number>(&self, depth: F, [deepest, pressure]: [f64; 2]) -> F {
        self.pressures_by(log_share(depth, deepest), pressure)
    }

    fn exponent(&self) -> f64 {
        self.exponent
    }
}

impl PressureCurve {
    /// σ (Pa) where the pressure is known at the deepest place, by the `log` of the depth over that one. Eq. (1).
    #[inline(always)]
    pub(super) fn pressures_by<F: Number>(&self, log: F, deepest: f64) -> F {
        (log * self.exponent).exp() * deepest
    }
}

/// ln of a depth (m) over the `deepest` one (m).
#[inline(always)]
pub(super) fn log_share<F: Number>(depth: F, deepest: f64) -> F {
    (depth * (1.0 / deepest)).ln()
}

/// How the soil is sheared on the two sides of the peak. A type of its own for each law, so that neither pays for the other.
pub(super) trait Shearing<P = PressureCurve> {
    /// E at a place ahead of the peak, and at one behind it.
    fn ahead<F: Number>(&self, point: &RimPoint<F>) -> F;
    fn behind<F: Number>(&self, point: &RimPoint<F>) -> F;

    /// dE/dθ1 (1/rad) at a place ahead of the peak where E is `share` and which moves at `turn` = dθ/dθ1, and at one behind it; NaN
    /// where a law does not know it.
    #[inline(always)]
    fn rate_ahead<F: Number>(&self, _point: &RimPoint<F>, share: F, _turn: F) -> F {
        share.like(f64::NAN)
    }
    #[inline(always)]
    fn rate_behind<F: Number>(&self, point: &RimPoint<F>, share: F, turn: F) -> F {
        self.rate_ahead(point, share, turn)
    }

    /// Ends of the panels: the ends of thin layers of shear, and the places where E is not smooth.
    fn edges(&self, rim: &Rim<'_, P>) -> Edges;
}

/// The arcs of a contact.
#[derive(Clone, Copy)]
pub(super) struct Rim<'a, P = PressureCurve> {
    pub(super) patch: &'a ContactPatch<'a>,
    pub(super) curve: &'a P,
    /// θ1 − θm, θm − θ2 and θ1 − θ2.
    pub(super) front: f64,
    pub(super) rear: f64,
    pub(super) whole: f64,
    pub(super) entry: EntryArc,
}

impl<'a> Rim<'a> {
    pub(super) fn of(stresses: &StressField<'a>) -> Self {
        Self::pressed(stresses.patch, stresses.curve)
    }
}

impl<'a, P: Pressing> Rim<'a, P> {
    /// The rim in a contact, pressed by the soil as `curve` says.
    pub(super) fn pressed(patch: &'a ContactPatch<'a>, curve: &'a P) -> Self {
        let Angles { entry, peak, exit } = patch.angles;
        Self { patch, curve, front: entry - peak, rear: peak - exit, whole: entry - exit, entry: EntryArc::of(entry) }
    }

    /// An end behind a layer of that arc (rad) at the entry, if it is thin.
    #[inline]
    pub(super) fn split_layer(&self, edges: &mut Edges, layer: f64) {
        edges.split(LAYERS * layer / self.front, 0.0..THIN);
    }

    /// An end at an arc (rad) behind the entry.
    #[inline]
    pub(super) fn split(&self, edges: &mut Edges, arc: f64) {
        edges.split(if arc <= self.front { arc / self.front } else { (self.whole - arc) / self.rear }, 0.0..1.0);
    }

    /// Ends at the places where j changes sign.
    #[inline]
    pub(super) fn split_reversals(&self, edges: &mut Edges) {
        for &arc in self.patch.shear_reversals().arcs() {
            self.split(edges, arc);
        }
    }
}
