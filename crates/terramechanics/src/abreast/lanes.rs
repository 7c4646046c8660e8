//! Points of one plan in lanes, eight at a time.

use super::{Found, Plan, Setting, Shared, Sought};
use crate::circles::Rings;
use crate::contact::Angles;
use crate::forces::{ClosedForces, Components, Leverage};
use crate::numerics::elementary::Number;
use crate::numerics::lanes::LANES;
use crate::numerics::level::level;
use crate::operating_point::OperatingPoint;
use crate::slip::Slip;
use fearless_simd::prelude::*;
use fearless_simd::{Level, Simd, dispatch, f64x8};

pub(crate) type Lanes = [f64; LANES];

/// Groups of lanes that are found in one go.
const GROUPS: usize = 8;

/// Points that are found in one go.
pub(crate) const ABREAST: usize = GROUPS * LANES;

/// What differs between the settings of one plan, in one group of lanes.
#[derive(Clone, Copy)]
struct Group {
    slip: Lanes,
    sinkage: Lanes,
    modulus: Lanes,
    exponent: Lanes,
}

impl Group {
    const NONE: Self = Self { slip: [0.0; LANES], sinkage: [0.0; LANES], modulus: [0.0; LANES], exponent: [0.0; LANES] };

    #[inline(always)]
    fn put(&mut self, lane: usize, of: &Setting) {
        self.slip[lane] = of.slip;
        self.sinkage[lane] = of.sinkage;
        self.modulus[lane] = of.modulus;
        self.exponent[lane] = of.exponent;
    }

    /// The settings of the group; all else is as in `fixed`.
    #[inline(always)]
    fn settings<L: Simd>(&self, simd: L, fixed: &Setting) -> Setting<f64x8<L>> {
        let Setting { radius, rings, leverage, load, .. } = *fixed;
        Setting {
            radius: f64x8::splat(simd, radius),
            rings: Rings {
                radius: f64x8::splat(simd, rings.radius),
                offset: f64x8::splat(simd, rings.offset),
                rho: f64x8::splat(simd, rings.rho),
                lead: f64x8::splat(simd, rings.lead),
            },
            leverage: Leverage {
                normal_area: f64x8::splat(simd, leverage.normal_area),
                shear_area: f64x8::splat(simd, leverage.shear_area),
                shearing_radius: f64x8::splat(simd, leverage.shearing_radius),
                cohesion: f64x8::splat(simd, leverage.cohesion),
                tan_friction: f64x8::splat(simd, leverage.tan_friction),
                per_shear_scale: f64x8::splat(simd, leverage.per_shear_scale),
            },
            slip: f64x8::simd_from(simd, self.slip),
            sinkage: f64x8::simd_from(simd, self.sinkage),
            modulus: f64x8::simd_from(simd, self.modulus),
            exponent: f64x8::simd_from(simd, self.exponent),
            load: f64x8::splat(simd, load),
        }
    }
}

/// What was found in one group of lanes.
#[derive(Clone, Copy)]
struct FoundGroup {
    found: Found<Lanes>,
    /// Greater than 0 where the forces are finite and the peak lies inside the contact.
    sound: Lanes,
}

impl<F: Number> Found<F> {
    /// Greater than 0 where the forces are finite and the peak lies inside the contact.
    #[inline(always)]
    fn sound(&self) -> F {
        let Angles { entry, peak, exit } = self.angles;
        let Components { traction, resistance, normal_support, shear_support } = self.forces.components;
        let sum = (traction.abs() + resistance.abs()) + (normal_support.abs() + shear_support.abs()) + self.forces.torque.abs();
        let front = (exit - peak).if_not_negative(-entry, entry - peak);
        front + (sum + exit) * 0.0 // not a number where one of them is not finite
    }
}

impl Found<Lanes> {
    #[inline(always)]
    fn of<L: Simd>(found: Found<f64x8<L>>) -> Self {
        let Found { sinkage, angles, forces, modulus, left } = found;
        let Components { traction, resistance, normal_support, shear_support } = forces.components;
        Self {
            sinkage: sinkage.into(),
            angles: Angles { entry: angles.entry.into(), peak: angles.peak.into(), exit: angles.exit.into() },
            forces: ClosedForces {
                components: Components {
                    traction: traction.into(),
                    resistance: resistance.into(),
                    normal_support: normal_support.into(),
                    shear_support: shear_support.into(),
                },
                torque: forces.torque.into(),
            },
            modulus: modulus.into(),
            left: left.into(),
        }
    }

