//! Which load does each wheel carry? Statics of a rigid body on wheels of equal stiffness.
//!
//! In the frame of the slope, with x along it and the moments about the ground:
//!
//! Σ N_i = W cos α,   Σ N_i x_i = W cos α x_c − W sin α h_c − D h_D.
//!
//! Three or more stations are held by more wheels than statics need. Under a rigid body on wheels of equal stiffness the loads are linear
//! in x, N_i = a + b (x_i − x̄), which the two sums determine. The pull D at the hitch acts along the slope at its height h_D, so that the
//! place of the hitch has no effect. Without a centre of mass every wheel carries the same.

use super::{CentreOfMass, Vehicle, VehicleError};

impl Vehicle {
    /// Load (N) on each wheel of each station on `slope` (rad), pulling `hitch_pull` (N).
    ///
    /// # Errors
    /// [`VehicleError::Invalid`] for a value out of range; [`VehicleError::Lifted`] with the first wheel that lifts off.
    pub fn loads(&self, slope: f64, hitch_pull: f64) -> Result<Vec<f64>, VehicleError> {
        let slope = Self::SLOPE.check(slope).map_err(VehicleError::Invalid)?;
        let hitch_pull = Self::HITCH_PULL.check(hitch_pull).map_err(VehicleError::Invalid)?;
        let stations = &self.params.stations;
        let (along, across) = (self.weight() * slope.sin(), self.weight() * slope.cos());
        let even = across / self.wheels;
        let Some(CentreOfMass { position, height }) = self.params.centre_of_mass else { return Ok(vec![even; stations.len()]) };
        let places = || stations.iter().map(|station| (f64::from(station.count), station.position.unwrap_or_default()));
        let middle = places().map(|(count, x)| count * x).sum::<f64>() / self.wheels;
        let spread: f64 = places().map(|(count, x)| count * (x - middle) * (x - middle)).sum();
        let tilt = (across * (position - middle) - along * height - hitch_pull * self.params.hitch_height) / spread;
        let loads: Vec<f64> = places().map(|(_, x)| even + tilt * (x - middle)).collect();
        match loads.iter().position(|load| load.is_nan() || *load <= 0.0) {
            Some(station) => Err(VehicleError::Lifted { station, load: loads[station], slope }),
            None => Ok(loads),
        }
    }
}
