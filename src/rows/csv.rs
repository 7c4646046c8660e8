//! Rows of a table: separated by commas, semicolons or tabs, below a header with the names of the columns.

use std::borrow::Cow;
use std::sync::Arc;

use terramechanics_reading::Node;

use super::echo::EchoedCell;
use super::{Block, Columns, Read, Wanted};
use crate::problem::Problem;
use crate::series::{Next, Records, SeriesFault, number};

/// Reads a table piece by piece.
pub(crate) struct CsvRows {
    wanted: Wanted,
    records: Records,
    columns: Option<Arc<Columns>>,
    /// Whether there was a row.
    has_rows: bool,
}

impl CsvRows {
    pub(super) fn new(wanted: Wanted) -> Self {
        Self { wanted, records: Records::new(), columns: None, has_rows: false }
    }

    pub(super) fn columns(&self) -> Option<&Arc<Columns>> {
        self.columns.as_ref()
    }

    pub(super) fn fill(&mut self, input: &mut &[u8], last: bool, block: &mut Block) -> Result<Read, Problem> {
        loop {
            if block.is_full() {
                return Ok(Read::Full);
            }
            match self.records.next(input, last).map_err(Problem::Unreadable)? {
                Next::More => return Ok(Read::More),
                Next::End if self.columns.is_none() => return Err(self.fault(0, "the table has no header")),
                Next::End if !self.has_rows => return Err(self.fault(0, "the table has no rows")),
                Next::End => return Ok(Read::End),
                Next::Record => {
                    self.record(block)?;
                    self.records.clear();
                }
            }
        }
    }

    fn fault(&self, column: usize, detail: impl Into<String>) -> Problem {
        Problem::Unreadable(self.records.fault(column, detail))
    }

    fn record(&mut self, block: &mut Block) -> Result<(), Problem> {
        let Some(columns) = &self.columns else {
            let names: Vec<String> =
                (0..self.records.cells()).map(|at| String::from_utf8_lossy(self.records.cell(at)).into_owned()).collect();
            if names.iter().any(|name| !name.is_empty()) {
                let columns = self.wanted.columns(&names).map_err(Problem::Invalid)?;
                block.with(&columns);
                self.columns = Some(Arc::new(columns));
            }
            return Ok(());
        };
        let (found, expected) = (self.records.cells(), columns.field_of.len());
        if found == 1 && expected > 1 && self.records.cell(0).is_empty() {
            return Ok(()); // blanks
        }
        if found != expected {
            let detail = format!("the number of cells is {found}, the header has {expected}");
            if !self.has_rows {
                return Err(self.fault(found.min(expected) + 1, detail)); // the form is wrong rather than the row
            }
            block.faulty_row(SeriesFault { line: self.records.line(), column: 0, detail }.to_string());
            return Ok(());
        }
        self.has_rows = true;
        for at in 0..expected {
            let cell = self.records.cell(at);
            if let Some(field) = columns.field_of[at] {
                field_of_cell(block, field, columns.is_number[field], cell);
            }
            if let Some(column) = columns.echo_of[at] {
                let text = String::from_utf8_lossy(cell);
                block.echo(column, echo_of_cell(&text));
            }
        }
        block.end_row();
        Ok(())
    }
}

/// Whether the text stands for a value that is not there.
fn is_missing(cell: &[u8]) -> bool {
    cell.is_empty() || [&b"na"[..], b"n/a", b"null", b"none"].iter().any(|missing| cell.eq_ignore_ascii_case(missing))
}

#[inline]
fn field_of_cell(block: &mut Block, field: usize, is_number: bool, cell: &[u8]) {
    if is_missing(cell) {
        return;
    }
    if is_number && let Some(value) = number(cell).filter(|value| !value.is_nan()) {
        return block.number(field, value);
    }
    block.text(field, &String::from_utf8_lossy(cell), |text| Node::of_text(Cow::Owned(text.to_owned())));
}

fn echo_of_cell(text: &str) -> EchoedCell<'_> {
    match Node::of_text(Cow::Borrowed(text)) {
        _ if text.is_empty() => EchoedCell::Nothing,
        Node::Number(value) if value.is_finite() => EchoedCell::Literal(text),
        _ => EchoedCell::Text(text),
    }
}
