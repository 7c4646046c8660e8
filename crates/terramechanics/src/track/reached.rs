//! The operating point of one sample.

use super::refusal::{Refused, positive, present};
use super::{Channel, Measured, Sample, SampleMotion, Status, TrackRow, Tracker};
use crate::contact::Angles;
use crate::coupled::Coupled;
use crate::error::Error;
use crate::forces::{Components, Forces, ShapeIntegrals};
use crate::motion::{Heading, Motion};
use crate::operating_point::{KnownSinkage, Sinkage};
use crate::outcome::Outcome;
use crate::pull_from_torque::CoupledForces;
use crate::rolling::WheelOnSoil;
use crate::slip::Slip;

/// The result of a good sample.
pub(super) struct Reached {
    pub(super) row: TrackRow,
    pub(super) outcome: Outcome,
    pub(super) heading: Heading,
    pub(super) coupled: Option<Result<CoupledForces, Uncoupled>>,
}

/// What is found at a sample, of the wheel moving forward.
struct Found {
    forces: Forces,
    outcome: Outcome,
    /// NaN where there is none, like the next.
    sinkage_modulus: f64,
    granular_stiffness: f64,
    coupled: Option<Result<CoupledForces, Uncoupled>>,
}

/// Why there is no pull by the coupled form.
pub(super) enum Uncoupled {
    Missing { torque: bool, load: bool },
    Unsolved(Error),
}

impl Tracker {
    /// The operating point of a sample. `slip` is set as soon as it is known, also where the rest has no solution.
    pub(super) fn reached(&self, sample: &Sample, slip: &mut f64) -> Result<Reached, Refused> {
        let (motion, angular) = self.motion(&sample.motion)?;
        *slip = motion.slip.ratio();
        match sample.sinkage {
            Sinkage::Given(sinkage) => self.measured_sinkage(sinkage)?,
            Sinkage::CarryingLoad(load) => positive(Channel::NormalLoad, load)?,
            Sinkage::FromStatic { static_sinkage, .. } => positive(Channel::Sinkage, static_sinkage)?,
            Sinkage::UnderLoad { sinkage, load } => {
                match sinkage {
                    KnownSinkage::Given(sinkage) => self.measured_sinkage(sinkage)?,
                    KnownSinkage::FromStatic { static_sinkage, .. } => positive(Channel::Sinkage, static_sinkage)?,
                }
                positive(Channel::NormalLoad, load)?;
            }
        }
        let found = if self.has_soil { self.on_soil(sample, motion)? } else { self.by_torque(sample, motion)? };
        let forces = found.forces.heading(motion.heading);
        let (wheel, circle) = (&self.operation.system.wheel, self.operation.system.contact.circles().slip);
        let power = angular.map_or(f64::NAN, |angular| forces.torque * angular);
        if power.is_infinite() {
            return Err(Refused::unsolved(Error::NotFinite));
        }
        let efficiency = || forces.tractive_efficiency(wheel, circle, motion.slip, motion.heading);
        let row = TrackRow {
            time: sample.time,
            slip: *slip,
            sinkage: found.outcome.sinkage,
            longitudinal: forces.longitudinal,
            normal: forces.normal,
            torque: forces.torque,
            drawbar_coefficient: forces.drawbar_coefficient().unwrap_or(f64::NAN),
            tractive_efficiency: if motion.at_rest { None } else { efficiency() }.unwrap_or(f64::NAN), // 0/0 at rest
            power,
            energy: f64::NAN,
            longitudinal_coupled: f64::NAN,
            sinkage_modulus: found.sinkage_modulus,
            granular_stiffness: found.granular_stiffness,
            status: if motion.at_rest { Status::Static } else { Status::Ok },
        };
        Ok(Reached { row, outcome: found.outcome, heading: motion.heading, coupled: found.coupled })
    }

    /// The forces by the method, on the soil.
    fn on_soil(&self, sample: &Sample, motion: Motion) -> Result<Found, Refused> {
        let near = self.solved.near(&sample.sinkage, motion.slip);
        let point = self.operation.near(motion.slip, &sample.sinkage, near).map_err(Refused::unsolved)?;
        Ok(Found {
            forces: point.forces,
            outcome: Outcome::from(&point),
            sinkage_modulus: point.sinkage_modulus().unwrap_or(f64::NAN),
            granular_stiffness: point.granular_stiffness.unwrap_or(f64::NAN),
            coupled: sample.measured.map(|measured| self.coupled(motion, point.sinkage, measured).map(|(_, forces)| forces)),
        })
    }

