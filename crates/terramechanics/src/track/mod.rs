//! How do sinkage, forces, power and energy of a wheel develop over time? Telemetry, one sample after another.
//!
//! Each sample is an operating point of its own: nothing but time, energy and events carries over, so memory stays constant
//! and a row does not depend on the rows before it.
//!
//! * Power P = T ω; energy ∫ P dt by the trapezoidal rule, exact where the power is linear between samples.
//! * A sample without a result counts as not sent: the trapezoid spans the gap between its neighbours. Where the time runs
//!   backwards, no energy is added and the count goes on from the new time.
//! * At rest, v = ω = 0, the slip is 0 by convention (letter, Eq. 2) and the row is that of the rolling limit s → 0; its power
//!   is 0 because ω is.
//! * A wheel that the soil does not carry at any sinkage up to its axle has no forces, but it counts as entrapped.

mod sample;
mod tally;

pub use sample::{Measured, Sample, SampleMotion, Status, TrackRow};
pub use tally::{CautionTally, Tally};

use crate::caution::{Outcome, cautions};
use crate::coupled::{Coupled, CoupledForces};
use crate::error::{Error, InvalidInput};
use crate::events::{Event, EventKind, Thresholds, Watch};
use crate::operation::{Operation, Sinkage};
use crate::slip::{Heading, Motion, Slip, Velocities};
use crate::stress::WheelOnSoil;
use tally::CompensatedSum;

/// Follows a wheel over time.
#[derive(Debug, Clone)]
pub struct Tracker {
    operation: Operation,
    entrapment_sinkage: f64,
    stall_slip: f64,
    stall: Watch,
    entrapment: Watch,
    events: Vec<Event>,
    events_left_out: u64,
    rows: u64,
    latest_time: Option<f64>,
    /// Time and power of the last good sample.
    latest_power: Option<(f64, f64)>,
    energy: CompensatedSum,
    tallies: [Option<Tally>; Status::ALL.len()],
    not_coupled: Option<Tally>,
    cautions: Vec<CautionTally>,
    backward: bool,
}

/// Events that are kept; a run with more is told how many there were.
const MOST_EVENTS: usize = 1000;

/// What one sample gives where it is good.
struct Reached {
    row: TrackRow,
    outcome: Outcome,
    heading: Heading,
    coupled: Option<Result<CoupledForces, Error>>,
}

impl Tracker {
    /// A tracker at its start, by the wheel, the soil and the method of `operation`; how the sinkage is known, each sample says.
    ///
    /// # Errors
    /// Every threshold outside its range.
    ///
    /// ```
    /// use terramechanics::*;
    /// # let exponent = SinkageExponent { base: 0.91, slip_gain: 0.0, skid_gain: None };
    /// # let system = WheelOnSoil {
    /// #     wheel: Wheel::new(WheelParams { radius: 0.2, width: 0.1, lug_height: 0.0, lug_coefficient: 0.5 })?,
    /// #     soil: Soil::new(SoilParams {
    /// #         cohesion: 0.0,
    /// #         friction_angle: 0.478,
    /// #         shear: ShearLaw::JanosiHanamoto(JanosiHanamoto { modulus: 0.005 }),
    /// #         pressure_sinkage: PressureSinkage::Bekker(Bekker { k_c: -660.0, k_phi: 754_130.0, exponent }),
    /// #         unit_weight: None,
    /// #         lateral_shear_modulus: None,
    /// #     })?,
    /// #     contact: Contact::MIDPOINT,
    /// # };
    /// let sinkage = Sinkage::Given(0.02);
    /// let operation = Operation { system, model: ForceModel::at_rim(Method::Quadrature), sinkage };
    /// let mut tracker = Tracker::new(operation, Thresholds::default())?;
    /// for second in 0..=2 {
    ///     let velocities = Velocities { forward: 0.16, angular: 1.0 }; // 20 % slip
    ///     let sample = Sample {
    ///         time: f64::from(second),
    ///         motion: SampleMotion::Velocities(velocities),
    ///         sinkage,
    ///         measured: None,
    ///     };
    ///     let row = tracker.push(&sample);
    ///     // 7.3396 N·m by an independent integration; at 1 rad/s that many watts.
    ///     assert!((row.power - 7.3396).abs() < 5e-5);
    ///     assert!((row.energy - 7.3396 * f64::from(second)).abs() < 1e-4);
    /// }
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    pub fn new(operation: Operation, thresholds: Thresholds) -> Result<Self, InvalidInput> {
        thresholds.check()?;
        Ok(Self {
            operation,
            entrapment_sinkage: thresholds.entrapment_share * operation.system.wheel.radius(),
            stall_slip: thresholds.stall_slip,
            stall: Watch::new(EventKind::Stall, thresholds.stall_time),
            entrapment: Watch::new(EventKind::Entrapment, 0.0),
            events: Vec::new(),
            events_left_out: 0,
            rows: 0,
            latest_time: None,
            latest_power: None,
            energy: CompensatedSum::default(),
            tallies: [None; Status::ALL.len()],
            not_coupled: None,
            cautions: Vec::new(),
            backward: false,
        })
    }

