//! How does a wheel run in the rut of the one before? By the soil's answer to repeated loading (Wong, Theory of Ground Vehicles, source 19).
//!
//! p = p_u − k_u (z_u − z) below the pressure p_u at the depth z_u from which it was unloaded, with k_u = k_0 + A_u z_u; beyond z_u the
//! soil yields as if it had never been unloaded. The forces follow from the pressure in `forces/rutted.rs`.
//!
//! k_0 is quoted as measured from 94e6 to 120e6 N/m³ and A_u from 2310e6 to 3746e6 N/m⁴; the book was not read, and no public text was
//! found to check these ranges by. The defaults are the middles. At the pressures of rovers
//! the soil comes back by tenths of a millimetre, so that the choice hardly matters.
//!
//! Simplified: the floor of the rut is flat along the rover and across the wheel, as deep as the wheels ahead pressed it and as wide as
//! the wheel in it. So a narrower follower runs as it should, and one of another radius. A wider one would meet undisturbed soil on
//! both sides of the rut, which carries it earlier and resists it more: its sinkage is taken too large, its resistance too
//! small. On another soil the depth is still that of the
//! wheels ahead, which that soil may not have let sink so far. [`Vehicle::unlike_ruts`] names both. p_u is
//! the pressure of the following wheel's own curve at z_u, so that its pressure has no jump. The soil comes back no higher than where it
//! lay. Its shear strength and its K are those of the undisturbed soil, although it has been pressed and sheared before. So a following
//! wheel meets half of the resistance or less, but its contact is shorter and mobilises less of the strength: where K is large or the
//! slip small, it pulls less than the wheel before it. No measured pull of a following wheel has been compared.

use super::{Station, Vehicle};
use crate::error::Error;
use crate::forces::rutted::{RutCurve, forces_in_rut};
use crate::forces::{ForceModel, Forces};
use crate::numerics::brent::{Sample, bracketed_root};
use crate::parameter::{Parameter, Presence, Requirement};
use crate::rolling::Rolling;
use crate::slip::Slip;

/// Relative tolerance of the sinkage.
const TOLERANCE: f64 = 1e-13;

/// Largest difference between the normal force and the load, over the load.
const LARGEST_RESIDUAL: f64 = 1e-9;

/// Steps outward for a bracket, each by a factor of two.
const BRACKET_STEPS: u32 = 60;

/// How soil comes back when it is unloaded.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Unloading {
    /// k_0 (N/m³).
    pub base: f64,
    /// A_u (N/m⁴).
    pub gain: f64,
}

impl Unloading {
    /// The middles of the ranges that were measured.
    pub const MEASURED: Self = Self { base: 107e6, gain: 3028e6 };

    /// k_0.
    pub const BASE: Parameter = Parameter {
        name: "k_0_n_m3",
        symbol: "k_0",
        unit: "N/m3",
        meaning: "Stiffness of unloading at the surface, k_u = k_0 + A_u z_u; measured from 94e6 to 120e6.",
        requirement: Requirement::Positive,
        least: 1.0,
        most: 1e15,
        presence: Presence::Default(Self::MEASURED.base),
    };

    /// A_u.
    pub const GAIN: Parameter = Parameter {
        name: "a_u_n_m4",
        symbol: "A_u",
        unit: "N/m4",
        meaning: "Gain of the stiffness of unloading with the depth, k_u = k_0 + A_u z_u; measured from 2310e6 to 3746e6.",
        requirement: Requirement::NotNegative,
        least: 0.0,
        most: 1e15,
        presence: Presence::Default(Self::MEASURED.gain),
    };

    /// What it is made of.
    pub const PARAMETERS: &'static [Parameter] = &[Self::BASE, Self::GAIN];

    pub(super) fn named(&self) -> [(&'static Parameter, f64); 2] {
        [(&Self::BASE, self.base), (&Self::GAIN, self.gain)]
    }
}

/// The stations from front to rear, each with the one in whose rut it runs. Of several at one place, the first follows the first before
/// it, the second the second, and those in excess the last.
pub(super) fn order(places: &[f64]) -> Vec<(usize, Option<usize>)> {
    let mut by_place: Vec<usize> = (0..places.len()).collect();
    by_place.sort_by(|&a, &b| places[b].total_cmp(&places[a]));
    let axles: Vec<&[usize]> = by_place.chunk_by(|&a, &b| places[a] == places[b]).collect();
    let mut order = Vec::with_capacity(places.len());
    for (i, axle) in axles.iter().enumerate() {
        let before = i.checked_sub(1).map(|before| axles[before]);
        for (lane, &station) in axle.iter().enumerate() {
            order.push((station, before.map(|before| before[lane.min(before.len() - 1)])));
        }
    }
    order
}

/// A rut that is taken for another than it is.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct UnlikeRut {
    /// The station that runs in it.
    pub station: usize,
    /// The station that pressed it.
    pub before: usize,
    /// Width of the wheel over that of the wheel ahead (–).
    pub width_ratio: f64,
    /// Whether the wheel stands on another soil than the wheel ahead.
    pub of_other_soil: bool,
}

