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
//! see `shear/`. At s < 0 the displacement may follow another law instead (`braking/`). All differences of circular functions are written as products, so that a light wheel on firm ground
//! (z/r = 1e-6) keeps its digits.

use crate::braking::Zones;
use crate::contact::{Angles, Contact};
use crate::error::Error;
use crate::numerics::brent::{Sample, bracketed_root};
use crate::numerics::circular::HalfArc;
use crate::pressure_sinkage::PlateConditions;
use crate::slip::Slip;
use crate::soil::Soil;
use crate::wheel::Wheel;

/// A wheel on a soil, touching it in a given way.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct WheelOnSoil {
    /// The wheel.
    pub wheel: Wheel,
    /// The soil.
    pub soil: Soil,
    /// How the contact lies on the rim.
    pub contact: Contact,
}

/// A wheel on a soil at one slip: all that does not depend on the sinkage.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Rolling<'a> {
    /// The wheel, the soil and the rule of the contact.
    pub system: &'a WheelOnSoil,
    /// The slip.
    pub slip: Slip,
    modulus: f64,
    exponent: f64,
    velocity_ratio: f64,
    velocity_complement: f64,
    /// θ0 where the law of braking has two zones.
    reversal: Option<f64>,
}

impl WheelOnSoil {
    /// The wheel rolling at `slip`.
    ///
    /// # Errors
    /// [`Error::ExponentNotPositive`] and [`Error::ModulusNotPositive`].
    #[inline(always)] // as a call it takes a third longer to the explicit forces: its answer passes through memory
    pub fn rolling(&self, slip: Slip) -> Result<Rolling<'_>, Error> {
        let law = self.soil.pressure_sinkage();
        let exponent = law.exponent().at(slip);
        if exponent <= 0.0 {
            return Err(Error::ExponentNotPositive { exponent });
        }
        let modulus = law.sinkage_modulus(&PlateConditions {
            width: self.wheel.width(),
            diameter: 2.0 * self.wheel.radius(),
            cohesion: self.soil.cohesion(),
            exponent,
        });
        if modulus.is_nan() || modulus <= 0.0 {
            return Err(Error::ModulusNotPositive { modulus });
        }
        let (velocity_ratio, velocity_complement) = slip.velocity_ratio();
        let reversal = self.contact.braking().reversal(slip, &self.soil);
        Ok(Rolling { system: self, slip, modulus, exponent, velocity_ratio, velocity_complement, reversal })
    }
}

