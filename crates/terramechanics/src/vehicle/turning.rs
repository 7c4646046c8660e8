//! How does each wheel turn: with the others, at a slip of its own, or under a torque of its own?
//!
//! One unknown is left to the sum of the pulls. It is the slip of the wheels that turn together, or, at equal torques, the largest slip
//! among them: the wheel that holds least torque T at that slip has it, and every other slips less, by as much as its T_i(s_i) = T asks.
//! So a limit of the slip holds for all of them, and the torques stay equal on wheels of different loads and soils.

use super::{Consent, Driven, Told, Turning, Vehicle, VehicleError, VehicleWheel};
use crate::error::Error;
use crate::numerics::brent::{Sample, bracketed_root};
use crate::slip::Slip;
use crate::slip_search::{Searched, slip_of_pull};

/// First step of the slip downward from a wheel that holds more than the torque; each step is twice the one before.
const STEP: f64 = 1.0 / 64.0;

/// Relative tolerance of a slip.
const TOLERANCE: f64 = 1e-13;

/// Largest miss of a torque, as a share of the torque by which the bracket misses it: beyond it the torque jumps.
const LARGEST_MISS: f64 = 1e-6;

impl Vehicle {
    /// The wheels that are told how to turn, under these loads (N). In ruts they depend on those before, and are left out here.
    pub(super) fn told<'a>(&self, loads: &[f64], consent: &'a Consent<'a>) -> Result<Told<'a>, VehicleError> {
        let params = self.params();
        let wheel = |(station, &load): (usize, &f64)| match params.stations.get(station).map(|of| of.turning) {
            Some(Turning::AtSlip(_) | Turning::UnderTorque(_)) if params.unloading.is_none() => {
                self.turned(station, Slip::ROLLING, (load, 0.0), consent).map(Some)
            }
            _ => Ok(None),
        };
        if loads.len() < params.stations.len() {
            return Err(VehicleError::NoWheels);
        }
        let wheels = loads.iter().enumerate().map(wheel).collect::<Result<_, _>>()?;
        Ok(Told { wheels, consent })
    }

    /// A wheel of each station at equal torques of those that turn together, the largest of whose slips is `largest`.
    pub(super) fn at_equal_torque(&self, told: &Told<'_>, largest: Slip, loads: &[f64]) -> Result<Driven, VehicleError> {
        let stations = &self.params().stations;
        let turns_together = |station: usize| stations[station].turning == Turning::Together;
        let mut wheels = Vec::with_capacity(stations.len());
        for (station, &load) in loads.iter().enumerate() {
            wheels.push(match told.wheels[station] {
                Some(wheel) => wheel,
                None => self.turned(station, largest, (load, 0.0), told.consent)?,
            });
        }
        let torques = wheels.iter().enumerate().filter(|(station, _)| turns_together(*station));
        let torque = torques.map(|(_, wheel)| wheel.forces.torque).fold(f64::INFINITY, f64::min);
        for (station, wheel) in wheels.iter_mut().enumerate() {
            if turns_together(station) && wheel.forces.torque > torque {
                *wheel = self.with_less_slip(station, torque, *wheel, told.consent)?;
            }
        }
        Ok(self.driven(largest, wheels))
    }

    /// A wheel of a station that turns as it should where those that turn together have the slip `together`, under a load (N) and in a
    /// rut that was pressed down so far (m).
    pub(super) fn turned(
        &self,
        station: usize,
        together: Slip,
        pressing: (f64, f64),
        consent: &Consent<'_>,
    ) -> Result<VehicleWheel, VehicleError> {
        let at = |slip: Slip| self.wheel(station, slip, pressing, consent);
        let of_station = |error| VehicleError::Wheel { station, error };
        match self.params().stations[station].turning {
            Turning::Together => at(together).map_err(of_station),
            Turning::AtSlip(slip) => at(slip).map_err(of_station),
            Turning::UnderTorque(torque) => {
                let torque_at = |slip: f64| Ok(at(Slip::new(slip)?)?.forces.torque);
                match slip_of_pull(torque_at, torque, (-1.0, 1.0)).map_err(of_station)? {
                    Searched::Met { slip } => Slip::new(slip).and_then(at).map_err(of_station),
                    Searched::Missed { slip, pull: reached, nearest } => {
                        Err(VehicleError::TorqueNotHeld { station, torque, reached, slip, nearest })
                    }
                }
            }
        }
    }

    /// The wheel of a station that holds `torque` (N·m), less than at the slip of `wheel`.
    fn with_less_slip(
        &self,
        station: usize,
        torque: f64,
        wheel: VehicleWheel,
        consent: &Consent<'_>,
    ) -> Result<VehicleWheel, VehicleError> {
        let at = |slip: f64| Slip::new(slip).and_then(|slip| self.wheel(station, slip, (wheel.load, 0.0), consent));
        let excess = |slip: f64| Ok::<f64, Error>(at(slip)?.forces.torque - torque);
        let of_station = |error| VehicleError::Wheel { station, error };
        let mut above = Sample { x: wheel.slip.ratio(), y: wheel.forces.torque - torque };
        let mut step = STEP;
        loop {
            let slip = (above.x - step).max(-1.0);
            let here = Sample { x: slip, y: excess(slip).map_err(of_station)? };
            if here.y <= 0.0 {
                let scale = above.y.max(-here.y);
                let found = bracketed_root(excess, here, above, TOLERANCE).map_err(of_station)?.best;
                if found.y.abs() <= LARGEST_MISS * scale {
                    return at(found.x).map_err(of_station);
                }
            }
            if here.y <= 0.0 || slip <= -1.0 {
                let (reached, nearest) = (here.y + torque, crate::pull::Nearest::Least);
                return Err(VehicleError::TorqueNotHeld { station, torque, reached, slip, nearest });
            }
            (above, step) = (here, 2.0 * step);
        }
    }
}
