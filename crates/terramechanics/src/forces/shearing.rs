//! The arcs of a contact, and how the soil is sheared along them.

use super::panels::Edges;
use crate::contact::Angles;
use crate::numerics::lanes::Number;
use crate::patch::ContactPatch;
use crate::pressure_sinkage::PressureCurve;
use crate::rim::{EntryArc, RimPoint};
use crate::stress::StressField;

/// Layers of [`ContactPatch::shear_layer`] after which E is saturated: e to the minus this of a small share is left.
pub(super) const LAYERS: f64 = 20.0;

/// Share of the range of u that the layer has to fall short of, to be split off; else the points resolve it.
const THIN: f64 = 0.7;

/// How the soil is sheared on the two sides of the peak. A type of its own for each law, so that neither pays for the other.
pub(super) trait Shearing {
    /// E at a place ahead of the peak, and at one behind it.
    fn ahead<F: Number>(&self, point: &RimPoint<F>) -> F;
    fn behind<F: Number>(&self, point: &RimPoint<F>) -> F;

    /// dE/dθ1 (1/rad) at a place where E is `share` and which moves at `turn` = dθ/dθ1; NaN where a law does not know it.
    #[inline(always)]
    fn rate<F: Number>(&self, _point: &RimPoint<F>, share: F, _turn: F) -> F {
        share.like(f64::NAN)
    }

    /// Ends of the panels: the ends of thin layers of shear, and the places where E is not smooth.
    fn edges(&self, rim: &Rim<'_>) -> Edges;
}

/// The arcs of a contact.
pub(super) struct Rim<'a> {
    pub(super) patch: &'a ContactPatch<'a>,
    pub(super) curve: &'a PressureCurve,
    /// θ1 − θm, θm − θ2 and θ1 − θ2.
    pub(super) front: f64,
    pub(super) rear: f64,
    pub(super) whole: f64,
    pub(super) entry: EntryArc,
}

impl<'a> Rim<'a> {
    pub(super) fn of(stresses: &StressField<'a>) -> Self {
        let StressField { patch, curve } = *stresses;
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
