//! What the rows of a block gave, by column.

use terramechanics_reading::{Assumption, FieldFault};

use crate::rows::{Block, Columns};
use crate::varied::{RowStatus, tell_invalid};
use crate::warning::Tally;

/// Name of the column that says how a row went.
pub(crate) const STATUS: &str = "status";

/// The status of a row that has an answer.
pub(super) const OK: &str = "ok";

/// Refused rows that are looked at for what all of them lack.
const MOST_REFUSED: usize = 50;

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

impl Answers {
    /// Takes a row of the block that makes no request, for what is wrong with it; the same in words.
    pub(crate) fn refuse(&mut self, found: Vec<FieldFault>, block: &Block, row: usize, columns: &Columns) -> Box<str> {
        let words = in_words(RowStatus::Invalid, &found);
        let is_whole = block.shape(row).present.count_ones() as usize == columns.fields.len();
        if !self.has_case && is_whole && self.refused.len() < MOST_REFUSED {
            self.refused.push(found.clone());
        }
        tell_invalid(found, &mut self.tally);
        words
    }
}

/// How a row went that has no answer.
pub(crate) fn in_words(status: RowStatus, faults: &[FieldFault]) -> Box<str> {
    const MOST: usize = 5;
    let mut words = status.name().to_owned();
    for (i, FieldFault { pointer, detail, .. }) in faults.iter().take(MOST).enumerate() {
        words.push_str(if i == 0 { ": " } else { "; " });
        words.push_str(pointer);
        words.push_str(if pointer.is_empty() { "" } else { " " });
        words.push_str(detail);
    }
    if faults.len() > MOST {
        words.push_str(&format!("; and {} more", faults.len() - MOST));
    }
    words.into()
}