    /// What follows from the next sample.
    pub fn push(&mut self, sample: &Sample) -> TrackRow {
        let index = self.rows;
        self.rows += 1;
        let mut slip = f64::NAN;
        let outcome = self.in_time(sample.time).and_then(|()| self.reached(sample, &mut slip));
        let (row, error) = match outcome {
            Ok(reached) => (self.accept(index, sample.sinkage, reached), None),
            Err((status, error)) => (TrackRow::bad(sample.time, slip, status), error),
        };
        Tally::count(&mut self.tallies[row.status as usize], index, error);
        self.watch(index, &row, error);
        row
    }

    /// Whether the sample follows the one before in time.
    fn in_time(&mut self, time: f64) -> Result<(), Refused> {
        present(time)?;
        let backwards = self.latest_time.replace(time).is_some_and(|latest| time < latest);
        if backwards {
            self.latest_power = None; // the interval has no length
            self.finish();
            return Err((Status::TimeBackwards, None));
        }
        Ok(())
    }

    /// The operating point of a sample; its slip is told as well where there is no more than that.
    fn reached(&self, sample: &Sample, slip: &mut f64) -> Result<Reached, Refused> {
        let (motion, angular) = self.motion(&sample.motion)?;
        *slip = motion.slip.ratio();
        match sample.sinkage {
            Sinkage::Given(sinkage) => positive(sinkage)?,
            Sinkage::CarryingLoad(load) => positive(load)?,
            Sinkage::FromStatic { static_sinkage, .. } => positive(static_sinkage)?,
        }
        if let Some(Measured { torque, normal_load }) = sample.measured {
            present(torque)?;
            positive(normal_load)?;
        }
        let unsolved = |error| (Status::NoSolution, Some(error));
        let operation = Operation { sinkage: sample.sinkage, ..self.operation };
        let point = operation.at(motion.slip).map_err(unsolved)?;
        let forces = point.forces.heading(motion.heading);
        let wheel = &operation.system.wheel;
        let power = angular.map_or(f64::NAN, |angular| forces.torque * angular);
        if power.is_infinite() {
            return Err(unsolved(Error::NotFinite));
        }
        let at_rest = matches!(sample.motion, SampleMotion::Velocities(Velocities { forward: 0.0, angular: 0.0 }));
        let row = TrackRow {
            time: sample.time,
            slip: *slip,
            sinkage: point.sinkage,
            longitudinal: forces.longitudinal,
            normal: forces.normal,
            torque: forces.torque,
            drawbar_coefficient: forces.drawbar_coefficient().unwrap_or(f64::NAN),
            tractive_efficiency: forces.tractive_efficiency(wheel, motion.slip, motion.heading).unwrap_or(f64::NAN),
            power,
            energy: f64::NAN,
            longitudinal_coupled: f64::NAN,
            status: if at_rest { Status::Static } else { Status::Ok },
        };
        let coupled = sample.measured.map(|measured| self.coupled(motion, point.sinkage, measured));
        Ok(Reached { row, outcome: Outcome::from(&point), heading: motion.heading, coupled })
    }

    /// Slip and heading, and the angular velocity (rad/s) where it is known.
    fn motion(&self, motion: &SampleMotion) -> Result<(Motion, Option<f64>), Refused> {
        match *motion {
            SampleMotion::Slip(ratio) => {
                if ratio.is_nan() {
                    return Err((Status::MissingValue, None));
                }
                let slip = Slip::new(ratio).map_err(|error| (Status::SlipOutOfRange, Some(error)))?;
                Ok((Motion { slip, heading: Heading::Forward }, None))
            }
            SampleMotion::Velocities(velocities) => {
                present(velocities.forward)?;
                present(velocities.angular)?;
                let motion = Motion::of(&self.operation.system.wheel, velocities).map_err(|error| match error {
                    Error::OppositeRotation { .. } => (Status::OppositeRotation, Some(error)),
                    _ => (Status::OutOfRange, Some(error)),
                })?;
                Ok((motion, Some(velocities.angular)))
            }
        }
    }

