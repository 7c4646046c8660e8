//! An operating point as a row among many.

use terramechanics::{Method, Motion, Outcome, cautions};

use super::request::ForcesCase;
use crate::catalogue;
use crate::compute::Cost;
use crate::quantity::{About, Point, point_columns};
use crate::request::error_pointer;
use crate::request::pull::SlipFrom;
use crate::varied::{RowStatus, Varied};
use crate::warning::{Finding, Tally, no_solution};

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

    fn row(&self, cells: &mut Vec<f64>, tally: &mut Tally) -> RowStatus {
        let Self { operation, .. } = self;
        let columns = point_columns(&self.operation, self.is_sideways());
        let (motion, point) = match self.point() {
            Ok(found) => found,
            Err(error) => {
                tally.finding(no_solution(error, error_pointer(&error, &operation.sinkage)));
                let slip = self.asked_motion().map(|motion| motion.slip);
                cells.extend(columns.map(|(_, value)| slip.map_or(f64::NAN, |slip| value.without(slip))));
                return RowStatus::NoSolution;
            }
        };
        let at = Point::of(&operation.system, motion, &point);
        cells.extend(columns.map(|(_, value)| value.at(&at)));
        let outcome = Outcome { standstill_normal: operation.standstill_normal(), ..Outcome::from(&point) };
        cautions(operation, &outcome).for_each(|caution| tally.caution(caution));
        let system = &operation.system;
        catalogue::outside(&system.wheel, system.soil.params())
            .for_each(|outside| tally.finding(Finding::OutsideCatalogue { outside }));
        if motion.heading == terramechanics::Heading::Backward {
            tally.finding(Finding::Mirrored {});
        }
        RowStatus::Ok
    }
}
