//! How do sinkage, forces, power and energy of a wheel develop over time? Telemetry, one sample after another.
//!
//! Each sample is an operating point of its own. Only time, energy and events carry over, so memory stays constant and the
//! forces of a row do not depend on earlier rows. Where a sinkage is solved for, its search starts from the rows before it, and
//! ends within its tolerance of where it would end alone.
//!
//! * Power P = T ω. Energy ∫ P dt by the trapezoidal rule, which is exact where the power is linear between samples.
//! * A sample without a result is skipped: the trapezoid spans the gap between its neighbours. Where time runs backwards, no
//!   energy is added and the integral goes on from the new time.
//! * At rest, v = ω = 0, the slip is 0 by convention (letter, Eq. 2). The row is the limit of rolling, s → 0; the power is 0
//!   because ω is 0.
//! * A wheel that the soil does not carry at any sinkage up to the axle has no forces and counts as entrapped. A measured sinkage
//!   beyond the axle has no forces either, but the likely cause is a wrong unit, so it is no event.
//! * Only the coupled form needs the measured torque and load. Where one is missing, only the pull by that form is missing.
//! * Without a soil the pull follows from the torque, the load and the sinkage alone ([`Tracker::without_soil`]).

mod findings;
mod reached;
mod refusal;
mod sample;
mod solved;
mod tally;

pub use sample::{Channel, Measured, Sample, SampleMotion, Status, TrackRow};
pub use tally::{CautionTally, CulpritTally, Tally};

use crate::coupled::coupled_cautions;
use crate::error::Error;
use crate::events::{Event, EventKind, Thresholds, Watch};
use crate::fault::InvalidInput;
use crate::motion::Heading;
use crate::operating_point::Sinkage;
use crate::operation::Operation;
use crate::outcome::cautions_with_sinkage;
use crate::pull_from_torque::torque_against_slip;
use crate::rolling::WheelOnSoil;
use reached::{Reached, Uncoupled};
use refusal::{Refused, present};
use solved::Solved;
use tally::CompensatedSum;

/// Follows a wheel over time.
#[derive(Debug, Clone)]
pub struct Tracker {
    operation: Operation,
    /// Whether the forces follow from the soil, or from the torque.
    has_soil: bool,
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
    culprits: Vec<CulpritTally>,
    missing_torque: Option<Tally>,
    missing_load: Option<Tally>,
    not_coupled: Option<Tally>,
    cautions: Vec<CautionTally>,
    /// The latest static sinkage with the normal force (N) at its standstill.
    standstill: Option<(Sinkage, Option<f64>)>,
    backward: bool,
    solved: Solved,
}

/// Most events that are kept; the rest are only counted.
const MOST_EVENTS: usize = 1000;

