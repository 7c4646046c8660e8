//! Where does a wheel of one sinkage touch the soil, and how is the soil sheared there? (letter, Eqs. 3, 4, 6)
//!
//! | equation | here |
//! |---|---|
//! | (3), (4) depth of a rim point | [`ContactPatch::depth`] |
//! | (6) exponent of E | [`ContactPatch::shear_displacement`] |
//!
//! Departures: Eq. (3) holds ahead of the peak and Eq. (4) behind it, the other way round than printed (erratum 1); for (6)
//! see `shear/`. At s < 0 the displacement may follow another law instead (`braking/`).

use crate::contact::Angles;
use crate::error::Error;
use crate::rim::{RimEntry, RimPoint};
use crate::rolling::Rolling;
use crate::zones::Zones;

/// The contact of a rolling wheel at one sinkage.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct ContactPatch<'a> {
    /// The wheel at its slip.
    pub rolling: &'a Rolling<'a>,
    /// Sinkage z (m).
    pub sinkage: f64,
    /// Characteristic angles.
    pub angles: Angles,
    entry: RimEntry,
}

impl Rolling<'_> {
    /// The contact at `sinkage` z (m).
    ///
    /// # Errors
    /// [`Error::SinkageOutsideWheel`] unless 0 < z ≤ r, [`Error::PeakOutsideContact`], [`Error::ReversalOutsideContact`].
    #[inline(always)] // see `WheelOnSoil::rolling`
    pub fn contact(&self, sinkage: f64) -> Result<ContactPatch<'_>, Error> {
        let radius = self.system.wheel.radius();
        if !(sinkage > 0.0 && sinkage <= radius) {
            return Err(Error::SinkageOutsideWheel { sinkage, radius });
        }
        let depth_ratio = sinkage / radius;
        let angles = match self.reversal {
            None => self.system.contact.angles(depth_ratio, self.slip)?,
            Some(reversal) => self.system.contact.angles_parted_at(reversal, depth_ratio)?,
        };
        Ok(ContactPatch { rolling: self, sinkage, angles, entry: RimEntry::at_depth(depth_ratio) })
    }
}

impl ContactPatch<'_> {
    /// Whether it is the contact of a braking wheel with two zones.
    #[must_use]
    pub fn has_two_zones(&self) -> bool {
        self.rolling.reversal.is_some()
    }

    /// The zones of a braking wheel, where its law has two.
    #[inline]
    pub(crate) fn zones(&self) -> Option<Zones> {
        self.rolling.reversal.map(|reversal| Zones::new(self.angles.entry, reversal))
    }

    /// Depth that presses on the rim at `theta` (rad) in [θ2, θ1], in (m): the geometric one ahead of the peak, its mirror
    /// image behind. Eqs. (3), (4).
    #[must_use]
    pub fn depth(&self, theta: f64) -> f64 {
        let Angles { entry, peak, exit } = self.angles;
        let arc = if theta >= peak {
            entry - theta
        } else {
            (theta - exit) / (peak - exit) * (entry - peak) // Eq. (4): the arc from the entry to the mirrored angle
        };
        self.geometric_depth(&self.rim_point(arc))
    }

    /// The place at an arc δ = θ1 − θ (rad) behind the entry.
    #[inline]
    pub(crate) fn rim_point(&self, arc: f64) -> RimPoint {
        self.entry.place(arc)
    }

    /// Depth r (cos θ − cos θ1) = 2 r sin a sin x (m) of a place of the rim. Eq. (3).
    #[inline]
    pub(crate) fn geometric_depth(&self, point: &RimPoint) -> f64 {
        2.0 * self.rolling.system.wheel.radius() * point.sin_middle * point.sin_half_arc
    }

    /// Shear displacement j (m) of a turning wheel. Eq. (6).
    ///
    /// j = r [(1 − κ) δ + κ (δ − sin θ1 + sin θ)], and δ − sin θ1 + sin θ = 2 (x − sin x) + 2 sin x (1 − cos a): neither
    /// bracket cancels.
    #[inline]
    pub(crate) fn displacement(&self, point: &RimPoint) -> f64 {
        let (velocity_ratio, velocity_complement) = self.rolling.velocity_ratio();
        2.0 * self.rolling.system.wheel.radius()
            * (velocity_complement * point.half_arc
                + velocity_ratio * (point.excess + point.sin_half_arc * point.one_minus_cos_middle))
    }

    /// Speed 1 − κ cos θ (–) of a place of the rim against the soil, backwards, over rω, for a turning wheel.
    #[inline]
    pub(crate) fn slip_velocity(&self, point: &RimPoint) -> f64 {
        let (velocity_ratio, velocity_complement) = self.rolling.velocity_ratio();
        velocity_complement + velocity_ratio * (point.sin * point.sin / (1.0 + point.cos))
    }

    /// E (–) at a place of the rim.
    #[inline]
    pub(crate) fn mobilisation(&self, point: &RimPoint) -> f64 {
        match self.zones() {
            None => self.mobilisation_of_one_zone(point),
            Some(zones) => zones.mobilisation(self.rolling, point),
        }
    }

    /// E (–) at the angle of maximum stress; 0 where two zones part there.
    #[must_use]
    pub fn peak_mobilisation(&self) -> f64 {
        self.mobilisation(&self.rim_point(self.angles.entry - self.angles.peak))
    }

    /// E (–) of a contact of one zone: what an endless displacement leaves, turned, all along the contact of a locked wheel.
    #[inline(always)]
    pub(crate) fn mobilisation_of_one_zone(&self, point: &RimPoint) -> f64 {
        let rolling = self.rolling;
        if rolling.slip.is_locked() { -rolling.shear().residual() } else { rolling.mobilisation(self.displacement(point)) }
    }

    /// Shear displacement j (m) at `theta` (rad): 0 at the entry, not negative on a driving wheel, infinite on a locked one
    /// (no finite displacement describes a wheel that does not turn). Eq. (6). Of two zones, positive in the front one and
    /// negative in the rear one.
    #[must_use]
    pub fn shear_displacement(&self, theta: f64) -> f64 {
        if let Some(zones) = self.zones() {
            zones.displacement(self.rolling, &self.rim_point(self.angles.entry - theta))
        } else if self.rolling.slip.is_locked() {
            f64::NEG_INFINITY
        } else {
            self.displacement(&self.rim_point(self.angles.entry - theta))
        }
    }

    /// Arc (rad) behind the entry over which E changes: the displacement by which its law scales, over dj/dδ at the entry.
    /// Infinite on a locked wheel, whose E is constant.
    pub(crate) fn shear_layer(&self) -> f64 {
        let Rolling { system, slip, .. } = self.rolling;
        let growth = system.wheel.radius() * (1.0 - self.rolling.velocity_ratio().0 * self.entry.cos()).abs();
        if slip.is_locked() { f64::INFINITY } else { self.rolling.shear().scale() / growth }
    }
}
