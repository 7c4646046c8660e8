//! Tables of telemetry: separated by commas, semicolons or tabs, with a decimal point or comma, with or without a byte order
//! mark, carriage returns, quotes, comments after `#` and a row of units below the header.

mod header;
mod records;
#[cfg(test)]
mod tests;

use super::{Column, ExtraColumns, Layout, Read, Row, SeriesFault, Unreadable};
pub(crate) use header::number;
use header::{CellFault, Header};
pub(crate) use records::{Next, Records};

/// Reads a table piece by piece.
pub(crate) struct CsvReader {
    extra: ExtraColumns,
    records: Records,
    expected: Expected,
    header: Header,
    /// Whether there was a row of numbers.
    has_rows: bool,
    unreadable: Unreadable,
}

#[derive(Clone, Copy, PartialEq, Eq)]
enum Expected {
    Header,
    UnitsOrRow,
    Row,
}

impl std::fmt::Debug for CsvReader {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        f.debug_struct("CsvReader").field("line", &self.records.line()).finish_non_exhaustive()
    }
}

impl CsvReader {
    pub(super) fn new(extra: ExtraColumns) -> Self {
        Self {
            extra,
            records: Records::new(),
            expected: Expected::Header,
            header: Header::default(),
            has_rows: false,
            unreadable: Unreadable::default(),
        }
    }

    pub(super) fn layout(&self) -> Option<Layout> {
        (!self.header.order.is_empty()).then_some(self.header.layout)
    }

    pub(super) fn unreadable(&self) -> &Unreadable {
        &self.unreadable
    }

    pub(super) fn next(&mut self, input: &mut &[u8], last: bool) -> Result<Read, SeriesFault> {
        loop {
            match self.records.next(input, last)? {
                Next::More => return Ok(Read::More),
                Next::End if self.header.order.is_empty() => return Err(self.records.fault(0, "the table has no header")),
                Next::End if !self.has_rows => return Err(self.records.fault(0, "the table has no samples")),
                Next::End => return Ok(Read::End),
                Next::Record => {
                    let read = self.record();
                    self.records.clear();
                    if let Some(row) = read? {
                        return Ok(Read::Row(row));
                    }
                }
            }
        }
    }

    /// What a record gives: a sample, or nothing where it is the header, a row of units or blank.
    fn record(&mut self) -> Result<Option<Row>, SeriesFault> {
        if self.records.cells() == 1 && self.records.cell(0).is_empty() {
            return Ok(None); // blanks
        }
        let following = if self.expected == Expected::Header { Expected::UnitsOrRow } else { Expected::Row };
        match std::mem::replace(&mut self.expected, following) {
            Expected::Header => {
                self.header = Header::read(&self.records.words(), self.extra).map_err(|fault| self.fault_in(fault))?;
                Ok(None)
            }
            Expected::UnitsOrRow if self.is_of_units() => {
                self.header.check_units(&self.records.words()).map_err(|fault| self.fault_in(fault))?;
                Ok(None)
            }
            _ => self.row().map(Some),
        }
    }

    /// Whether the row below the header has a word where the time should be.
    fn is_of_units(&self) -> bool {
        let time = self.header.order.iter().position(|&index| index == Some(Column::Time as usize));
        self.records.cells() == self.header.order.len() && time.is_some_and(|at| number(self.records.cell(at)).is_none())
    }

    fn row(&mut self) -> Result<Row, SeriesFault> {
        let expected = self.header.order.len();
        if self.records.cells() != expected {
            let (at, found) = (self.records.cells().min(expected) + 1, self.records.cells());
            return Err(self.records.fault(at, format!("the number of cells is {found}, the header has {expected}")));
        }
        let mut row = Row { cells: [f64::NAN; Column::COUNT], unreadable: false };
        for at in 0..expected {
            let Some(index) = self.header.order[at] else { continue };
            let Some(value) = number(self.records.cell(at)) else {
                let fault = || {
                    self.records
                        .fault(at + 1, format!("`{}` is not a number (column `{}`)", self.records.word(at), Column::NAMES[index]))
                };
                if !self.has_rows {
                    return Err(fault()); // the form is wrong rather than the cell, and nothing is lost yet
                }
                let first = self.unreadable.first.is_none().then(fault);
                self.unreadable.count(first);
                row.unreadable = true;
                continue;
            };
            row.cells[index] = value;
        }
        self.has_rows = true;
        Ok(row)
    }

    fn fault_in(&self, (column, detail): CellFault) -> SeriesFault {
        self.records.fault(column, detail)
    }
}
