//! What stresses act along the rim? Normal and shear stress of a rolling wheel (letter, Eqs. 1, 3–6; Wong & Reece 1967).
//!
//! | equation | here |
//! |---|---|
//! | (1) σ = K_s z^N | [`ContactPatch::normal_stress`] |
//! | (3), (4) depth of a rim point | [`ContactPatch::depth`] |
//! | (5) τ = E (c + σ tan φ) | [`ContactPatch::shear_stress`] |
//! | (6) exponent of E | [`ContactPatch::shear_displacement`] |
//!
//! Departures: Eq. (3) holds ahead of the peak and Eq. (4) behind it, the other way round than printed (erratum 1); for (6)
//! see `shear/`. At s < 0 the displacement may follow another law instead (`braking/`). All differences of circular functions
//! are written as products, so that a light wheel on firm ground (z/r = 1e-6) keeps its digits.

use crate::braking::Zones;
use crate::contact::Angles;
use crate::numerics::circular::HalfArc;
use crate::rolling::Rolling;

/// The contact of a rolling wheel at one sinkage.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct ContactPatch<'a> {
    /// The wheel at its slip.
    pub rolling: &'a Rolling<'a>,
    /// Sinkage z (m).
    pub sinkage: f64,
    /// Characteristic angles.
    pub angles: Angles,
    sin_entry: f64,
    cos_entry: f64,
}

/// A place of the rim, by its arc δ behind the entry, with the circular functions that the formulas need.
#[derive(Debug, Clone, Copy)]
pub(crate) struct RimPoint {
    /// x = δ/2, sin x and x − sin x.
    pub(crate) half_arc: f64,
    sin_half_arc: f64,
    excess: f64,
    /// sin a and 1 − cos a of a = (θ1 + θ)/2.
    sin_middle: f64,
    one_minus_cos_middle: f64,
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

/// Stresses at one place of the rim.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Stresses {
    /// Normal stress σ (Pa).
    pub normal: f64,
    /// Shear stress τ (Pa), positive where the soil pushes the wheel forward.
    pub shear: f64,
}

impl<'a> ContactPatch<'a> {
    /// The contact between `angles` at `sinkage` (m), 0 < z ≤ r.
    #[inline]
    pub(crate) fn new(rolling: &'a Rolling<'a>, sinkage: f64, angles: Angles) -> Self {
        let depth_ratio = sinkage / rolling.system.wheel.radius();
        Self {
            rolling,
            sinkage,
            angles,
            sin_entry: (depth_ratio * (2.0 - depth_ratio)).sqrt(),
            cos_entry: 1.0 - depth_ratio, // Eq. (3) at θ = 0
        }
    }

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
    ///
    /// All functions follow from those of the half arc x and of the entry: a = θ1 − x, θ = a − x.
    #[inline]
    pub(crate) fn rim_point(&self, arc: f64) -> RimPoint {
        let half_arc = 0.5 * arc;
        let HalfArc { sin, cos, excess } = HalfArc::of(half_arc);
        let sin_middle = self.sin_entry * cos - self.cos_entry * sin;
        let cos_middle = self.cos_entry * cos + self.sin_entry * sin;
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
            Some(zones) => zones.mobilisation(self, point),
        }
    }

    /// E (–) at the angle of maximum stress; 0 where two zones part there.
    #[must_use]
    pub fn peak_mobilisation(&self) -> f64 {
        self.mobilisation(&self.rim_point(self.angles.entry - self.angles.peak))
    }

    /// E (–) of a contact of one zone: what an endless displacement leaves, turned, all along the contact of a locked wheel.
    #[inline]
    pub(crate) fn mobilisation_of_one_zone(&self, point: &RimPoint) -> f64 {
        let soil = &self.rolling.system.soil;
        if self.rolling.slip.is_locked() { -soil.shear().residual() } else { soil.mobilisation(self.displacement(point)) }
    }

    /// Shear displacement j (m) at `theta` (rad): 0 at the entry, not negative on a driving wheel, infinite on a locked one
    /// (no finite displacement describes a wheel that does not turn). Eq. (6). Of two zones, positive in the front one and
    /// negative in the rear one.
    #[must_use]
    pub fn shear_displacement(&self, theta: f64) -> f64 {
        if let Some(zones) = self.zones() {
            zones.displacement(self, &self.rim_point(self.angles.entry - theta))
        } else if self.rolling.slip.is_locked() {
            f64::NEG_INFINITY
        } else {
            self.displacement(&self.rim_point(self.angles.entry - theta))
        }
    }

    /// Normal stress σ (Pa) at `theta` (rad); 0 outside the contact. Eq. (1).
    #[must_use]
    pub fn normal_stress(&self, theta: f64) -> f64 {
        self.stresses(theta).normal
    }

    /// Shear stress τ (Pa) at `theta` (rad); 0 outside the contact. Eq. (5).
    #[must_use]
    pub fn shear_stress(&self, theta: f64) -> f64 {
        self.stresses(theta).shear
    }

    /// Both stresses at `theta` (rad); 0 outside the contact.
    #[must_use]
    pub fn stresses(&self, theta: f64) -> Stresses {
        let Angles { entry, exit, .. } = self.angles;
        if !(exit..=entry).contains(&theta) {
            return Stresses { normal: 0.0, shear: 0.0 };
        }
        self.stresses_under(&self.rim_point(entry - theta), self.depth(theta))
    }

    /// Stresses at a place of the rim if the depth that presses there were `depth` (m). Eqs. (1), (5).
    #[inline]
    pub(crate) fn stresses_under(&self, point: &RimPoint, depth: f64) -> Stresses {
        let normal = self.rolling.pressure(depth);
        Stresses { normal, shear: self.mobilisation(point) * self.rolling.shear_strength(normal) }
    }

    /// Arc (rad) behind the entry over which E changes: the displacement by which its law scales, over dj/dδ at the entry.
    /// Infinite on a locked wheel, whose E is constant.
    pub(crate) fn shear_layer(&self) -> f64 {
        let Rolling { system, slip, .. } = self.rolling;
        let growth = system.wheel.radius() * (1.0 - self.rolling.velocity_ratio().0 * self.cos_entry).abs();
        if slip.is_locked() { f64::INFINITY } else { system.soil.shear_scale() / growth }
    }
}