impl Rolling<'_> {
    /// Sinkage modulus K_s (Pa/m^N).
    #[must_use]
    pub fn sinkage_modulus(&self) -> f64 {
        self.modulus
    }

    /// Sinkage exponent N (–).
    #[must_use]
    pub fn sinkage_exponent(&self) -> f64 {
        self.exponent
    }

    /// The contact at `sinkage` z (m).
    ///
    /// # Errors
    /// [`Error::SinkageOutsideWheel`] unless 0 < z ≤ r, [`Error::PeakOutsideContact`], [`Error::ReversalOutsideContact`].
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
        Ok(ContactPatch {
            rolling: self,
            sinkage,
            angles,
            sin_entry: (depth_ratio * (2.0 - depth_ratio)).sqrt(),
            cos_entry: 1.0 - depth_ratio, // Eq. (3) at θ = 0
        })
    }

    /// θ* (rad): the rim of a braking wheel slips forwards over the soil between −θ* and θ*, where cos θ > 1/κ, and backwards
    /// elsewhere; that of a driving wheel backwards throughout, and least at θ* = 0.
    pub(crate) fn turning(&self) -> f64 {
        // arccos(1 + s), written for small slip.
        2.0 * (-0.5 * self.slip.ratio().min(0.0)).sqrt().asin()
    }

    /// Sinkages (m) between which the wheel can have a contact: the lower one, not itself one of them, is 0 unless two zones
    /// take a depth of their own.
    pub(crate) fn sinkages(&self) -> (f64, f64) {
        let radius = self.system.wheel.radius();
        self.reversal.map_or((0.0, radius), |reversal| self.system.contact.sinkages_parted_at(reversal, radius))
    }

    /// κ = v/(rω) and 1 − κ.
    #[inline]
    pub(crate) fn velocity_ratio(&self) -> (f64, f64) {
        (self.velocity_ratio, self.velocity_complement)
    }

    /// σ (Pa) at `depth` (m). Eq. (1).
    #[inline]
    pub(crate) fn pressure(&self, depth: f64) -> f64 {
        self.modulus * depth.powf(self.exponent)
    }

    /// Shear strength c + σ tan φ (Pa). Eq. (5).
    #[inline]
    pub(crate) fn shear_strength(&self, normal_stress: f64) -> f64 {
        self.system.soil.cohesion() + normal_stress * self.system.soil.tan_friction()
    }
}

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
        let Rolling { velocity_ratio, velocity_complement, .. } = *self.rolling;
        2.0 * self.rolling.system.wheel.radius()
            * (velocity_complement * point.half_arc
                + velocity_ratio * (point.excess + point.sin_half_arc * point.one_minus_cos_middle))
    }

    /// Speed 1 − κ cos θ (–) of a place of the rim against the soil, backwards, over rω, for a turning wheel.
    #[inline]
    pub(crate) fn slip_velocity(&self, point: &RimPoint) -> f64 {
        let Rolling { velocity_ratio, velocity_complement, .. } = *self.rolling;
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

    /// Arc (rad) behind the entry over which E changes: the displacement by which its law scales, over dj/dδ at the entry. Infinite on a locked wheel, whose E is
    /// constant.
    pub(crate) fn shear_layer(&self) -> f64 {
        let Rolling { velocity_ratio, system, slip, .. } = self.rolling;
        let growth = system.wheel.radius() * (1.0 - velocity_ratio * self.cos_entry).abs();
        if slip.is_locked() { f64::INFINITY } else { system.soil.shear_scale() / growth }
    }

    /// Arcs δ = θ1 − θ (rad) behind the entry, ascending, at which j changes sign: only on a braking wheel, at most two,
    /// the second only behind the lowest point.
    ///
    /// With g(θ) = κ sin θ − θ, which is odd, j = r (g(θ) − g(θ1)); g rises between −θ* and θ* = arccos(1/κ) and falls
    /// outside. So j can vanish once on the rise and once more on the fall behind −θ*. Of two zones the one between them, the
    /// peak, is not listed, and θ0 < θ*.
    pub(crate) fn shear_reversals(&self) -> ShearReversals {
        let mut reversals = ShearReversals::default();
        let slip = self.rolling.slip;
        let Angles { entry, exit, .. } = self.angles;
        if slip.is_driving() || slip.is_locked() {
            return reversals;
        }
        let turning = self.rolling.turning();
        if self.has_two_zones() {
            self.push_reversal_between(-turning, exit, &mut reversals); // j falls from θ0 on, until it turns
            return reversals;
        }
        if turning >= entry {
            return reversals; // j falls from the entry on
        }
        for (front, rear) in [(turning, (-turning).max(exit)), (-turning, exit)] {
            self.push_reversal_between(front, rear, &mut reversals);
        }
        reversals
    }

    /// Adds the arc at which j changes sign between two angles (rad), if it does.
    fn push_reversal_between(&self, front: f64, rear: f64, reversals: &mut ShearReversals) {
        if rear >= front {
            return;
        }
        let at = |theta: f64| Sample { x: theta, y: self.shear_displacement(theta) };
        let (front, rear) = (at(front), at(rear));
        if front.y * rear.y >= 0.0 {
            return;
        }
        let find = |theta| Ok::<_, std::convert::Infallible>(self.shear_displacement(theta));
        // A reversal misplaced by ε changes the integral by about ε³, so this tolerance is ample.
        let Ok(found) = bracketed_root(find, front, rear, 1e-10);
        reversals.push(self.angles.entry - found.best.x);
    }
}

/// Up to two arcs (rad) at which the shear displacement changes sign.
#[derive(Debug, Clone, Copy, Default)]
pub(crate) struct ShearReversals {
    arcs: [f64; 2],
    count: usize,
}

impl ShearReversals {
    fn push(&mut self, arc: f64) {
        self.arcs[self.count] = arc;
        self.count += 1;
    }

    pub(crate) fn arcs(&self) -> &[f64] {
        &self.arcs[..self.count]
    }
}
