//! Forces by numerical integration of the stresses (letter, Eq. 10; Wong & Reece 1967).
//!
//! The rule. σ vanishes like the distance to the power N, not an integer, at the entry and at the exit, where plain
//! Gauss–Legendre converges slowly. These choices make it fast:
//!
//! * Both sides of the peak are run through by one variable t from their free end (entry or exit, t = 0) to the peak
//!   (t = 1). The depth behind the peak is the mirror image of the depth ahead of it (Eq. 4), so one σ(t) serves both.
//! * t = u⁴ turns the power N at the free end into 4N + 3, and crowds the points where a stiff shear law (small K) changes.
//!   Of u² … u⁶ it needed the fewest points over random wheels and soils.
//! * Gauss–Legendre in u, with points enough that ordinary driving wheels need no more.
//! * A braking wheel's E has a jump in its second derivative where j changes sign: the range is split there.
//! * Where a braking wheel has two zones (`braking/`), they part at the peak, and E saturates behind and ahead of it too.
//! * Where E saturates within a small part of the contact (K thousands of times smaller than the wheel, or a wheel all but
//!   locked), the range is split behind that layer, which the points might else step over.
//!
//! The same points tell how well the stresses are resolved (their highest two Legendre coefficients). Where that is not
//! enough – a shear modulus thousands of times smaller than the wheel, an exponent near 0 – the worst panel is halved,
//! at most [`PANELS`](super::panels::PANELS) times; the error estimate says what was reached.

use super::panels::{Edges, ROUNDING, Resolved, error_of, integrate};
use super::{Components, ForceModel, Forces};
use crate::contact::Angles;
use crate::numerics::gauss_legendre::{NODES, Node};
use crate::patch::ContactPatch;
use crate::pressure_sinkage::PressureCurve;
use crate::rim::RimPoint;
use crate::stress::StressField;
use crate::zones::Zones;

/// Layers of [`ContactPatch::shear_layer`] after which E is saturated: e to the minus this of a small share is left.
const LAYERS: f64 = 20.0;

/// Share of the range of u that the layer has to fall short of, to be split off; else the points resolve it.
const THIN: f64 = 0.7;

/// Place in u behind which a layer at the peak has to begin, to be split off.
const LATE: f64 = 0.7;

pub(super) fn forces(model: &ForceModel, stresses: &StressField<'_>) -> Forces {
    let patch = stresses.patch;
    let rim = Rim::of(stresses);
    let integrals = match patch.zones() {
        None => integrals::<_, _, { OneZone::FEW }>(&rim, &OneZone(patch)),
        Some(zones) => integrals_of_two_zones(&rim, &zones),
    };
    forces_of(model, patch, &integrals)
}

/// The forces of a contact whose shear stress follows a law of its own.
pub(super) fn forces_by<P: Pressing, S: Shearing<P>, const FEW: usize>(
    model: &ForceModel,
    rim: &Rim<'_, P>,
    shearing: &S,
) -> Forces {
    forces_of(model, rim.patch, &integrals::<P, S, FEW>(rim, shearing))
}

#[inline]
fn forces_of(model: &ForceModel, patch: &ContactPatch<'_>, integrals: &Sums) -> Forces {
    let wheel = &patch.rolling.system.wheel;
    let normal = model.normal_stress_radius(wheel) * wheel.width();
    let shear = wheel.shearing_radius() * wheel.width();
    let Sums { normal_cos, normal_sin, shear_cos, shear_sin, shear_plain, .. } = *integrals;
    let components = Components {
        traction: shear * shear_cos,
        resistance: normal * normal_sin,
        normal_support: normal * normal_cos,
        shear_support: shear * shear_sin,
    };
    Forces::new(components, wheel.shearing_radius() * shear * shear_plain, integrals.relative_error())
}

