//! How do the forces change with slip? The same operation at many slips, row by row.
//!
//! A row is the operating point itself, so what follows from a point follows from a row by the same formula.

use crate::error::Error;
use crate::operation::{OperatingPoint, Operation};
use crate::slip::Slip;

/// One slip of a sweep, with what holds there.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct SweepRow {
    /// The slip.
    pub slip: Slip,
    /// The operating point, or why there is none.
    pub point: Result<OperatingPoint, Error>,
}

impl SweepRow {
    fn of(operation: &Operation, slip: Slip) -> Self {
        Self { slip, point: operation.at(slip) }
    }
}

/// An operation over slip.
#[derive(Debug, Clone, Default, PartialEq)]
pub struct SlipSweep {
    /// One per slip, in the order of the slips.
    pub rows: Vec<SweepRow>,
}

impl SlipSweep {
    /// The points of `operation` at each of `slips`.
    #[must_use]
    pub fn of(operation: &Operation, slips: &[Slip]) -> Self {
        let mut sweep = Self::with_capacity(slips.len());
        sweep.fill(operation, slips);
        sweep
    }

    /// A sweep without rows, with room for `rows`.
    #[must_use]
    pub fn with_capacity(rows: usize) -> Self {
        Self { rows: Vec::with_capacity(rows) }
    }

    /// The same into rows that are there already, without allocating where there are enough of them.
    pub fn fill(&mut self, operation: &Operation, slips: &[Slip]) {
        self.rows.clear();
        self.rows.extend(slips.iter().map(|&slip| SweepRow::of(operation, slip)));
    }

    /// Adds the row of `slip`, for a caller that has to look up between rows. All rows of a sweep are of one `operation`.
    pub fn push(&mut self, operation: &Operation, slip: Slip) {
        self.rows.push(SweepRow::of(operation, slip));
    }

    /// The points there are, each with the index of its row.
    pub fn points(&self) -> impl Iterator<Item = (usize, &OperatingPoint)> {
        self.rows.iter().enumerate().filter_map(|(row, of)| Some((row, of.point.as_ref().ok()?)))
    }

    /// The rows without a point: index, slip and reason.
    pub fn gaps(&self) -> impl Iterator<Item = (usize, Slip, Error)> {
        self.rows.iter().enumerate().filter_map(|(row, of)| Some((row, of.slip, of.point.err()?)))
    }
}
