//! Forces by numerical integration of the stresses (letter, Eq. 10; Wong & Reece 1967).
//!
//! The rule. σ vanishes like the distance to the power N, not an integer, at the entry and at the exit, where plain
//! Gauss–Legendre converges slowly (1e-7 with 128 points). Four choices make it fast:
//!
//! * Both sides of the peak are run through by one variable t from their free end (entry or exit, t = 0) to the peak
//!   (t = 1). The depth behind the peak is the mirror image of the depth ahead of it (Eq. 4), so one σ(t) serves both.
//! * t = u⁴ turns the power N at the free end into 4N + 3, and crowds the points where a stiff shear law (small K) changes.
//!   Of u² … u⁶ it needed the fewest points over random wheels and soils.
//! * 24 points of Gauss–Legendre in u: 48 stresses reach 1e-13 on ordinary driving wheels.
//! * A braking wheel's E has a jump in its second derivative where j changes sign: the range is split there.
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
use crate::stress::{ContactPatch, RimPoint};

/// Layers of [`ContactPatch::shear_layer`] after which E is saturated: e^−20 = 2e-9 of a small share is left.
const LAYERS: f64 = 20.0;

/// Share of the range of u that the layer has to fall short of, to be split off; else the 24 points resolve it.
const THIN: f64 = 0.7;

pub(super) fn forces(model: &ForceModel, patch: &ContactPatch<'_>) -> Forces {
    let rim = Rim::of(patch);
    forces_of(model, &rim, &rim.edges(), |point| patch.mobilisation(point))
}

/// The forces where `mobilisation` is E along the rim and `edges` are the places where it is not smooth.
#[inline]
pub(super) fn forces_of(model: &ForceModel, rim: &Rim<'_>, edges: &Edges, mobilisation: impl Fn(&RimPoint) -> f64) -> Forces {
    let wheel = &rim.patch.rolling.system.wheel;
    let integrals = integrate(edges, |from, to| rim.panel(from, to, &mobilisation));
    let normal = model.normal_stress_radius(wheel) * wheel.width();
    let shear = wheel.shearing_radius() * wheel.width();
    let Sums { normal_cos, normal_sin, shear_cos, shear_sin, shear_plain, .. } = integrals;
    let components = Components {
        traction: shear * shear_cos,
        resistance: normal * normal_sin,
        normal_support: normal * normal_cos,
        shear_support: shear * shear_sin,
    };
    Forces::new(components, wheel.shearing_radius() * shear * shear_plain, integrals.relative_error())
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

    fn relative_error(&self) -> f64 {
        let share = |error: f64, size: f64| if size > 0.0 { error / size } else { 0.0 };
        ROUNDING + share(self.normal_error, self.normal_cos).max(share(self.shear_error, self.shear_size))
    }

    fn error_share(&self, total: &Self) -> f64 {
        (self.normal_error / total.normal_cos).max(self.shear_error / total.shear_size.max(f64::MIN_POSITIVE))
    }
}

/// The arcs of a contact.
pub(super) struct Rim<'a> {
    pub(super) patch: &'a ContactPatch<'a>,
    /// θ1 − θm, θm − θ2 and θ1 − θ2.
    pub(super) front: f64,
    pub(super) rear: f64,
    pub(super) whole: f64,
}

impl<'a> Rim<'a> {
    pub(super) fn of(patch: &'a ContactPatch<'a>) -> Self {
        let Angles { entry, peak, exit } = patch.angles;
        Self { patch, front: entry - peak, rear: peak - exit, whole: entry - exit }
    }

    /// Ends of the panels: the end of a thin layer of shear and the places where j changes sign.
    fn edges(&self) -> Edges {
        let mut edges = Edges::new();
        self.split_layer(&mut edges, self.patch.shear_layer());
        for &arc in self.patch.shear_reversals().arcs() {
            self.split(&mut edges, arc);
        }
        edges.close()
    }

    /// An edge behind a layer of that arc (rad) at the entry, if it is thin.
    pub(super) fn split_layer(&self, edges: &mut Edges, layer: f64) {
        edges.split(LAYERS * layer / self.front, THIN);
    }

    /// An edge at an arc (rad) behind the entry.
    pub(super) fn split(&self, edges: &mut Edges, arc: f64) {
        edges.split(if arc <= self.front { arc / self.front } else { (self.whole - arc) / self.rear }, 1.0);
    }

    #[inline]
    fn panel(&self, from: f64, to: f64, mobilisation: impl Fn(&RimPoint) -> f64) -> Sums {
        let Self { patch, front: front_arc, rear: rear_arc, whole } = *self;
        let length = to - from;
        let mut sums = Sums::default();
        for Node { place, weight, null } in &NODES {
            let u = from + length * place;
            let cube = u * u * u;
            let t = cube * u;
            let weight = length * weight * 4.0 * cube; // du → dt
            let front = patch.rim_point(t * front_arc);
            let rear = patch.rim_point(whole - t * rear_arc);
            let normal = patch.rolling.pressure(patch.geometric_depth(&front)); // Eqs. (1), (3), (4): the same on both sides
            let strength = patch.rolling.shear_strength(normal);
            let (front_weight, rear_weight) = (weight * front_arc, weight * rear_arc);
            let front_shear = front_weight * mobilisation(&front) * strength; // Eq. (5)
            let rear_shear = rear_weight * mobilisation(&rear) * strength;
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