/// The integrals, from at most `FEW` panels to begin with.
fn integrals<P: Pressing, S: Shearing<P>, const FEW: usize>(rim: &Rim<'_, P>, shearing: &S) -> Sums {
    integrate::<_, FEW>(&shearing.edges(rim), |from, to| rim.panel(shearing, from, to))
}

/// The integrals of a contact of two zones. Apart, so that other contacts do not carry its code along.
#[cold]
#[inline(never)]
fn integrals_of_two_zones(rim: &Rim<'_>, zones: &Zones) -> Sums {
    integrals::<_, _, { TwoZones::FEW }>(rim, &TwoZones(rim.patch, zones))
}

/// Sums over a panel, or over all of them.
#[derive(Clone, Copy, Default)]
struct Sums {
    /// ∫ σ cos θ dθ.
    normal_cos: f64,
    /// ∫ σ sin θ dθ.
    normal_sin: f64,
    /// ∫ τ cos θ dθ.
    shear_cos: f64,
    /// ∫ τ sin θ dθ.
    shear_sin: f64,
    /// ∫ τ dθ.
    shear_plain: f64,
    /// ∫ |τ| dθ, the scale of the shear's error.
    shear_size: f64,
    /// Null sums of σ and of τ.
    normal_null: [f64; 2],
    shear_null: [f64; 2],
    /// Error estimates, comparable with normal_cos and with shear_size.
    normal_error: f64,
    shear_error: f64,
}

impl Sums {
    fn estimate_errors(&mut self) {
        self.normal_error = error_of(self.normal_null, self.normal_cos);
        self.shear_error = error_of(self.shear_null, self.shear_size);
    }
}

impl Resolved for Sums {
    #[inline]
    fn add(&mut self, other: &Self) {
        self.normal_cos += other.normal_cos;
        self.normal_sin += other.normal_sin;
        self.shear_cos += other.shear_cos;
        self.shear_sin += other.shear_sin;
        self.shear_plain += other.shear_plain;
        self.shear_size += other.shear_size;
        self.normal_error += other.normal_error;
        self.shear_error += other.shear_error;
    }

    #[inline]
    fn relative_error(&self) -> f64 {
        let share = |error: f64, size: f64| if size > 0.0 { error / size } else { 0.0 };
        ROUNDING + share(self.normal_error, self.normal_cos).max(share(self.shear_error, self.shear_size))
    }

    fn error_share(&self, total: &Self) -> f64 {
        (self.normal_error / total.normal_cos).max(self.shear_error / total.shear_size.max(f64::MIN_POSITIVE))
    }
}

/// How the soil presses on the rim at a depth.
pub(super) trait Pressing {
    /// Normal stress (Pa) under a depth (m).
    fn pressure(&self, depth: f64) -> f64;
}

impl Pressing for PressureCurve {
    #[inline(always)]
    fn pressure(&self, depth: f64) -> f64 {
        PressureCurve::pressure(self, depth)
    }
}

/// How the soil is sheared on the two sides of the peak. A type of its own for each law, so that neither pays for the other.
pub(super) trait Shearing<P = PressureCurve> {
    /// E at a place ahead of the peak, and at one behind it.
    fn ahead(&self, point: &RimPoint) -> f64;
    fn behind(&self, point: &RimPoint) -> f64;

    /// Ends of the panels: the ends of thin layers of shear, and the places where E is not smooth.
    fn edges(&self, rim: &Rim<'_, P>) -> Edges;
}

pub(super) struct OneZone<'a>(pub(super) &'a ContactPatch<'a>);

impl OneZone<'_> {
    /// Panels to begin with at the most: parted by a layer of shear and two reversals.
    pub(super) const FEW: usize = 4;

    /// Ends of the panels but for the last one.
    #[inline(always)]
    pub(super) fn open_edges<P: Pressing>(&self, rim: &Rim<'_, P>) -> Edges {
        let mut edges = Edges::new();
        rim.split_layer(&mut edges, self.0.shear_layer());
        rim.split_reversals(&mut edges);
        edges
    }
}

