//! Rows of a table: separated by commas, semicolons or tabs, below a header with the names of the columns.

use std::borrow::Cow;
use std::sync::Arc;

use terramechanics_reading::Node;

use super::echo::EchoedCell;
use super::{Block, Columns, Read, Wanted};
use crate::problem::Problem;
use crate::series::{Next, Records, number};

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
        let Some(columns) = &self.columns else { return self.heading(block) };
        let (found, expected) = (self.records.cells(), columns.len());
        if found == 1 && expected > 1 && self.records.cell(0).is_empty() {
            return Ok(()); // blanks
        }
        self.has_rows = true;
        if found != expected {
            let hint = if self.records.cell(0).starts_with(b"#") { "; comments stand above it" } else { "" };
            let detail = format!("the number of cells is {found}, the header has {expected}{hint}");
            block.faulty_row(self.records.fault(0, detail).to_string());
            return Ok(());
        }
        let mut unread = None;
        for at in 0..expected {
            let (field, echo) = (columns.field_of[at], columns.echo_of[at]);
            if field.is_none() && echo.is_none() {
                continue;
            }
            let cell = self.records.cell(at);
            let Ok(text) = std::str::from_utf8(cell) else {
                unread.get_or_insert_with(|| self.records.fault(at + 1, "the cell is not UTF-8"));
                continue;
            };
            if let Some(field) = field.filter(|_| unread.is_none()) {
                field_of_cell(block, field, columns.is_number[field], text);
            }
            if let Some(column) = echo {
                block.echo(column, echo_of_cell(text));
            }
        }
        match unread {
            None => block.end_row(),
            Some(fault) => block.faulty_row(fault.to_string()),
        }
        Ok(())
    }

    fn heading(&mut self, block: &mut Block) -> Result<(), Problem> {
        let mut names = Vec::with_capacity(self.records.cells());
        for at in 0..self.records.cells() {
            let Ok(name) = std::str::from_utf8(self.records.cell(at)) else {
                return Err(self.fault(at + 1, "the name of the column is not UTF-8; save the table as UTF-8"));
            };
            names.push(name.to_owned());
        }
        if names.iter().any(|name| !name.is_empty()) {
            let columns = self.wanted.columns(&names).map_err(Problem::Invalid)?;
            block.with(&columns);
            self.columns = Some(Arc::new(columns));
            self.records.end_comments();
        }
        Ok(())
    }
}

/// Whether the text stands for a value that is not there.
fn is_missing(cell: &str) -> bool {
    cell.is_empty() || ["na", "n/a", "null", "none"].iter().any(|missing| cell.eq_ignore_ascii_case(missing))
}

#[inline]
fn field_of_cell(block: &mut Block, field: usize, is_number: bool, cell: &str) {
    if is_missing(cell) {
        return;
    }
    if is_number && let Some(value) = number(cell.as_bytes()).filter(|value| !value.is_nan()) {
        return block.number(field, value);
    }
    block.text(field, cell, |text| Node::of_text(Cow::Owned(text.to_owned())));
}

fn echo_of_cell(text: &str) -> EchoedCell<'_> {
    match Node::of_text(Cow::Borrowed(text)) {
        _ if text.is_empty() => EchoedCell::Nothing,
        Node::Number(value) if value.is_finite() => EchoedCell::Literal(text),
        _ => EchoedCell::Text(text),
    }
}
