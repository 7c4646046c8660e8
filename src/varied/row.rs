//! What an operation gives for one of many cases: a row of numbers, and how it went.

use terramechanics_reading::{FieldFault, Path};

use super::setter::{IsSent, Setter};
use crate::compute::{Cost, Pace};
use crate::quantity::About;
use crate::request::Request;
use crate::warning::{Finding, Tally};

/// How a row went.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum RowStatus {
    /// It has its numbers.
    Ok,
    /// Its values make no valid request.
    Invalid,
    /// The model has no answer.
    NoSolution,
    /// The rover does not climb: no slip gives the pull.
    NotClimbed,
}

impl RowStatus {
    pub(crate) const ALL: [Self; 4] = [Self::Ok, Self::Invalid, Self::NoSolution, Self::NotClimbed];

    /// Its name on the wire.
    pub(crate) const fn name(self) -> &'static str {
        match self {
            Self::Ok => "ok",
            Self::Invalid => "invalid",
            Self::NoSolution => "no_solution",
            Self::NotClimbed => "not_climbed",
        }
    }
}

/// A request that gives a row of numbers, so that many of them make a table.
pub(crate) trait Varied: Request + Sync {
    /// The columns of a row.
    fn columns(&self) -> Vec<&'static About>;

    /// Rows that one thread computes before their answers are sent.
    const ROWS_PER_BLOCK: usize = 1024;

    /// Why such a request gives no row, although it is right by itself.
    fn refusal(&self) -> Option<FieldFault> {
        None
    }

    /// What so many rows of this kind cost.
    fn cost_of_rows(&self, rows: usize) -> Cost;

    /// How the numbers under `paths` are replaced in such a case without reading its request anew; none where only the reading can
    /// tell what follows from them.
    fn setters(&self, _paths: &[Path], _is_sent: IsSent<'_>) -> Option<Vec<Setter>> {
        None
    }

    /// Replaces the numbers of all setters, and makes the case that which the request has with them. False where that is refused, or
    /// might be: the case then is none until its numbers are replaced again.
    fn set_numbers(&mut self, _setters: &[Setter], _values: &[f64]) -> bool {
        false
    }

    /// Adds the numbers of the row to `cells`, one for each column, NaN where there is none; what is to be said of them goes into
    /// `tally`. A row that `pace` ends on the way says no more than that it has no answer.
    fn row(&self, cells: &mut Vec<f64>, tally: &mut Tally, pace: &Pace) -> RowStatus;
}

/// What is to be said of a row whose values make no request.
pub(crate) fn tell_invalid(faults: Vec<FieldFault>, tally: &mut Tally) -> RowStatus {
    for FieldFault { pointer, detail, .. } in faults {
        tally.finding(Finding::InvalidRow { pointer, detail });
    }
    RowStatus::Invalid
}
