//! Where does a wheel of one sinkage touch the soil, and how is the soil sheared there? (letter, Eqs. 3, 4, 6)
//!
//! | equation | here |
//! |---|---|
//! | (3), (4) depth of a rim point | [`ContactPatch::depth`] |
//! | (6) exponent of E | [`ContactPatch::shear_displacement`] |
//!
//! The displacement is counted on a circle r_j from where that enters the soil, θ1' = arccos((r − z)/r_j), see `circles.rs`. The
//! soil under a lug has been sheared before the rim comes in, so j(θ1) > 0 where r_j > r:
//!
//! j(θ) = j(θ1) + r_j [(θ1 − θ) − κ (sin θ1 − sin θ)], κ = v/(r_j ω).
//!
//! Departures: Eq. (3) holds ahead of the peak and Eq. (4) behind it, the other way round than printed (erratum 1); for (6)
//! see `shear/`. At s < 0 the displacement may follow another law instead (`braking/`).

use crate::circles::Kinematics;
use crate::contact::{AngleRates, Angles, angle_at_depth};
use crate::displacement::{Lead, Way};
use crate::error::Error;
use crate::numerics::elementary::Number;
use crate::rim::{RimEntry, RimPoint};
use crate::rolling::{Rolling, WheelOnSoil};
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
    pub(crate) entry: RimEntry,
    pub(crate) lead: Lead,
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
        let kinematics = &self.kinematics;
        let lead = if kinematics.radius == radius { Lead::NONE } else { self.lead(sinkage, angles.entry) };
        Ok(ContactPatch { rolling: self, sinkage, angles, entry: RimEntry::at_depth(depth_ratio), lead })
    }
}

impl Rolling<'_> {
    /// The contact of the same wheel at another slip, where its angles do not change.
    pub(crate) fn same_contact(&self, other: &ContactPatch<'_>) -> ContactPatch<'_> {
        let ContactPatch { sinkage, angles, entry, .. } = *other;
        let lead = if other.lead == Lead::NONE { Lead::NONE } else { self.lead(sinkage, angles.entry) };
        ContactPatch { rolling: self, sinkage, angles, entry, lead }
    }

    /// What the circle of the displacement is ahead of the rim by. Apart, so that wheels without lugs do not carry its code along.
    #[inline(never)]
    fn lead(&self, sinkage: f64, entry: f64) -> Lead {
        let lead = Lead::of(&self.kinematics, self.system.wheel.radius(), sinkage, entry);
        if self.slip.is_locked() { lead.without_displacement() } else { lead }
    }

    /// The contact of the leading edge at `sinkage` z (m), with its peak where `peak` (rad) says.
    ///
    /// # Errors
    /// [`Error::SinkageOutsideWheel`] unless 0 < z ≤ r.
    pub(crate) fn leading_contact(&self, sinkage: f64, peak: f64) -> Result<ContactPatch<'_>, Error> {
        let radius = self.system.wheel.radius();
        if !(sinkage > 0.0 && sinkage <= radius) {
            return Err(Error::SinkageOutsideWheel { sinkage, radius });
        }
        let depth_ratio = sinkage / radius;
        let angles = Angles { entry: angle_at_depth(depth_ratio), peak, exit: 0.0 };
        Ok(ContactPatch { rolling: self, sinkage, angles, entry: RimEntry::at_depth(depth_ratio), lead: Lead::NONE })
    }
}

