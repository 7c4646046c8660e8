//! At which slip does a rover climb a slope, and which slope is the largest?

use super::{Consent, Driven, Told, Vehicle, VehicleError};
use crate::numerics::brent::{Sample, bracketed_root};
use crate::slip::Slip;
use crate::slip_search::{Searched, largest_pull, slip_of_pull};

/// Step (rad) of the walk to the largest slope.
const STEP: f64 = 0.1;

/// Relative tolerance of the largest slope; the loads are solved to 1e-13.
const TOLERANCE: f64 = 1e-12;

/// What is taken off the largest slope (rad), so that the slip found on it is not above the limit by its rounding.
const MARGIN: f64 = 1e-11;

/// Halvings that close in on the last slope on which every wheel has an answer.
const HALVINGS: u32 = 40;

/// A rover on a slope that it climbs.
#[derive(Debug, Clone, PartialEq)]
pub struct OnSlope {
    /// The slope (rad).
    pub slope: f64,
    /// The rover at the slip at which its wheels give the pull that slope and hitch need.
    pub driven: Driven,
    /// Energy for a metre of way over the weight (–): the specific resistance.
    pub specific_resistance: f64,
}

/// What ends the climb.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum SlopeLimit {
    /// The pull at slips up to the limit.
    Pull,
    /// A wheel lifts off, or has no answer, on anything steeper.
    Wheel(VehicleError),
    /// Nothing, up to the largest slope that is tried.
    Nothing,
}

/// The largest slope that a rover climbs.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct LargestSlope {
    /// The slope (rad).
    pub slope: f64,
    /// What ends the climb there.
    pub limit: SlopeLimit,
}

/// A slope with the pull that is left there, as far as there is one.
type Trial = Result<Sample, VehicleError>;

impl Vehicle {
    /// The rover on `slope` (rad), pulling `hitch_pull` (N): of several slips that give the pull the one nearest to 0.
    ///
    /// # Errors
    /// [`VehicleError::Invalid`] for a value out of range; [`VehicleError::Lifted`]; [`VehicleError::NotClimbed`] with the pull that
    /// comes nearest where no slip from −1 to 1 gives the pull; [`VehicleError::Wheel`] where a wheel has no answer at any slip.
    pub fn on_slope(&self, slope: f64, hitch_pull: f64) -> Result<OnSlope, VehicleError> {
        self.on_slope_while(slope, hitch_pull, &|| true)
    }

    /// The same for as long as `go_on` says yes. It is asked before each wheel that is computed.
    ///
    /// # Errors
    /// As [`Vehicle::on_slope`]; [`VehicleError::Stopped`].
    pub fn on_slope_while(&self, slope: f64, hitch_pull: f64, go_on: &dyn Fn() -> bool) -> Result<OnSlope, VehicleError> {
        let consent = Consent::new(go_on);
        consent.kept(self.on_slope_by(&consent, slope, hitch_pull))
    }

    fn on_slope_by(&self, consent: &Consent<'_>, slope: f64, hitch_pull: f64) -> Result<OnSlope, VehicleError> {
        let hitch_pull = Self::HITCH_PULL.check(hitch_pull).map_err(VehicleError::Invalid)?;
        let loads = self.loads(slope, hitch_pull)?;
        let needed = self.needed_pull(slope, hitch_pull);
        let told = self.told(&loads, consent)?;
        let mut refusal = None;
        let found = slip_of_pull(|slip| self.pull(&told, slip, &loads, &mut refusal), needed, (-1.0, 1.0));
        match found.map_err(|error| refusal.unwrap_or(VehicleError::Wheel { station: 0, error }))? {
            Searched::Missed { slip, pull: reached, nearest } => Err(VehicleError::NotClimbed { needed, reached, slip, nearest }),
            Searched::Met { slip } => {
                let slip = Slip::new(slip).map_err(|error| VehicleError::Wheel { station: 0, error })?;
                let driven = self.beside(&told, slip, &loads)?;
                Ok(OnSlope { slope, specific_resistance: driven.energy_per_metre / self.weight(), driven })
            }
        }
    }

    /// The largest slope that the rover climbs with `hitch_pull` (N) at slips from 0 to `slip_limit`; negative where it moves downhill
    /// only. It is the end of the slopes that it climbs around the steepest of the walk.
    ///
    /// # Errors
    /// [`VehicleError::Invalid`] for a value out of range; what ends the climb on every slope that is tried.
    pub fn largest_slope(&self, hitch_pull: f64, slip_limit: f64) -> Result<LargestSlope, VehicleError> {
        self.largest_slope_while(hitch_pull, slip_limit, &|| true)
    }

