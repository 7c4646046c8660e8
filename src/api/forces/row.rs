//! An operating point as a row among many.

use terramechanics::{Error, Method, Motion, Outcome, cautions};
use terramechanics_reading::Path;

use super::direct;
use super::request::ForcesCase;
use crate::catalogue;
use crate::compute::{Cost, Pace};
use crate::quantity::{About, Point, PointValue, point_columns};
use crate::request::error_pointer;
use crate::request::pull::SlipFrom;
use crate::varied::{IsSent, RowStatus, Setter, Varied};
use crate::warning::{Finding, Tally, no_solution, of_motion};

impl ForcesCase {
    fn is_sideways(&self) -> bool {
        matches!(self.operation.model.method, Method::SideSlipping(_))
    }

    /// The motion that was asked for; none where the slip is solved.
    fn asked_motion(&self) -> Option<Motion> {
        match self.slip {
            SlipFrom::Motion(motion) => Some(motion),
            SlipFrom::Pull(_) => None,
        }
    }
}

impl Varied for ForcesCase {
    fn columns(&self) -> Vec<&'static About> {
        point_columns(&self.operation, self.is_sideways()).map(|(about, _)| about).collect()
    }

    fn cost_of_rows(&self, rows: usize) -> Cost {
        Cost::of_rows(&self.operation, matches!(self.slip, SlipFrom::Pull(_)), rows)
    }

    fn setters(&self, paths: &[Path], is_sent: IsSent<'_>) -> Option<Vec<Setter>> {
        direct::setters(self, paths, is_sent)
    }

    fn set_numbers(&mut self, setters: &[Setter], values: &[f64]) -> bool {
        direct::set_numbers(self, setters, values).is_some()
    }

    fn row(&self, cells: &mut Vec<f64>, tally: &mut Tally, _: &Pace) -> RowStatus {
        let columns = point_columns(&self.operation, self.is_sideways()).map(|(_, value)| value);
        match self.answer(columns, tally, |number| cells.push(number)) {
            Ok(()) => RowStatus::Ok,
            Err(_) => RowStatus::NoSolution,
        }
    }
}

impl ForcesCase {
    /// Hands over the number of each column, NaN where there is none; what is to be said of them goes into `tally`.
    ///
    /// # Errors
    /// What the model refuses, which is in the tally then; the columns are those of the request alone.
    #[inline]
    pub(crate) fn answer(
        &self,
        columns: impl Iterator<Item = PointValue>,
        tally: &mut Tally,
        mut put: impl FnMut(f64),
    ) -> Result<(), Error> {
        let Self { operation, unused, .. } = self;
        if let Some(finding) = unused.finding() {
            tally.finding(finding);
        }
        // A value in another unit may be the reason why there is no answer.
        let system = &operation.system;
        catalogue::outside(&system.wheel, system.soil.params())
            .for_each(|outside| tally.finding(Finding::OutsideCatalogue { outside }));
        let (motion, point) = match self.point() {
            Ok(found) => found,
            Err(error) => {
                tally.finding(no_solution(error, error_pointer(&error, &operation.sinkage)));
                let slip = self.asked_motion().map(|motion| motion.slip);
                columns.for_each(|value| put(slip.map_or(f64::NAN, |slip| value.without(slip))));
                return Err(error);
            }
        };
        let at = Point::of(&operation.system, motion, &point);
        columns.for_each(|value| put(value.at(&at)));
        let outcome = Outcome { standstill_normal: operation.standstill_normal(), ..Outcome::from(&point) };
        cautions(operation, &outcome).for_each(|caution| tally.caution(caution));
        of_motion(motion).for_each(|finding| tally.finding(finding));
        Ok(())
    }
}
