//! Forces by numerical integration of the stresses (letter, Eq. 10; Wong & Reece 1967).
//!
//! The rule. σ vanishes like the distance to the power N, not an integer, at the entry and at the exit, where plain
//! Gauss–Legendre converges slowly (1e-7 with 128 points). These choices make it fast:
//!
//! * Both sides of the peak are run through by one variable t from their free end (entry or exit, t = 0) to the peak
//!   (t = 1). The depth behind the peak is the mirror image of the depth ahead of it (Eq. 4), so one σ(t) serves both.
//! * t = u⁴ turns the power N at the free end into 4N + 3, and crowds the points where a stiff shear law (small K) changes.
//!   Of u² … u⁶ it needed the fewest points over random wheels and soils.
//! * 24 points of Gauss–Legendre in u: 48 stresses reach 1e-13 on ordinary driving wheels.
//! * A braking wheel's E has a jump in its second derivative where j changes sign: the range is split there.
//! * Where a braking wheel has two zones (`braking/`), they part at the peak, and E saturates behind and ahead of it too.
//! * Where E saturates within a small part of the contact (K thousands of times smaller than the wheel, or a wheel all but
//!   locked), the range is split behind that layer, which the points might else step over.
//!
//! The same points tell how well the stresses are resolved (their highest two Legendre coefficients). Where that is not
//! enough – a shear modulus thousands of times smaller than the wheel, an exponent near 0 – the worst panel is halved,
//! at most [`PANELS`] times; the error estimate says what was reached.

use std::ops::Range;

use super::{Components, ForceModel, Forces};
use crate::braking::Zones;
use crate::contact::Angles;
use crate::numerics::gauss_legendre::{NODES, Node};
use crate::stress::{ContactPatch, RimPoint};

/// Panels after which no more are halved.
const PANELS: usize = 48;

/// Panels to begin with at the most: parted by a layer of shear and two reversals, or by three layers and a reversal.
const FEW_OF_ONE_ZONE: usize = 4;
const FEW_OF_TWO_ZONES: usize = 5;

/// Ends of so many panels.
const MOST_EDGES: usize = FEW_OF_TWO_ZONES + 1;

/// Layers of [`ContactPatch::shear_layer`] after which E is saturated: e^−20 = 2e-9 of a small share is left.
const LAYERS: f64 = 20.0;

/// Share of the range of u that the layer has to fall short of, to be split off; else the 24 points resolve it.
const THIN: f64 = 0.7;

/// Place in u behind which a layer at the peak has to begin, to be split off.
const LATE: f64 = 0.7;

/// Relative error at which refining stops.
const TOLERANCE: f64 = 1e-10;

/// Rounding left in any sum of this length.
const ROUNDING: f64 = 2e-15;

pub(super) fn forces(model: &ForceModel, patch: &ContactPatch<'_>) -> Forces {
    let wheel = &patch.rolling.system.wheel;
    let integrals = match patch.zones() {
        None => integrate::<_, FEW_OF_ONE_ZONE>(&Rim::of(patch, OneZone(patch))),
        Some(zones) => integrate_zones(patch, &zones),
    };
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

    /// Error from the null sums: the rule's own error falls about as their square, taken as the power 1.5 so that it is not
    /// underestimated where the coefficients decay slowly.
    fn estimate_errors(&mut self) {
        let estimate = |null: [f64; 2], size: f64| {
            let share = 10.0 * null[0].hypot(null[1]) / size;
            if size > 0.0 { size * share * share.sqrt() } else { 0.0 }
        };
        self.normal_error = estimate(self.normal_null, self.normal_cos);
        self.shear_error = estimate(self.shear_null, self.shear_size);
    }

    fn relative_error(&self) -> f64 {
        let share = |error: f64, size: f64| if size > 0.0 { error / size } else { 0.0 };
        ROUNDING + share(self.normal_error, self.normal_cos).max(share(self.shear_error, self.shear_size))
    }
}

/// A range of u and the sums over it.
#[derive(Clone, Copy, Default)]
struct Panel {
    from: f64,
    to: f64,
    sums: Sums,
}

/// The integrals, from at most `FEW` panels to begin with.
fn integrate<S: Shearing, const FEW: usize>(rim: &Rim<'_, S>) -> Sums {
    let (edges, count) = rim.edges();
    let mut few = [Panel::default(); FEW];
    let panels = &mut few[..count - 1];
    for (panel, edge) in panels.iter_mut().zip(edges.windows(2)) {
        *panel = rim.panel(edge[0], edge[1]);
    }
    let total = total(panels);
    if total.relative_error() <= TOLERANCE { total } else { refine(rim, panels) }
}

/// The integrals of a contact of two zones. Apart, so that other contacts do not carry its code along.
#[cold]
#[inline(never)]
fn integrate_zones(patch: &ContactPatch<'_>, zones: &Zones) -> Sums {
    integrate::<_, FEW_OF_TWO_ZONES>(&Rim::of(patch, TwoZones(patch, zones)))
}

