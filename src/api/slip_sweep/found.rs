//! An operation over slip.

use std::collections::BTreeMap;

use terramechanics::{Error, Operation, Outcome, SlipSweep, cautions};

use super::request::SweepCase;
use crate::compute::{Pace, Point, Stop};
use crate::request::error_pointer;
use crate::warning::{RowCautions, Rows, Warning, no_solution, of_system};

/// An operation over slip.
pub(crate) struct FoundSweep {
    pub(crate) operation: Operation,
    pub(crate) sweep: SlipSweep,
    pub(crate) warnings: Vec<Warning>,
}

/// The operation at each slip.
///
/// # Errors
/// [`Stop`], where the work is to end.
pub(crate) fn sweep(SweepCase { operation, slips, unused }: &SweepCase, pace: &Pace) -> Result<FoundSweep, Stop> {
    let mut sweep = SlipSweep::with_capacity(slips.len());
    for slips in slips.chunks(Point::between_checks(operation)) {
        pace.look()?;
        sweep.extend(operation, slips);
    }
    let mut cautious = RowCautions::default();
    let standstill_normal = operation.standstill_normal();
    for (row, point) in sweep.points() {
        cautious.add(row, cautions(operation, &Outcome { standstill_normal, ..Outcome::from(point) }));
    }
    let mut warnings = of_gaps(&sweep, operation);
    warnings.extend(cautious.into_warnings(slips.len()));
    warnings.extend(of_system(&operation.system));
    warnings.extend(unused.warning());
    Ok(FoundSweep { operation: *operation, sweep, warnings })
}

/// One warning for each field at fault: the rows without a solution, and the reason of the first.
fn of_gaps(sweep: &SlipSweep, operation: &Operation) -> Vec<Warning> {
    let mut by_field: BTreeMap<&'static str, (Error, Vec<usize>)> = BTreeMap::new();
    for (row, _, error) in sweep.gaps() {
        let pointer = error_pointer(&error, &operation.sinkage);
        by_field.entry(pointer).or_insert_with(|| (error, Vec::new())).1.push(row);
    }
    let warning = |(pointer, (error, rows)): (_, (_, Vec<usize>))| Warning::from(no_solution(error, pointer)).at(Rows::of(&rows));
    by_field.into_iter().map(warning).collect()
}
