//! What do the wheels of a rover give together at one slip?

use super::{Vehicle, VehicleError, rut};
use crate::caution::Caution;
use crate::error::Error;
use crate::forces::Forces;
use crate::operating_point::Sinkage;
use crate::operation::Operation;
use crate::outcome::{Outcome, cautions};
use crate::slip::Slip;

/// One of the equal wheels of a station at work.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct VehicleWheel {
    /// Load (N).
    pub load: f64,
    /// Sinkage z (m) below the undisturbed surface.
    pub sinkage: f64,
    /// Depth (m) of the floor of the rut in which it runs, below the undisturbed surface; 0 where it runs in none.
    pub rut_depth: f64,
    /// The forces.
    pub forces: Forces,
    /// Way v/ω (m) of the rover while the wheel turns by one radian.
    pub travel_per_turn: f64,
}

impl VehicleWheel {
    /// Energy T ω/v (J/m) that the wheel takes for a metre of way; infinite on the spot.
    #[must_use]
    pub fn energy_per_metre(&self) -> f64 {
        self.forces.torque / self.travel_per_turn
    }

    /// Power T ω (W) at a velocity v (m/s) of the rover.
    #[must_use]
    pub fn power(&self, velocity: f64) -> f64 {
        velocity * self.energy_per_metre()
    }
}

/// A rover at one slip.
#[derive(Debug, Clone, PartialEq)]
pub struct Driven {
    /// The slip of all wheels.
    pub slip: Slip,
    /// One wheel of each station.
    pub wheels: Vec<VehicleWheel>,
    /// Σ F_x (N) over all wheels.
    pub pull: f64,
    /// Σ F_z (N).
    pub normal: f64,
    /// Σ T (N·m).
    pub torque: f64,
    /// Σ T ω/v (J/m): the energy for a metre of way.
    pub energy_per_metre: f64,
}

impl Driven {
    /// Power Σ T ω (W) at a velocity v (m/s).
    #[must_use]
    pub fn power(&self, velocity: f64) -> f64 {
        velocity * self.energy_per_metre
    }
}

impl Vehicle {
    /// The rover at `slip` with a load (N) on each wheel of each station, see [`Vehicle::loads`].
    ///
    /// # Errors
    /// [`VehicleError::Wheel`] with the first station whose wheel the model refuses.
    pub fn at(&self, slip: Slip, loads: &[f64]) -> Result<Driven, VehicleError> {
        let stations = &self.params.stations;
        let mut found: Vec<Option<VehicleWheel>> = vec![None; stations.len()];
        // Depth down to which each station has pressed its rut.
        let mut pressed = vec![0.0f64; stations.len()];
        for &(station, before) in &self.order {
            let Some(&load) = loads.get(station) else { return Err(VehicleError::NoWheels) };
            let depth = before.map_or(0.0, |before| pressed[before]);
            let wheel = self.wheel(station, slip, load, depth).map_err(|error| VehicleError::Wheel { station, error })?;
            pressed[station] = depth.max(wheel.sinkage);
            found[station] = Some(wheel);
        }
        let wheels: Vec<VehicleWheel> = found.into_iter().flatten().collect();
        let sum = |value: &dyn Fn(&VehicleWheel) -> f64| {
            stations.iter().zip(&wheels).map(|(station, wheel)| f64::from(station.count) * value(wheel)).sum()
        };
        Ok(Driven {
            slip,
            pull: sum(&|wheel| wheel.forces.longitudinal),
            normal: sum(&|wheel| wheel.forces.normal),
            torque: sum(&|wheel| wheel.forces.torque),
            energy_per_metre: sum(&VehicleWheel::energy_per_metre),
            wheels,
        })
    }

    /// A wheel of a station, in a rut that was pressed down to `pressed` (m), or in none.
    fn wheel(&self, station: usize, slip: Slip, load: f64, pressed: f64) -> Result<VehicleWheel, Error> {
        let of = &self.params.stations[station];
        let travel_per_turn = of.system.contact.circles().travel_per_turn(&of.system.wheel, slip);
        match self.params.unloading {
            Some(unloading) if pressed > 0.0 => {
                let found = rut::in_rut(&self.params.model, of, &unloading, (slip, load, pressed))?;
                let (sinkage, rut_depth) = (found.floor + found.sinkage, found.floor);
                Ok(VehicleWheel { load, sinkage, rut_depth, forces: found.forces, travel_per_turn })
            }
            _ => {
                let point = self.operation(station, load).at(slip)?;
                Ok(VehicleWheel { load, sinkage: point.sinkage, rut_depth: 0.0, forces: point.forces, travel_per_turn })
            }
        }
    }

    fn operation(&self, station: usize, load: f64) -> Operation {
        let system = self.params.stations[station].system;
        Operation { system, model: self.params.model, sinkage: Sinkage::CarryingLoad(load) }
    }

    /// What is to be taken with care of each station's wheel.
    pub fn cautions(&self, driven: &Driven) -> impl Iterator<Item = (usize, Caution)> {
        driven.wheels.iter().enumerate().flat_map(move |(station, wheel)| {
            let outcome = Outcome {
                slip: driven.slip,
                sinkage: wheel.sinkage - wheel.rut_depth,
                normal: Some(wheel.forces.normal),
                integration_error: wheel.forces.integration_error,
                mobilised_share: wheel.forces.side.map(|side| side.mobilised_share),
                standstill_normal: None,
            };
            let all: Vec<Caution> = cautions(&self.operation(station, wheel.load), &outcome).collect();
            all.into_iter().map(move |caution| (station, caution))
        })
    }
}