    /// What follows from the measured torque and load, of the wheel moving forward.
    fn coupled(&self, motion: Motion, sinkage: f64, measured: Measured) -> Result<CoupledForces, Error> {
        let rolling = self.operation.system.rolling(motion.slip)?;
        let ahead = if motion.heading == Heading::Backward { -measured.torque } else { measured.torque };
        let known = Coupled {
            normal_load: measured.normal_load,
            torque: Some(ahead),
            normal_stress_radius: self.operation.model.normal_stress_radius,
        };
        known.forces(&rolling.contact(sinkage)?)
    }

    /// Adds the energy up to a good sample, and what the run remembers of it.
    fn accept(&mut self, index: u64, sinkage: Sinkage, reached: Reached) -> TrackRow {
        let Reached { mut row, outcome, heading, coupled } = reached;
        if row.power.is_finite() {
            if let Some((time, power)) = self.latest_power {
                self.energy.add(0.5 * (power + row.power) * (row.time - time));
            }
            self.latest_power = Some((row.time, row.power));
            row.energy = self.energy.value();
        }
        match coupled {
            Some(Ok(forces)) => {
                row.longitudinal_coupled = forces.heading(heading).longitudinal;
                CautionTally::count(&mut self.cautions, index, forces.caution().into_iter());
            }
            Some(Err(error)) => Tally::count(&mut self.not_coupled, index, Some(error)),
            None => {}
        }
        self.backward |= heading == Heading::Backward;
        let operation = Operation { sinkage, ..self.operation };
        CautionTally::count(&mut self.cautions, index, cautions(&operation, &outcome));
        row
    }

    /// Looks for events. A sample of which nothing is known neither starts nor ends one.
    fn watch(&mut self, index: u64, row: &TrackRow, error: Option<Error>) {
        let beyond_axle = match error {
            Some(Error::LoadBeyondCapacity { .. }) => true,
            Some(Error::SinkageOutsideWheel { sinkage, radius }) => sinkage > radius,
            _ => false,
        };
        let stalled = row.slip.is_finite().then(|| self.stall.see(row.slip >= self.stall_slip, index, row.time));
        let known = row.status.is_good() || beyond_axle;
        let trapped = known.then(|| self.entrapment.see(beyond_axle || row.sinkage > self.entrapment_sinkage, index, row.time));
        for event in [stalled.flatten(), trapped.flatten()].into_iter().flatten() {
            self.keep(event);
        }
    }

    fn keep(&mut self, event: Event) {
        if self.events.len() < MOST_EVENTS {
            self.events.push(event);
        } else {
            self.events_left_out += 1;
        }
    }

    /// Ends the events that last until now: to be called after the last sample.
    pub fn finish(&mut self) {
        for event in [self.stall.end(), self.entrapment.end()].into_iter().flatten() {
            self.keep(event);
        }
    }

    /// The events that have ended, and how many more there were than are kept.
    #[must_use]
    pub fn events(&self) -> (&[Event], u64) {
        (&self.events, self.events_left_out)
    }

    /// The wheel on its soil.
    #[must_use]
    pub fn system(&self) -> &WheelOnSoil {
        &self.operation.system
    }

    /// Samples so far.
    #[must_use]
    pub fn rows(&self) -> u64 {
        self.rows
    }

    /// The samples of a status, if there were any.
    #[must_use]
    pub fn tally(&self, status: Status) -> Option<&Tally> {
        self.tallies[status as usize].as_ref()
    }

    /// The good samples for which the coupled form has no answer, if there were any.
    #[must_use]
    pub fn not_coupled(&self) -> Option<&Tally> {
        self.not_coupled.as_ref()
    }

    /// What is to be said of the good samples: one of each kind.
    #[must_use]
    pub fn cautions(&self) -> &[CautionTally] {
        &self.cautions
    }

    /// Whether the wheel moved backward at a good sample.
    #[must_use]
    pub fn has_moved_backward(&self) -> bool {
        self.backward
    }
}

/// Why a sample has no result.
type Refused = (Status, Option<Error>);

fn present(value: f64) -> Result<(), Refused> {
    if value.is_nan() {
        Err((Status::MissingValue, None))
    } else if value.is_infinite() {
        Err((Status::OutOfRange, None))
    } else {
        Ok(())
    }
}

fn positive(value: f64) -> Result<(), Refused> {
    present(value)?;
    if value > 0.0 { Ok(()) } else { Err((Status::OutOfRange, None)) }
}
