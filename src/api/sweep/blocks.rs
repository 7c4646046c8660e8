//! The rows of a sweep as they are computed: several blocks of them at once, sent in their order.

use std::sync::Arc;
use std::time::Instant;

use arrow_schema::DataType;
use axum::body::Bytes;

use super::found::{FoundGrid, Running};
use super::reply::{STATUS, names};
use crate::compute::{Pace, SLICE};
use crate::extract::RowsForm;
use crate::problem::Problem;
use crate::quantity::Cell;
use crate::reply::arrow::{ArrowStream, numbers, texts};
use crate::reply::{AssumedReply, End, RowFormat};
use crate::stream::{BlockWork, Job, Taken};
use crate::varied::Varied;

/// How rows are written.
#[derive(Debug)]
enum Writer {
    Text(RowFormat),
    Arrow(ArrowStream),
}

/// What all blocks have in common.
#[derive(Debug)]
struct Plan {
    writer: Writer,
    /// Of the columns, with the status.
    names: Vec<String>,
}

/// Rows of a sweep, in a form that is written while others are computed.
pub(super) struct GridBlocks<R> {
    /// What is to be said of all rows so far.
    running: Running<R>,
    form: RowsForm,
    plan: Arc<Plan>,
    /// The first row of the next block.
    next: usize,
    has_begun: bool,
    /// Blocks that are done, to be used again.
    spare: Vec<Block<R>>,
}

/// A block under way.
pub(super) struct Block<R> {
    plan: Arc<Plan>,
    running: Running<R>,
    cells: Vec<f64>,
    /// By column, and the status of each row, for record batches.
    columns: Vec<Vec<f64>>,
    status: Vec<&'static str>,
    output: Vec<u8>,
}

impl<R: Varied> GridBlocks<R> {
    pub(super) fn of(running: Running<R>, form: RowsForm) -> Self {
        let names: Vec<String> = names(&running).map(String::from).collect();
        let writer = match form {
            RowsForm::Csv => Writer::Text(RowFormat::Csv),
            RowsForm::Ndjson => Writer::Text(RowFormat::Ndjson),
            RowsForm::Arrow => {
                Writer::Arrow(ArrowStream::new(names.iter().map(|name| (name.clone(), DataType::Float64)), STATUS))
            }
        };
        let names = names.into_iter().chain([STATUS.to_owned()]).collect();
        Self { running, form, plan: Arc::new(Plan { writer, names }), next: 0, has_begun: false, spare: Vec::new() }
    }

    /// The next rows; none behind the last.
    fn block(&mut self) -> Option<Box<Block<R>>> {
        let end = (self.next + R::ROWS_PER_BLOCK).min(self.running.len());
        let rows = self.next..end;
        if rows.is_empty() {
            return None;
        }
        self.next = end;
        Some(Box::new(match self.spare.pop() {
            Some(mut block) => {
                block.running.restart(rows);
                block
            }
            None => Block {
                plan: self.plan.clone(),
                running: self.running.part(rows),
                cells: Vec::new(),
                columns: vec![Vec::new(); self.plan.names.len() - 1],
                status: Vec::new(),
                output: Vec::new(),
            },
        }))
    }
}

impl<R: Varied> Block<R> {
    /// Computes a row; false after the last.
    fn row(&mut self) -> bool {
        self.cells.clear();
        let Some(status) = self.running.next_row(&mut self.cells, &Pace::at_once()) else { return false };
        match &self.plan.writer {
            Writer::Text(format) => {
                let cells = self.cells.iter().copied().map(Cell::Number).chain([Cell::Word(status.name())]);
                format.row(self.plan.names.iter().map(String::as_str).zip(cells), &mut self.output);
            }
            Writer::Arrow(_) => {
                self.columns.iter_mut().zip(&self.cells).for_each(|(column, cell)| column.push(*cell));
                self.status.push(status.name());
            }
        }
        true
    }
}

impl<R: Varied> Job for Block<R> {
    fn slice(&mut self) -> bool {
        let slice_end = Instant::now() + SLICE;
        while self.row() {
            if Instant::now() >= slice_end {
                return false;
            }
        }
        if let Writer::Arrow(stream) = &self.plan.writer {
            let mut arrays: Vec<_> = self.columns.iter_mut().map(|column| numbers(std::mem::take(column))).collect();
            arrays.push(texts(self.status.drain(..).map(Some)));
            stream.rows(arrays, &mut self.output);
        }
        true
    }
}

impl<R: Varied> BlockWork for GridBlocks<R> {
    type Job = Block<R>;

    fn media_type(&self) -> &'static str {
        self.form.content_type()
    }

    /// There is no input: all was asked at the beginning.
    fn holds_input(&self) -> bool {
        true
    }

    fn take(&mut self, _: &mut Bytes, _: bool) -> Result<Taken<Block<R>>, Problem> {
        Ok(self.block().map_or(Taken::End(None), Taken::Block))
    }

    fn flush(&mut self) -> Option<Box<Block<R>>> {
        None
    }

    fn give(&mut self, mut block: Box<Block<R>>) -> Result<Bytes, Problem> {
        let mut output = Vec::new();
        if !self.has_begun {
            self.has_begun = true;
            match &self.plan.writer {
                Writer::Text(format) => format.head(self.plan.names.iter().map(String::as_str), &mut output),
                Writer::Arrow(stream) => stream.head(&mut output),
            }
        }
        let room = block.output.len();
        output.append(&mut block.output);
        block.output = Vec::with_capacity(room);
        self.running.follow(&mut block.running);
        self.spare.push(*block);
        Ok(output.into())
    }

    fn end(&mut self) -> Bytes {
        let FoundGrid { rows, warnings, assumed } = self.running.end();
        let assumed = assumed.map(|assumed| assumed.into_iter().map(AssumedReply::from).collect());
        let end = End { end: true, rows: rows as u64, warnings, assumed };
        let mut output = Vec::new();
        match &self.plan.writer {
            Writer::Text(format) => format.end(&end, &mut output),
            Writer::Arrow(stream) => stream.end(&end, &mut output),
        }
        output.into()
    }

    fn broken(&self, problem: &Problem) -> Option<Bytes> {
        let Writer::Text(format) = &self.plan.writer else { return None };
        let mut output = Vec::new();
        format.broken(&problem.detail(), &mut output);
        Some(output.into())
    }
}
