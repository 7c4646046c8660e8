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

use super::panel::{Integrals, Sums};
use super::panels::{Edges, Resolved, TOLERANCE, integrate};
use super::shearing::{LAYERS, Pressing, Rim, Shearing};
use super::{Components, ForceModel, Forces};
use crate::numerics::elementary::Number;
use crate::numerics::gauss_legendre::{COARSE, FINE};
use crate::numerics::level::level;
use crate::patch::ContactPatch;
use crate::rim::RimPoint;
use crate::stress::StressField;
use crate::zones::Zones;
use fearless_simd::dispatch;

/// Place in u behind which a layer at the peak has to begin, to be split off.
const LATE: f64 = 0.7;

pub(super) fn forces(model: &ForceModel, stresses: &StressField<'_>) -> Forces {
    let patch = stresses.patch;
    let rim = Rim::of(stresses);
    let integrals = match patch.zones() {
        None => integrals::<_, _, { OneZone::FEW }>(&rim, &OneZone(patch)),
        Some(zones) => integrals_of_two_zones(&rim, &zones),
    };
    forces_of(model, patch, &integrals.integrals, integrals.relative_error())
}

/// Halvings of the first panels after which a search by slopes is given up.
const HALVINGS: u32 = 2;

/// The forces of a contact and their changes against its entry angle (per rad), for a search of the sinkage: by few nodes
/// for a `coarse` look. None where a look that is not coarse needs more panels than such a search is worth.
pub(super) fn forces_and_changes(model: &ForceModel, stresses: &StressField<'_>, coarse: bool) -> Option<(Forces, Forces)> {
    let patch = stresses.patch;
    match patch.zones() {
        None => forces_and_changes_by(model, stresses, &OneZone(patch), coarse),
        Some(zones) => forces_and_changes_by(model, stresses, &TwoZones(patch, &zones), coarse),
    }
}

fn forces_and_changes_by<S: Shearing>(
    model: &ForceModel,
    stresses: &StressField<'_>,
    shearing: &S,
    coarse: bool,
) -> Option<(Forces, Forces)> {
    let patch = stresses.patch;
    let rim = Rim::of(stresses);
    let rates = &patch.rates();
    if coarse {
        let (sums, changes) =
            dispatch!(level(), simd => rim.sums_and_changes::<_, _, _, true>(simd, &COARSE, shearing, [0.0, 1.0], rates));
        return Some((forces_of(model, patch, &sums.integrals, sums.relative_error()), forces_of(model, patch, &changes, 0.0)));
    }
    let edges = shearing.edges(&rim);
    for halvings in 0..=HALVINGS {
        let (mut sums, mut changes) = (Sums::default(), Integrals::default());
        for range in edges.ranges(1 << halvings) {
            let (more, further) =
                dispatch!(level(), simd => rim.sums_and_changes::<_, _, _, true>(simd, &FINE, shearing, range, rates));
            sums.add(&more);
            changes.add(&further);
        }
        let error = sums.relative_error();
        if error <= TOLERANCE {
            return Some((forces_of(model, patch, &sums.integrals, error), forces_of(model, patch, &changes, 0.0)));
        }
    }
    None
}

/// The forces of a contact whose shear stress follows a law of its own.
pub(super) fn forces_by<P: Pressing, S: Shearing<P>, const FEW: usize>(
    model: &ForceModel,
    rim: &Rim<'_, P>,
    shearing: &S,
) -> Forces {
    let integrals = integrals::<P, S, FEW>(rim, shearing);
    forces_of(model, rim.patch, &integrals.integrals, integrals.relative_error())
}

#[inline]
pub(super) fn forces_of(model: &ForceModel, patch: &ContactPatch<'_>, integrals: &Integrals, error: f64) -> Forces {
    let wheel = &patch.rolling.system.wheel;
    let normal = model.normal_stress_radius(wheel) * wheel.width();
    let shear = wheel.shearing_radius() * wheel.width();
    let Integrals { normal_cos, normal_sin, shear_cos, shear_sin, shear_plain } = *integrals;
    let components = Components {
        traction: shear * shear_cos,
        resistance: normal * normal_sin,
        normal_support: normal * normal_cos,
        shear_support: shear * shear_sin,
    };
    Forces::new(components, wheel.shearing_radius() * shear * shear_plain, error)
}

/// The integrals, from at most `FEW` panels to begin with.
fn integrals<P: Pressing, S: Shearing<P>, const FEW: usize>(rim: &Rim<'_, P>, shearing: &S) -> Sums {
    integrate::<_, FEW>(&shearing.edges(rim), |from, to| dispatch!(level(), simd => rim.sums(simd, &FINE, shearing, [from, to])))
}

/// The integrals of a contact of two zones. Apart, so that other contacts do not carry its code along.
#[cold]
#[inline(never)]
fn integrals_of_two_zones(rim: &Rim<'_>, zones: &Zones) -> Sums {
    integrals::<_, _, { TwoZones::FEW }>(rim, &TwoZones(rim.patch, zones))
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
    fn ahead<F: Number>(&self, point: &RimPoint<F>) -> F {
        self.0.mobilisation_of_one_zone(point)
    }

    #[inline(always)]
    fn behind<F: Number>(&self, point: &RimPoint<F>) -> F {
        self.0.mobilisation_of_one_zone(point)
    }

    #[inline(always)]
    fn rate_ahead<F: Number>(&self, point: &RimPoint<F>, share: F, turn: F) -> F {
        self.0.mobilisation_rate(point, share, turn)
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
    #[inline(always)]
    fn ahead<F: Number>(&self, point: &RimPoint<F>) -> F {
        self.1.mobilisation_ahead(self.0.rolling, point)
    }

    #[inline(always)]
    fn behind<F: Number>(&self, point: &RimPoint<F>) -> F {
        self.1.mobilisation_behind(self.0.rolling, point)
    }

    #[inline(always)]
    fn rate_ahead<F: Number>(&self, point: &RimPoint<F>, share: F, turn: F) -> F {
        let Self(patch, zones) = *self;
        let rolling = patch.rolling;
        let entry_turn = patch.way().entry_turn([rolling.system.wheel.radius(), patch.sinkage], &patch.entry);
        let rate = zones.displacement_rate_ahead(&rolling.kinematics, point, [turn, turn.like(entry_turn)]);
        rolling.mobilisation_rate(zones.displacement_ahead(rolling, point), share, rate)
    }

    #[inline(always)]
    fn rate_behind<F: Number>(&self, point: &RimPoint<F>, share: F, turn: F) -> F {
        let Self(ContactPatch { rolling, .. }, zones) = self;
        let rate = zones.displacement_rate_behind(&rolling.kinematics, point, turn);
        rolling.mobilisation_rate(zones.displacement_behind(rolling, point), share, rate)
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