    /// The same for as long as `go_on` says yes. It is asked before each wheel that is computed.
    ///
    /// # Errors
    /// As [`Vehicle::largest_slope`]; [`VehicleError::Stopped`].
    pub fn largest_slope_while(
        &self,
        hitch_pull: f64,
        slip_limit: f64,
        go_on: &dyn Fn() -> bool,
    ) -> Result<LargestSlope, VehicleError> {
        let consent = Consent::new(go_on);
        consent.kept(self.largest_slope_by(&consent, hitch_pull, slip_limit))
    }

    fn largest_slope_by(&self, consent: &Consent<'_>, hitch_pull: f64, slip_limit: f64) -> Result<LargestSlope, VehicleError> {
        let hitch_pull = Self::HITCH_PULL.check(hitch_pull).map_err(VehicleError::Invalid)?;
        let slip_limit = Self::SLIP_LIMIT.check(slip_limit).map_err(VehicleError::Invalid)?;
        let steepest = Self::SLOPE.most;
        let trial = |slope: f64| self.spare_pull(consent, (slope, hitch_pull), slip_limit);
        let is_climbed = |trial: &Trial| trial.is_ok_and(|sample| sample.y >= 0.0);
        let mut here = trial(0.0);
        let mut slope = 0.0;
        if is_climbed(&here) {
            while slope < steepest {
                let next = (slope + STEP).min(steepest);
                let steeper = trial(next);
                match (here, steeper) {
                    (Ok(climbed), steeper) if !is_climbed(&steeper) => return Self::between(trial, climbed, next, steeper),
                    _ => (here, slope) = (steeper, next),
                }
            }
            return Ok(LargestSlope { slope: steepest, limit: SlopeLimit::Nothing });
        }
        while slope > -steepest {
            let next = (slope - STEP).max(-steepest);
            let gentler = trial(next);
            match gentler {
                Ok(climbed) if is_climbed(&gentler) => return Self::between(trial, climbed, slope, here),
                _ => (here, slope) = (gentler, next),
            }
        }
        let level = trial(0.0)?;
        let needed = self.needed_pull(0.0, hitch_pull);
        Err(VehicleError::NotClimbed {
            needed,
            reached: needed + level.y,
            slip: slip_limit,
            nearest: crate::pull::Nearest::Largest,
        })
    }

    /// The end of the climb between a slope that is climbed and one that is not.
    fn between(
        trial: impl Fn(f64) -> Trial,
        mut climbed: Sample,
        mut steep: f64,
        mut refused: Trial,
    ) -> Result<LargestSlope, VehicleError> {
        for _ in 0..HALVINGS {
            let Err(error) = refused else { break };
            let middle = 0.5 * (climbed.x + steep);
            match trial(middle) {
                Ok(sample) if sample.y >= 0.0 => climbed = sample,
                other => (steep, refused) = (middle, other),
            }
            if (steep - climbed.x).abs() <= TOLERANCE {
                return Ok(LargestSlope { slope: climbed.x, limit: SlopeLimit::Wheel(error) });
            }
        }
        match refused {
            Err(error) => Ok(LargestSlope { slope: climbed.x, limit: SlopeLimit::Wheel(error) }),
            Ok(slides) => {
                let found = bracketed_root(|slope| trial(slope).map(|sample| sample.y), climbed, slides, TOLERANCE)?;
                Ok(LargestSlope { slope: found.best.x - MARGIN, limit: SlopeLimit::Pull })
            }
        }
    }

    /// The slope with the largest pull at slips from 0 to the limit, less the pull that is needed there.
    fn spare_pull(&self, consent: &Consent<'_>, (slope, hitch_pull): (f64, f64), slip_limit: f64) -> Trial {
        let loads = self.loads(slope, hitch_pull)?;
        let told = self.told(&loads, consent)?;
        let mut refusal = None;
        let largest = largest_pull(|slip| self.pull(&told, slip, &loads, &mut refusal), slip_limit);
        let largest = largest.map_err(|error| refusal.unwrap_or(VehicleError::Wheel { station: 0, error }))?;
        Ok(Sample { x: slope, y: largest.y - self.needed_pull(slope, hitch_pull) })
    }

    /// Σ F_x (N) at a slip; the first refusal of a wheel is kept.
    fn pull(
        &self,
        told: &Told<'_>,
        slip: f64,
        loads: &[f64],
        refusal: &mut Option<VehicleError>,
    ) -> Result<f64, crate::error::Error> {
        self.beside(told, Slip::new(slip)?, loads).map(|driven| driven.pull).map_err(|error| {
            *refusal = refusal.or(Some(error));
            if let VehicleError::Wheel { error, .. } = error { error } else { crate::error::Error::NotFinite }
        })
    }
}
