//! The rows of a sweep as they are computed.

use std::time::Instant;

use axum::body::Bytes;

use super::found::{FoundGrid, Running};
use super::reply::{STATUS, names};
use crate::compute::SLICE;
use crate::problem::Problem;
use crate::quantity::Cell;
use crate::reply::{AssumedReply, End, RowFormat};
use crate::stream::{PIECE, Progress, Work};
use crate::varied::Varied;

/// Rows of a sweep, in a format that is written row by row.
#[derive(Debug)]
pub(super) struct Stream<R> {
    running: Running<R>,
    format: RowFormat,
    /// Of the columns, with the status.
    names: Vec<String>,
    has_begun: bool,
    cells: Vec<f64>,
}

impl<R: Varied> Stream<R> {
    pub(super) fn of(running: Running<R>, format: RowFormat) -> Self {
        let names = names(&running).map(String::from).chain([STATUS.to_owned()]).collect();
        Self { running, format, names, has_begun: false, cells: Vec::new() }
    }

    /// Writes a row; false after the last.
    fn row(&mut self, output: &mut Vec<u8>) -> bool {
        self.cells.clear();
        let Some(status) = self.running.next_row(&mut self.cells) else { return false };
        let cells = self.cells.iter().copied().map(Cell::Number).chain([Cell::Word(status.name())]);
        self.format.row(self.names.iter().map(String::as_str).zip(cells), output);
        true
    }

    fn end(&mut self, output: &mut Vec<u8>) {
        let FoundGrid { rows, warnings, assumed } = self.running.end();
        let assumed = assumed.map(|assumed| assumed.into_iter().map(AssumedReply::from).collect());
        self.format.end(&End { end: true, rows: rows as u64, warnings, assumed }, output);
    }
}

impl<R: Varied> Work for Stream<R> {
    fn media_type(&self) -> &'static str {
        match self.format {
            RowFormat::Csv => "text/csv; charset=utf-8; header=present",
            RowFormat::Ndjson => "application/x-ndjson",
        }
    }

    /// There is no input: all was asked at the beginning.
    fn slice(&mut self, _: &mut Bytes, _: bool, output: &mut Vec<u8>) -> Result<Progress, Problem> {
        let slice_end = Instant::now() + SLICE;
        if !self.has_begun {
            self.has_begun = true;
            self.format.head(self.names.iter().map(String::as_str), output);
        }
        while output.len() < PIECE && Instant::now() < slice_end {
            if !self.row(output) {
                self.end(output);
                return Ok(Progress::Complete);
            }
        }
        Ok(Progress::Paused)
    }

    fn broken(&self, problem: &Problem, output: &mut Vec<u8>) {
        self.format.broken(&problem.detail(), output);
    }
}