impl Vehicle {
    /// The ruts whose wheel is wider than the one ahead, or stands on another soil.
    pub fn unlike_ruts(&self) -> impl Iterator<Item = UnlikeRut> {
        let system = |station: usize| self.params.stations.get(station).map(|of| &of.system);
        let rut = move |&(station, before): &(usize, Option<usize>)| {
            let before = before?;
            let (own, ahead) = (system(station)?, system(before)?);
            let width_ratio = own.wheel.width() / ahead.wheel.width();
            let of_other_soil = own.soil.params() != ahead.soil.params();
            Some(UnlikeRut { station, before, width_ratio, of_other_soil })
        };
        let ruts = self.order.iter().filter_map(rut);
        ruts.filter(|rut| rut.width_ratio > 1.0 || rut.of_other_soil)
    }
}

/// A wheel at rest on the floor of a rut.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct InRut {
    /// Depth of the floor (m) below the undisturbed surface.
    pub(super) floor: f64,
    /// Sinkage (m) below the floor.
    pub(super) sinkage: f64,
    pub(super) forces: Forces,
}

/// The wheel of a station at `slip` under `load` (N), in a rut that was pressed down to `pressed` (m).
pub(super) fn in_rut(
    model: &ForceModel,
    station: &Station,
    unloading: &Unloading,
    (slip, load, pressed): (Slip, f64, f64),
) -> Result<InRut, Error> {
    let rolling = station.system.rolling(slip)?;
    let curve = *rolling.curve()?;
    let pressure = curve.pressure(pressed);
    let rebound = (pressure / (unloading.base + unloading.gain * pressed)).min(pressed);
    let law = RutCurve { floor: pressed - rebound, rebound, stiffness: pressure / rebound, curve };
    let mut balance = Balance { model, rolling: &rolling, law: &law, load, evaluations: 0 };
    let (below, above) = balance.bracket()?;
    let found = bracketed_root(|sinkage| balance.excess(sinkage), below, above, TOLERANCE)?;
    let (sinkage, evaluations) = (found.best.x, balance.evaluations);
    let forces = balance.forces(sinkage)?;
    let residual = forces.normal - load;
    if found.converged && residual.abs() <= LARGEST_RESIDUAL * load {
        Ok(InRut { floor: law.floor, sinkage, forces })
    } else {
        Err(Error::LoadNotBalanced { load, iterations: evaluations, residual, sinkage: law.floor + sinkage })
    }
}

struct Balance<'a> {
    model: &'a ForceModel,
    rolling: &'a Rolling<'a>,
    law: &'a RutCurve,
    load: f64,
    evaluations: u32,
}

impl Balance<'_> {
    fn forces(&self, sinkage: f64) -> Result<Forces, Error> {
        forces_in_rut(self.model, &self.rolling.contact(sinkage)?, self.law)
    }

    fn excess(&mut self, sinkage: f64) -> Result<f64, Error> {
        self.evaluations += 1;
        Ok(self.forces(sinkage)?.normal - self.load)
    }

    fn sample(&mut self, sinkage: f64) -> Result<Sample, Error> {
        Ok(Sample { x: sinkage, y: self.excess(sinkage)? })
    }

    /// Two sinkages between which F_z rises through the load.
    fn bracket(&mut self) -> Result<(Sample, Sample), Error> {
        let radius = self.rolling.system.wheel.radius();
        let mut here = self.sample(self.law.rebound.min(radius))?;
        for _ in 0..BRACKET_STEPS {
            if here.y < 0.0 && here.x >= radius {
                let largest = here.y + self.load;
                return Err(Error::LoadBeyondCapacity { load: self.load, largest, sinkage: self.law.floor + radius });
            }
            let next = self.sample(if here.y < 0.0 { (2.0 * here.x).min(radius) } else { 0.5 * here.x })?;
            match (here.y < 0.0, next.y < 0.0) {
                (true, false) => return Ok((here, next)),
                (false, true) => return Ok((next, here)),
                _ => here = next,
            }
        }
        let sinkage = self.law.floor + here.x;
        Err(Error::LoadNotBalanced { load: self.load, iterations: self.evaluations, residual: here.y, sinkage })
    }
}