fn total(panels: &[Panel]) -> Sums {
    let mut total = panels[0].sums;
    for panel in &panels[1..] {
        total.add(&panel.sums);
    }
    total
}

/// Halves the worst panel until the error is small enough or there are [`PANELS`]. Apart, because few contacts need it.
#[cold]
fn refine<S: Shearing>(rim: &Rim<'_, S>, coarse: &[Panel]) -> Sums {
    let mut panels = [Panel::default(); PANELS];
    panels[..coarse.len()].copy_from_slice(coarse);
    let mut used = coarse.len();
    loop {
        let total = total(&panels[..used]);
        if total.relative_error() <= TOLERANCE || used == PANELS {
            return total;
        }
        let share = |panel: &Panel| {
            let Sums { normal_error, shear_error, .. } = panel.sums;
            (normal_error / total.normal_cos).max(shear_error / total.shear_size.max(f64::MIN_POSITIVE))
        };
        let mut worst = 0;
        for i in 1..used {
            if share(&panels[i]) > share(&panels[worst]) {
                worst = i;
            }
        }
        let Panel { from, to, .. } = panels[worst];
        let middle = 0.5 * (from + to);
        panels[worst] = rim.panel(from, middle);
        panels[used] = rim.panel(middle, to);
        used += 1;
    }
}

/// How the soil is sheared on the two sides of the peak. A type of its own for each law, so that neither pays for the other.
trait Shearing {
    /// E at a place ahead of the peak, and at one behind it.
    fn ahead(&self, point: &RimPoint) -> f64;
    fn behind(&self, point: &RimPoint) -> f64;

    /// Tells `split` the places in t at which thin layers of shear end, and the value of u that each has to be below or above.
    fn split_layers(&self, front: f64, rear: f64, split: impl FnMut(f64, Range<f64>));
}

struct OneZone<'a>(&'a ContactPatch<'a>);

impl Shearing for OneZone<'_> {
    #[inline(always)]
    fn ahead(&self, point: &RimPoint) -> f64 {
        self.0.mobilisation_of_one_zone(point)
    }

    #[inline(always)]
    fn behind(&self, point: &RimPoint) -> f64 {
        self.0.mobilisation_of_one_zone(point)
    }

    #[inline(always)]
    fn split_layers(&self, front: f64, _rear: f64, mut split: impl FnMut(f64, Range<f64>)) {
        split(LAYERS * self.0.shear_layer() / front, 0.0..THIN);
    }
}

struct TwoZones<'a>(&'a ContactPatch<'a>, &'a Zones);

impl Shearing for TwoZones<'_> {
    fn ahead(&self, point: &RimPoint) -> f64 {
        self.1.mobilisation_ahead(self.0, point)
    }

    fn behind(&self, point: &RimPoint) -> f64 {
        self.1.mobilisation_behind(self.0, point)
    }

    fn split_layers(&self, front: f64, rear: f64, mut split: impl FnMut(f64, Range<f64>)) {
        let [entry, ahead, behind] = self.1.shear_layers(self.0).map(|layer| LAYERS * layer);
        split(entry / front, 0.0..THIN);
        split(1.0 - ahead / front, LATE..1.0);
        split(1.0 - behind / rear, LATE..1.0);
    }
}

/// The arcs of a contact.
struct Rim<'a, S> {
    patch: &'a ContactPatch<'a>,
    shearing: S,
    /// θ1 − θm, θm − θ2 and θ1 − θ2.
    front: f64,
    rear: f64,
    whole: f64,
}

impl<'a, S: Shearing> Rim<'a, S> {
    fn of(patch: &'a ContactPatch<'a>, shearing: S) -> Self {
        let Angles { entry, peak, exit } = patch.angles;
        Self { patch, shearing, front: entry - peak, rear: peak - exit, whole: entry - exit }
    }

    /// Ends of the panels in u, ascending: 0, the ends of thin layers of shear, the places where j changes sign, 1.
    fn edges(&self) -> ([f64; MOST_EDGES], usize) {
        let mut edges = [0.0; MOST_EDGES];
        let mut count = 1;
        let mut split = |t: f64, within: Range<f64>| {
            let u = t.sqrt().sqrt();
            if u > within.start && u < within.end {
                edges[count] = u;
                count += 1;
            }
        };
        self.shearing.split_layers(self.front, self.rear, &mut split);
        for &arc in self.patch.shear_reversals().arcs() {
            split(if arc <= self.front { arc / self.front } else { (self.whole - arc) / self.rear }, 0.0..1.0);
        }
        edges[count] = 1.0;
        count += 1;
        edges[..count].sort_unstable_by(f64::total_cmp);
        (edges, count)
    }

    fn panel(&self, from: f64, to: f64) -> Panel {
        let Self { patch, ref shearing, front: front_arc, rear: rear_arc, whole } = *self;
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
        Panel { from, to, sums }
    }
}