impl Tracker {
    /// A tracker for the wheel, the soil and the method of `operation`. Each sample says how its own sinkage is known.
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
    /// #         shear: Some(ShearLaw::JanosiHanamoto(JanosiHanamoto { modulus: 0.005 })),
    /// #         pressure_sinkage: Some(PressureSinkage::Bekker(Bekker { k_c: -660.0, k_phi: 754_130.0, exponent })),
    /// #         ..SoilParams::BARE
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
    ///         unreadable: false,
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
            has_soil: true,
            entrapment_sinkage: thresholds.entrapment_sinkage_ratio * operation.system.wheel.radius(),
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
            culprits: Vec::new(),
            missing_torque: None,
            missing_load: None,
            not_coupled: None,
            cautions: Vec::new(),
            standstill: None,
            backward: false,
            solved: Solved::default(),
        })
    }

    /// The same without a soil: pull and normal force of a sample follow from its torque, its load and its sinkage by linear stresses
    /// (`pull_from_torque.rs`), its torque is the one measured, and a sample without one of them has no result. The soil and the method
    /// of the operation have no influence.
    #[must_use]
    pub fn without_soil(self) -> Self {
        Self { has_soil: false, ..self }
    }

    /// The row of the next sample.
    pub fn push(&mut self, sample: &Sample) -> TrackRow {
        let index = self.rows;
        self.rows += 1;
        let mut slip = f64::NAN;
        let outcome = self.in_time(sample.time).and_then(|()| self.reached(sample, &mut slip));
        let (row, error) = match outcome {
            Ok(reached) => (self.accept(index, sample.sinkage, reached), None),
            Err(Refused { status, error, culprit }) => {
                let unread = status == Status::MissingValue && sample.unreadable;
                let status = if unread { Status::Unreadable } else { status };
                if let Some((channel, value)) = culprit {
                    CulpritTally::count(&mut self.culprits, status, channel, value);
                }
                (TrackRow::bad(sample.time, slip, status), error)
            }
        };
        Tally::count(&mut self.tallies[row.status as usize], index, error);
        self.watch(index, &row, error);
        row
    }

    /// Whether the sample follows the one before in time.
    fn in_time(&mut self, time: f64) -> Result<(), Refused> {
        present(Channel::Time, time)?;
        let backwards = self.latest_time.replace(time).is_some_and(|latest| time < latest);
        if backwards {
            self.latest_power = None; // the interval has no length
            self.finish();
            return Err(Refused { status: Status::TimeBackwards, error: None, culprit: None });
        }
        Ok(())
    }

    /// Adds the energy up to a good sample, and what the run remembers of it.
    fn accept(&mut self, index: u64, sinkage: Sinkage, reached: Reached) -> TrackRow {
        let Reached { mut row, mut outcome, heading, coupled } = reached;
        outcome.standstill_normal = self.standstill_normal(sinkage);
        self.solved.keep(&sinkage, outcome.slip, row.sinkage);
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
                let WheelOnSoil { wheel, contact, .. } = &self.operation.system;
                let moves = row.status == Status::Ok; // at rest there is no slip to contradict
                let against = torque_against_slip(wheel, contact, outcome.slip, outcome.sinkage, forces.torque).filter(|_| moves);
                CautionTally::count(&mut self.cautions, index, forces.caution().into_iter().chain(against));
            }
            Some(Err(Uncoupled::Missing { torque, load })) => {
                for (_, tally) in
                    [(torque, &mut self.missing_torque), (load, &mut self.missing_load)].into_iter().filter(|of| of.0)
                {
                    Tally::count(tally, index, None);
                }
            }
            Some(Err(Uncoupled::Unsolved(error))) => Tally::count(&mut self.not_coupled, index, Some(error)),
            None => {}
        }
        self.backward |= heading == Heading::Backward;
        if self.has_soil {
            CautionTally::count(&mut self.cautions, index, cautions_with_sinkage(&self.operation, &sinkage, &outcome));
        } else {
            CautionTally::count(
                &mut self.cautions,
                index,
                coupled_cautions(&self.operation.system, Some(outcome.slip), outcome.sinkage),
            );
        }
        row
    }

    /// Normal force (N) at the standstill of a sample whose sinkage follows from a static one; found once for as long as that stays.
    fn standstill_normal(&mut self, sinkage: Sinkage) -> Option<f64> {
        if !matches!(sinkage, Sinkage::FromStatic { .. }) {
            return None;
        }
        match self.standstill {
            Some((known, normal)) if known == sinkage => normal,
            _ => {
                let normal = Operation { sinkage, ..self.operation }.standstill_normal();
                self.standstill = Some((sinkage, normal));
                normal
            }
        }
    }

    /// Updates the events. A sample without a slip leaves a stall as it is, one without a sinkage an entrapment.
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

    /// Ends the events that still last. Call it after the last sample.
    pub fn finish(&mut self) {
        for event in [self.stall.end(), self.entrapment.end()].into_iter().flatten() {
            self.keep(event);
        }
    }
}