    /// The forces of the linear stresses that the torque and the load show, without a soil.
    fn by_torque(&self, sample: &Sample, motion: Motion) -> Result<Found, Refused> {
        let Sinkage::UnderLoad { sinkage, .. } = sample.sinkage else { return Err(Refused::missing(Channel::NormalLoad)) };
        let Some(measured) = sample.measured else { return Err(Refused::missing(Channel::Torque)) };
        present(Channel::Torque, measured.torque)?;
        let sinkage = sinkage.at(motion.slip);
        let (angles, coupled) = self.coupled(motion, sinkage, measured).map_err(|error| match error {
            Uncoupled::Missing { .. } => Refused::missing(Channel::NormalLoad),
            Uncoupled::Unsolved(error) => Refused::unsolved(error),
        })?;
        let wheel = &self.operation.system.wheel;
        let ShapeIntegrals { a, b, .. } = ShapeIntegrals::of(&angles);
        let x = self.operation.model.normal_stress_radius.of(wheel) * wheel.width() * coupled.peak_normal_stress;
        let y = wheel.shearing_radius() * wheel.width() * coupled.peak_shear_stress;
        let components = Components { traction: a * y, resistance: b * x, normal_support: a * x, shear_support: b * y };
        let forces = Forces::new(components, coupled.torque, 0.0);
        let outcome = Outcome {
            slip: motion.slip,
            sinkage,
            normal: Some(forces.normal),
            integration_error: 0.0,
            mobilised_share: None,
            standstill_normal: None,
            found_curve: None,
        };
        let (sinkage_modulus, granular_stiffness) = (f64::NAN, f64::NAN);
        Ok(Found { forces, outcome, sinkage_modulus, granular_stiffness, coupled: Some(Ok(coupled)) })
    }

    /// Refuses a measured sinkage (m) that is missing or that no contact has.
    fn measured_sinkage(&self, sinkage: f64) -> Result<(), Refused> {
        positive(Channel::Sinkage, sinkage)?;
        if sinkage > self.operation.system.wheel.radius() {
            return Err(Refused::out_of_range(Channel::Sinkage, sinkage));
        }
        Ok(())
    }

    /// Slip and heading, and the angular velocity (rad/s) where it is known.
    fn motion(&self, motion: &SampleMotion) -> Result<(Motion, Option<f64>), Refused> {
        match *motion {
            SampleMotion::Slip(ratio) => {
                if ratio.is_nan() {
                    return Err(Refused::missing(Channel::Slip));
                }
                let culprit = Some((Channel::Slip, ratio));
                let beyond = |error| Refused { status: Status::SlipOutOfRange, error: Some(error), culprit };
                Ok((Motion::forward(Slip::new(ratio).map_err(beyond)?), None))
            }
            SampleMotion::Velocities(velocities) => {
                present(Channel::ForwardVelocity, velocities.forward)?;
                present(Channel::AngularVelocity, velocities.angular)?;
                let WheelOnSoil { wheel, contact, .. } = &self.operation.system;
                let motion = Motion::of(wheel, contact.circles().slip, velocities).map_err(|error| {
                    let opposite = matches!(error, Error::OppositeRotation { .. });
                    let status = if opposite { Status::OppositeRotation } else { Status::OutOfRange };
                    Refused { status, error: Some(error), culprit: None }
                })?;
                Ok((motion, Some(velocities.angular)))
            }
        }
    }

    /// The coupled forms from the measured torque and load, for the wheel moving forward.
    fn coupled(&self, motion: Motion, sinkage: f64, measured: Measured) -> Result<(Angles, CoupledForces), Uncoupled> {
        let (torque, load) = (measured.torque.is_nan(), measured.normal_load.is_nan());
        if torque || load {
            return Err(Uncoupled::Missing { torque, load });
        }
        let known = Coupled {
            normal_load: measured.normal_load,
            torque: Some(motion.heading.as_forward(measured.torque)),
            normal_stress_radius: self.operation.model.normal_stress_radius,
        };
        known.at(&self.operation.system, motion.slip, sinkage).map_err(Uncoupled::Unsolved)
    }
}
