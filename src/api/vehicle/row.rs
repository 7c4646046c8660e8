//! A rover on one slope as a row among many.

use terramechanics::VehicleError;
use terramechanics_reading::FieldFault;

use super::found::{FoundSlope, of_ruts};
use super::refusal;
use super::reply::{COLUMNS, row};
use super::request::{Slopes, VehicleCase};
use crate::catalogue;
use crate::compute::{Cost, Pace};
use crate::quantity::About;
use crate::varied::{RowStatus, Varied};
use crate::warning::{Finding, Tally};

static LARGEST: About = About::new(
    "largest_slope_rad",
    "α",
    "rad",
    "largest slope that the rover climbs at slips up to the limit; null where there is none",
);

/// The columns of a rover.
pub(crate) fn rover_columns() -> impl Iterator<Item = &'static About> {
    COLUMNS.iter().chain([&LARGEST])
}

impl Varied for VehicleCase {
    fn columns(&self) -> Vec<&'static About> {
        rover_columns().collect()
    }

    /// A rover takes as long as a hundred wheels and more.
    const ROWS_PER_BLOCK: usize = 16;

    fn refusal(&self) -> Option<FieldFault> {
        let is_one = matches!(self.slopes, Slopes::One(_));
        (!is_one).then(|| FieldFault::new("/slope_rad", "must be one slope here; an axis over `/slope_rad` has several"))
    }

    fn cost_of_rows(&self, rows: usize) -> Cost {
        Cost::of_rovers(&self.vehicle, rows)
    }

    fn row(&self, cells: &mut Vec<f64>, tally: &mut Tally, pace: &Pace) -> RowStatus {
        let found = self.answer(true, cells, tally, pace);
        found.map_or_else(|error| status(&error), |()| RowStatus::Ok)
    }
}

/// How a row went that was refused.
fn status(error: &VehicleError) -> RowStatus {
    if matches!(error, VehicleError::NotClimbed { .. }) { RowStatus::NotClimbed } else { RowStatus::NoSolution }
}

impl VehicleCase {
    /// Adds the numbers of the row to `cells`, NaN where there is none; what is to be said of them goes into `tally`. The largest
    /// slope, which takes most of the time, is found where it is wanted, and else NaN.
    ///
    /// # Errors
    /// What the model refuses, which is in the tally then.
    pub(crate) fn answer(
        &self,
        with_largest: bool,
        cells: &mut Vec<f64>,
        tally: &mut Tally,
        pace: &Pace,
    ) -> Result<(), VehicleError> {
        let Self { vehicle, slopes, hitch_pull, slip_limit, velocity, .. } = self;
        let slope = slopes.as_slice().first().copied().unwrap_or(f64::NAN);
        let on = vehicle.on_slope_while(slope, *hitch_pull, &|| pace.goes_on());
        let climbs = on.as_ref().is_ok_and(|on| on.driven.slip.ratio() <= *slip_limit);
        let found = FoundSlope { slope, needed_pull: vehicle.needed_pull(slope, *hitch_pull), climbs, on };
        cells.extend(row(&found, *velocity));
        let largest =
            with_largest.then(|| vehicle.largest_slope_while(*hitch_pull, *slip_limit, &|| pace.goes_on()).ok()).flatten();
        cells.push(largest.map_or(f64::NAN, |largest| largest.slope));
        if let Some(finding) = self.unused.finding() {
            tally.finding(finding);
        }
        for station in &vehicle.params().stations {
            let (wheel, soil) = (&station.system.wheel, station.system.soil.params());
            catalogue::outside(wheel, soil).for_each(|outside| tally.finding(Finding::OutsideCatalogue { outside }));
        }
        of_ruts(vehicle).for_each(|finding| tally.finding(finding));
        match found.on {
            Ok(on) => {
                if !climbs {
                    tally.finding(Finding::SlipBeyondLimit { slip: on.driven.slip.ratio(), limit: *slip_limit });
                }
                vehicle.cautions(&on.driven).for_each(|(_, caution)| tally.caution(caution));
                Ok(())
            }
            Err(error) => {
                tally.finding(refusal::finding(&error));
                Err(error)
            }
        }
    }

    /// How a row went that was refused, and the fault of a request with its numbers.
    pub(crate) fn refused(&self, error: &VehicleError) -> (RowStatus, FieldFault) {
        (status(error), refusal::fault(error, &self.have_own_soil))
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::api::room::Room;
    use crate::request::checked;

    #[test]
    fn a_rover_that_nobody_waits_for_is_not_computed() {
        let request = VehicleCase::example();
        let case: VehicleCase = checked(&(&request).into()).unwrap_or_else(|faults| panic!("{faults:?}"));
        let status = |pace: &Pace| case.row(&mut Vec::new(), &mut Tally::default(), pace);
        assert_eq!((status(&Pace::at_once()), status(&Pace::of_nobody())), (RowStatus::Ok, RowStatus::NoSolution));
    }
}
