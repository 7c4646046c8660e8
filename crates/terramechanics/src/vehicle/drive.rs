//! What do the wheels of a rover give together?

use super::{Consent, Drive, Told, Vehicle, VehicleError, rut};
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
    /// Slip s (–).
    pub slip: Slip,
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

/// A rover that drives.
#[derive(Debug, Clone, PartialEq)]
pub struct Driven {
    /// The slip of the wheels that turn together; at equal torques the largest of theirs.
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
    /// The rover whose wheels that turn together have `slip`, at equal torques as their largest, with a load (N) on each wheel of each
    /// station, see [`Vehicle::loads`].
    ///
    /// # Errors
    /// [`VehicleError::Wheel`] with the first station whose wheel the model refuses; [`VehicleError::TorqueNotHeld`].
    pub fn at(&self, slip: Slip, loads: &[f64]) -> Result<Driven, VehicleError> {
        let consent = Consent::new(&|| true);
        self.beside(&self.told(loads, &consent)?, slip, loads)
    }

    /// The same with those wheels that are told how to turn, as far as they are known.
    pub(super) fn beside(&self, told: &Told<'_>, slip: Slip, loads: &[f64]) -> Result<Driven, VehicleError> {
        if self.params.drive == Drive::EqualTorque {
            return self.at_equal_torque(told, slip, loads);
        }
        let stations = &self.params.stations;
        let mut found: Vec<Option<VehicleWheel>> = vec![None; stations.len()];
        // Depth down to which each station has pressed its rut.
        let mut pressed = vec![0.0f64; stations.len()];
        for &(station, before) in &self.order {
            let Some(&load) = loads.get(station) else { return Err(VehicleError::NoWheels) };
            let depth = before.map_or(0.0, |before| pressed[before]);
            let wheel = match told.wheels[station] {
                Some(wheel) => wheel,
                None => self.turned(station, slip, (load, depth), told.consent)?,
            };
            pressed[station] = depth.max(wheel.sinkage);
            found[station] = Some(wheel);
        }
        Ok(self.driven(slip, found.into_iter().flatten().collect()))
    }

    /// The sums over all wheels.
    pub(super) fn driven(&self, slip: Slip, wheels: Vec<VehicleWheel>) -> Driven {
        let stations = &self.params.stations;
        let sum = |value: &dyn Fn(&VehicleWheel) -> f64| {
            stations.iter().zip(&wheels).map(|(station, wheel)| f64::from(station.count) * value(wheel)).sum()
        };
        Driven {
            slip,
            pull: sum(&|wheel| wheel.forces.longitudinal),
            normal: sum(&|wheel| wheel.forces.normal),
            torque: sum(&|wheel| wheel.forces.torque),
            energy_per_metre: sum(&VehicleWheel::energy_per_metre),
            wheels,
        }
    }

    /// A wheel of a station under a load, in a rut that was pressed down to `pressed` (m), or in none.
    pub(super) fn wheel(
        &self,
        station: usize,
        slip: Slip,
        (load, pressed): (f64, f64),
        consent: &Consent<'_>,
    ) -> Result<VehicleWheel, Error> {
        consent.ask()?;
        let of = &self.params.stations[station];
        let travel_per_turn = of.system.contact.circles().travel_per_turn(&of.system.wheel, slip);
        match self.params.unloading {
            Some(unloading) if pressed > 0.0 => {
                let found = rut::in_rut(&self.params.model, of, &unloading, (slip, load, pressed))?;
                let (sinkage, rut_depth) = (found.floor + found.sinkage, found.floor);
                Ok(VehicleWheel { slip, load, sinkage, rut_depth, forces: found.forces, travel_per_turn })
            }
            _ => {
                let point = self.operation(station, load).at(slip)?;
                let (sinkage, forces) = (point.sinkage, point.forces);
                Ok(VehicleWheel { slip, load, sinkage, rut_depth: 0.0, forces, travel_per_turn })
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
                slip: wheel.slip,
                sinkage: wheel.sinkage - wheel.rut_depth,
                normal: Some(wheel.forces.normal),
                integration_error: wheel.forces.integration_error,
                mobilised_share: wheel.forces.side.map(|side| side.mobilised_share),
                standstill_normal: None,
                found_curve: None,
            };
            let all: Vec<Caution> = cautions(&self.operation(station, wheel.load), &outcome).collect();
            all.into_iter().map(move |caution| (station, caution))
        })
    }
}
