//! The rows of a batch as they stand on the wire: read piece by piece into blocks of columns, wherever the pieces end.

mod arrow;
mod block;
mod columns;
mod csv;
mod echo;
mod memory;
mod ndjson;

pub(crate) use block::{Block, Shape};
pub(crate) use columns::{Columns, Echo, Wanted};
pub(crate) use echo::EchoedCell;
pub use memory::Cells;
pub(crate) use memory::{columns_of, fill, unfit};

use std::sync::Arc;

use crate::problem::Problem;
use arrow::ArrowRows;
use csv::CsvRows;
use ndjson::NdjsonRows;

/// What a reader makes of its input.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum Read {
    /// The block is full.
    Full,
    /// The input is used up.
    More,
    /// The rows are at their end.
    End,
}

/// A reader of rows.
pub(crate) enum Reader {
    Csv(Box<CsvRows>),
    Ndjson(Box<NdjsonRows>),
    Arrow(Box<ArrowRows>),
}

impl Reader {
    pub(crate) fn csv(wanted: Wanted) -> Self {
        Self::Csv(Box::new(CsvRows::new(wanted)))
    }

    pub(crate) fn ndjson(wanted: Wanted) -> Self {
        Self::Ndjson(Box::new(NdjsonRows::new(wanted)))
    }

    pub(crate) fn arrow(wanted: Wanted) -> Self {
        Self::Arrow(Box::new(ArrowRows::new(wanted)))
    }

    /// Whether there are more rows without further input.
    pub(crate) fn holds_input(&self) -> bool {
        match self {
            Self::Csv(_) | Self::Ndjson(_) => false,
            Self::Arrow(reader) => reader.holds_input(),
        }
    }

    /// Adds rows to `block`; takes what it uses off `input`. With `last` nothing comes after `input`.
    ///
    /// # Errors
    /// Where the rows cannot be read any further.
    pub(crate) fn fill(&mut self, input: &mut &[u8], last: bool, block: &mut Block) -> Result<Read, Problem> {
        if let Some(columns) = self.columns() {
            block.with(columns);
        }
        match self {
            Self::Csv(reader) => reader.fill(input, last, block),
            Self::Ndjson(reader) => reader.fill(input, last, block),
            Self::Arrow(reader) => reader.fill(input, last, block),
        }
    }

    /// The columns, once they are known: with the first row at the latest.
    pub(crate) fn columns(&self) -> Option<&Arc<Columns>> {
        match self {
            Self::Csv(reader) => reader.columns(),
            Self::Ndjson(reader) => reader.columns(),
            Self::Arrow(reader) => reader.columns(),
        }
    }
}
