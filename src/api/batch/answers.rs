//! What the rows of a block gave, by column.

use terramechanics_reading::{Assumption, FieldFault};

use crate::warning::Tally;

/// Name of the column that says how a row went.
pub(crate) const STATUS: &str = "status";

/// The status of a row that has an answer.
pub(super) const OK: &str = "ok";

/// What the rows of a block gave.
#[derive(Debug, Default)]
pub(crate) struct Answers {
    /// By column of the answer, then by row; NaN where there is no number.
    pub(crate) numbers: Vec<Vec<f64>>,
    /// Of each row, in words what was wrong with it, if something was.
    pub(crate) faults: Vec<Option<Box<str>>>,
    pub(crate) tally: Tally,
    pub(crate) assumed: Vec<Assumption>,
    /// Whether a row made a case.
    pub(crate) has_case: bool,
    /// The faults of the first rows that have all columns, as long as none made a case.
    pub(crate) refused: Vec<Vec<FieldFault>>,
}