impl ContactPatch<'_> {
    /// The same contact of a wheel that differs in the pressure and the strength of its soil alone.
    pub(crate) fn with<'b>(&self, rolling: &'b Rolling<'b>) -> ContactPatch<'b> {
        ContactPatch { rolling, sinkage: self.sinkage, angles: self.angles, entry: self.entry, lead: self.lead }
    }

    /// dθ1/d ln z = tan (θ1/2) (rad), from cos θ1 = 1 − z/r.
    pub(crate) fn entry_rate(&self) -> f64 {
        self.sinkage / self.rolling.system.wheel.radius() / self.entry.sin()
    }

    /// How the angles move as the wheel sinks: two zones part where they do at any sinkage.
    pub(crate) fn rates(&self) -> AngleRates {
        let WheelOnSoil { wheel, contact, .. } = self.rolling.system;
        let rates = contact.rates(self.sinkage / wheel.radius(), self.rolling.slip.ratio());
        if self.has_two_zones() { AngleRates { peak: 0.0, ..rates } } else { rates }
    }

    /// Whether it is the contact of a braking wheel with two zones.
    #[must_use]
    pub fn has_two_zones(&self) -> bool {
        self.rolling.reversal.is_some()
    }

    /// The zones of a braking wheel, where its law has two.
    #[inline]
    pub(crate) fn zones(&self) -> Option<Zones> {
        self.rolling.reversal.map(|reversal| Zones::new(self.angles.entry, self.lead.arc, reversal))
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
    #[inline(always)]
    pub(crate) fn rim_point<F: Number>(&self, arc: F) -> RimPoint<F> {
        self.entry.place(arc)
    }

    /// Depth r (cos θ − cos θ1) (m) of a place of the rim. Eq. (3).
    #[inline(always)]
    pub(crate) fn geometric_depth<F: Number>(&self, point: &RimPoint<F>) -> F {
        point.rise * (2.0 * self.rolling.system.wheel.radius())
    }

    /// The way along which it shears the soil, where it turns.
    #[inline(always)]
    pub(crate) fn way(&self) -> Way {
        Way { kinematics: self.rolling.kinematics, lead: self.lead }
    }

    /// Shear displacement j (m) of a turning wheel. Eq. (6).
    #[inline(always)]
    pub(crate) fn displacement<F: Number>(&self, point: &RimPoint<F>) -> F {
        self.way().displacement(point)
    }

    /// Arc θ1' − θ (rad) of a place of the rim behind the entry of the circle of the displacement.
    #[inline]
    pub(crate) fn sheared_arc(&self, point: &RimPoint) -> f64 {
        point.arc() + self.lead.arc
    }

    /// Speed 1 − κ cos θ (–) against the soil, backwards, over r_j ω, of a place of a turning wheel.
    #[inline]
    pub(crate) fn slip_velocity(&self, point: &RimPoint) -> f64 {
        let Kinematics { ratio, complement, .. } = self.rolling.kinematics;
        complement + ratio * (point.sin * point.sin / (1.0 + point.cos))
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
    pub(crate) fn mobilisation_of_one_zone<F: Number>(&self, point: &RimPoint<F>) -> F {
        let rolling = self.rolling;
        if rolling.slip.is_locked() {
            point.half_arc.like(-rolling.shear().residual())
        } else {
            rolling.mobilisation(self.displacement(point))
        }
    }

    /// dE/dθ1 (1/rad) at a place of a turning wheel with one zone, where E is `share` and which moves at `turn` = dθ/dθ1.
    #[inline(always)]
    pub(crate) fn mobilisation_rate<F: Number>(&self, point: &RimPoint<F>, share: F, turn: F) -> F {
        let radius = self.rolling.system.wheel.radius();
        let rate = self.way().displacement_rate([radius, self.sinkage], &self.entry, point, turn);
        self.rolling.mobilisation_rate(self.displacement(point), share, rate)
    }

    /// Shear displacement j (m) at `theta` (rad): 0 where its circle enters the soil, not negative where that circle does not
    /// skid, infinite on a locked wheel (no finite displacement describes one that does not turn). Eq. (6). Of two zones, positive
    /// in the front one and negative in the rear one.
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
        let Rolling { slip, kinematics, strength, .. } = self.rolling;
        let growth = kinematics.radius * (1.0 - kinematics.ratio * self.entry.cos()).abs();
        if slip.is_locked() { f64::INFINITY } else { strength.shear_scale / growth }
    }
}
