//! The shape of a contact as a closed form sees it: of one contact, or of several side by side.

use crate::contact::{AngleRates, Angles, Contact};
use crate::numerics::elementary::Number;
use crate::patch::ContactPatch;
use crate::rim::{RimEntry, RimPoint};

/// The contact of a wheel with one zone, whatever its motion.
#[derive(Clone, Copy)]
pub(crate) struct Outline<F = f64> {
    pub(crate) radius: F,
    /// Sinkage z (m), and z/r (–).
    pub(crate) sinkage: F,
    pub(super) depth_ratio: F,
    pub(crate) angles: Angles<F>,
    pub(crate) entry: RimEntry<F>,
    /// The place of the peak.
    pub(crate) peak: RimPoint<F>,
}

impl<F: Number> Outline<F> {
    /// Of a wheel of `radius` r (m) at `sinkage` z (m) and a `slip` ratio (–).
    #[inline(always)]
    pub(crate) fn of(contact: &Contact, [radius, sinkage, slip]: [F; 3]) -> Self {
        let depth_ratio = sinkage / radius;
        Self::at(radius, sinkage, contact.angles_by_rule(depth_ratio, slip), RimEntry::at_depth(depth_ratio))
    }

    #[inline(always)]
    fn at(radius: F, sinkage: F, angles: Angles<F>, entry: RimEntry<F>) -> Self {
        let peak = entry.place(angles.entry - angles.peak);
        Self { radius, sinkage, depth_ratio: sinkage / radius, angles, entry, peak }
    }

    /// Depth (m) of the rim under the peak. Eq. (3).
    #[inline(always)]
    pub(super) fn peak_depth(&self) -> F {
        self.peak.rise * (self.radius * 2.0)
    }

    /// dθ1/d ln z (rad), from cos θ1 = 1 − z/r.
    #[inline(always)]
    pub(crate) fn entry_rate(&self) -> F {
        self.depth_ratio / self.entry.sin()
    }

    /// d ln z/dθ1 (1/rad).
    #[inline(always)]
    pub(crate) fn deepening(&self) -> F {
        self.entry.sin() / self.depth_ratio
    }

    /// d ln z_m/dθ1 (1/rad) of the depth under the rim at the peak.
    #[inline(always)]
    pub(super) fn peak_deepening(&self, rates: &AngleRates<F>) -> F {
        (self.entry.sin() - self.peak.sin * rates.peak) / (self.peak.rise * 2.0)
    }
}

impl Outline {
    /// Of a contact with one zone.
    #[inline(always)]
    pub(super) fn of_patch(patch: &ContactPatch<'_>) -> Self {
        let radius = patch.rolling.system.wheel.radius();
        Self::at(radius, patch.sinkage, patch.angles, patch.entry)
    }
}