impl<P: Pressing> Shearing<P> for OneZone<'_> {
    #[inline(always)]
    fn ahead(&self, point: &RimPoint) -> f64 {
        self.0.mobilisation_of_one_zone(point)
    }

    #[inline(always)]
    fn behind(&self, point: &RimPoint) -> f64 {
        self.0.mobilisation_of_one_zone(point)
    }

    #[inline(always)]
    fn edges(&self, rim: &Rim<'_, P>) -> Edges {
        self.open_edges(rim).close()
    }
}

struct TwoZones<'a>(&'a ContactPatch<'a>, &'a Zones);

impl TwoZones<'_> {
    /// Panels to begin with at the most: parted by three layers of shear and a reversal.
    const FEW: usize = 5;
}

impl Shearing for TwoZones<'_> {
    fn ahead(&self, point: &RimPoint) -> f64 {
        self.1.mobilisation_ahead(self.0.rolling, point)
    }

    fn behind(&self, point: &RimPoint) -> f64 {
        self.1.mobilisation_behind(self.0.rolling, point)
    }

    fn edges(&self, rim: &Rim<'_>) -> Edges {
        let mut edges = Edges::new();
        let [entry, ahead, behind] = self.1.shear_layers(self.0.rolling, self.0.sinkage);
        rim.split_layer(&mut edges, entry);
        edges.split(1.0 - LAYERS * ahead / rim.front, LATE..1.0);
        edges.split(1.0 - LAYERS * behind / rim.rear, LATE..1.0);
        rim.split_reversals(&mut edges);
        edges.close()
    }
}

/// The arcs of a contact.
pub(super) struct Rim<'a, P = PressureCurve> {
    pub(super) patch: &'a ContactPatch<'a>,
    pub(super) curve: &'a P,
    /// θ1 − θm, θm − θ2 and θ1 − θ2.
    pub(super) front: f64,
    pub(super) rear: f64,
    pub(super) whole: f64,
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
        Self { patch, curve, front: entry - peak, rear: peak - exit, whole: entry - exit }
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

    fn panel<S: Shearing<P>>(&self, shearing: &S, from: f64, to: f64) -> Sums {
        let Self { patch, curve, front: front_arc, rear: rear_arc, whole } = *self;
        let length = to - from;
        let mut sums = Sums::default();
        for Node { place, weight, null } in &NODES {
            let u = from + length * place;
            let cube = u * u * u;
            let t = cube * u;
            let weight = length * weight * 4.0 * cube; // du → dt
            let front = patch.rim_point(t * front_arc);
            let rear = patch.rim_point(whole - t * rear_arc);
            let normal = curve.pressure(patch.geometric_depth(&front)); // Eqs. (1), (3), (4): the same on both sides
            let strength = patch.rolling.shear_strength(normal);
            let (front_weight, rear_weight) = (weight * front_arc, weight * rear_arc);
            let front_shear = front_weight * shearing.ahead(&front) * strength; // Eq. (5)
            let rear_shear = rear_weight * shearing.behind(&rear) * strength;
            let both_shear = front_shear + rear_shear;
            let both_normal = (front_weight + rear_weight) * normal;
            sums.normal_cos += normal * (front_weight * front.cos + rear_weight * rear.cos);
            sums.normal_sin += normal * (front_weight * front.sin + rear_weight * rear.sin);
            sums.shear_cos += front_shear * front.cos + rear_shear * rear.cos;
            sums.shear_sin += front_shear * front.sin + rear_shear * rear.sin;
            sums.shear_plain += both_shear;
            sums.shear_size += front_shear.abs() + rear_shear.abs();
            let [high, higher] = *null;
            sums.normal_null[0] += both_normal * high;
            sums.normal_null[1] += both_normal * higher;
            sums.shear_null[0] += both_shear * high;
            sums.shear_null[1] += both_shear * higher;
        }
        sums.estimate_errors();
        sums
    }
}