    #[inline(always)]
    fn lane(&self, i: usize) -> Found {
        let Self { sinkage, angles, forces, modulus, left } = self;
        let Components { traction, resistance, normal_support, shear_support } = &forces.components;
        Found {
            sinkage: sinkage[i],
            angles: Angles { entry: angles.entry[i], peak: angles.peak[i], exit: angles.exit[i] },
            forces: ClosedForces {
                components: Components {
                    traction: traction[i],
                    resistance: resistance[i],
                    normal_support: normal_support[i],
                    shear_support: shear_support[i],
                },
                torque: forces.torque[i],
            },
            modulus: modulus[i],
            left: left[i],
        }
    }
}

/// Points of a plan, found together.
pub(crate) struct Abreast<'a> {
    plan: Plan<'a>,
    groups: [Group; GROUPS],
    found: [Option<FoundGroup>; GROUPS],
    level: Level,
}

impl<'a> Abreast<'a> {
    pub(crate) fn of(plan: Plan<'a>) -> Self {
        Self { plan, groups: [Group::NONE; GROUPS], found: [None; GROUPS], level: level() }
    }

    /// The points at up to [`ABREAST`] `slips`, each handed to `take` with its place; those that are not found here are none. A balance
    /// is perhaps `near` a sinkage (m).
    #[inline]
    pub(crate) fn find(&mut self, slips: &[Slip], near: Option<&[f64]>, mut take: impl FnMut(usize, Option<OperatingPoint>)) {
        let mut is_set = [false; ABREAST];
        let mut any = None;
        for (i, &slip) in slips.iter().enumerate() {
            if let Some(setting) = self.plan.setting(slip, near.map(|near| near[i])) {
                self.groups[i / LANES].put(i % LANES, &setting);
                (is_set[i], any) = (true, Some(setting));
            }
        }
        let groups = slips.len().div_ceil(LANES);
        if let Some(any) = any {
            // An idle lane does as another.
            for i in (0..groups * LANES).filter(|&i| !is_set[i]) {
                self.groups[i / LANES].put(i % LANES, &any);
            }
            let (plan, found) = (&self.plan, &mut self.found[..groups]);
            let groups = &self.groups[..groups];
            dispatch!(self.level, simd => plan.shared.find_groups(simd, plan, groups, found));
        }
        for (i, &slip) in slips.iter().enumerate() {
            let (group, lane) = (i / LANES, i % LANES);
            let exponent = self.groups[group].exponent[lane];
            let point = match &self.found[group] {
                Some(FoundGroup { found, sound }) if is_set[i] && sound[lane] > 0.0 => {
                    let found = found.lane(lane);
                    if self.plan.is_met(exponent, &found) { Some(self.plan.point(slip, exponent, &found)) } else { None }
                }
                _ => None,
            };
            take(i, point);
        }
    }
}

impl Shared<'_> {
    #[inline(always)]
    fn find_groups<L: Simd>(&self, simd: L, plan: &Plan<'_>, groups: &[Group], found: &mut [Option<FoundGroup>]) {
        if self.sought == Sought::Balance {
            for (group, found) in groups.iter().zip(found) {
                *found = in_memory(self.balance(&group.settings(simd, plan.fixed())));
            }
            return;
        }
        let mut frame = None;
        for (group, found) in groups.iter().zip(found) {
            let settings = group.settings(simd, plan.fixed());
            if frame.is_none() || !plan.has_one_contact() {
                frame = self.frame(&settings, settings.sinkage);
            }
            *found = match &frame {
                Some(frame) => in_memory(Some(self.forces(&settings, frame))),
                None => None,
            };
        }
    }
}

#[inline(always)]
#[expect(clippy::manual_map, reason = "what maps an option is not compiled for the lanes")]
fn in_memory<L: Simd>(found: Option<Found<f64x8<L>>>) -> Option<FoundGroup> {
    match found {
        Some(found) => Some(FoundGroup { sound: found.sound().into(), found: Found::of(found) }),
        None => None,
    }
}
