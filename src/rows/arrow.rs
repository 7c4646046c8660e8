//! Rows of an Arrow stream: record batches, each a block of columns already.

mod cells;

use std::panic::{AssertUnwindSafe, catch_unwind};
use std::sync::Arc;

use arrow_array::RecordBatch;
use arrow_buffer::Buffer;
use arrow_ipc::reader::StreamDecoder;
use arrow_schema::{ArrowError, Schema};
use terramechanics_reading::FieldFault;

use super::columns::CellKind;
use super::{Block, Columns, Read, Wanted};
use crate::problem::Problem;
use crate::series::SeriesFault;
use cells::{column_of, echo_of, kind_of, largest_dictionary};

/// Largest record batch, with the dictionaries before it (bytes).
const LARGEST_BATCH: usize = 16 << 20;

/// Most rows of a record batch: some columns take no bytes.
const MOST_ROWS: usize = 1 << 20;

/// Most columns.
const MOST_COLUMNS: usize = 256;

/// Reads a stream piece by piece.
pub(crate) struct ArrowRows {
    wanted: Wanted,
    decoder: StreamDecoder,
    columns: Option<Arc<Columns>>,
    /// What came and was not decoded yet.
    pending: Buffer,
    /// Bytes since the last record batch.
    undecoded: usize,
    /// A record batch, and how many of its rows were taken.
    current: Option<(RecordBatch, usize)>,
    has_rows: bool,
}

impl ArrowRows {
    pub(super) fn new(wanted: Wanted) -> Self {
        Self {
            wanted,
            decoder: StreamDecoder::new(),
            columns: None,
            pending: Buffer::from(&[]),
            undecoded: 0,
            current: None,
            has_rows: false,
        }
    }

    pub(super) fn columns(&self) -> Option<&Arc<Columns>> {
        self.columns.as_ref()
    }

    /// Whether there is more without further input.
    pub(super) fn holds_input(&self) -> bool {
        self.current.is_some() || !self.pending.is_empty()
    }

    pub(super) fn fill(&mut self, input: &mut &[u8], last: bool, block: &mut Block) -> Result<Read, Problem> {
        loop {
            if block.is_full() {
                return Ok(Read::Full);
            }
            if let Some((batch, at)) = &mut self.current {
                let rows = (batch.num_rows() - *at).min(block.room());
                let part = batch.slice(*at, rows);
                *at += rows;
                if *at == batch.num_rows() {
                    self.current = None;
                }
                self.take(&part, block);
                // A column that is repeated as it came is of one array.
                if self.columns.as_ref().is_some_and(|columns| columns.kept.iter().any(Option::is_some)) {
                    return Ok(Read::Full);
                }
                continue;
            }
            if self.pending.is_empty() {
                if input.is_empty() {
                    return if last { self.end() } else { Ok(Read::More) };
                }
                self.pending = Buffer::from(std::mem::take(input));
            }
            self.decode()?;
        }
    }

    /// The end of the input.
    fn end(&mut self) -> Result<Read, Problem> {
        self.decoder.finish().map_err(|error| unreadable(&error))?;
        if !self.has_rows {
            return Err(fault("the stream has no rows"));
        }
        Ok(Read::End)
    }

    /// The next record batch of what came, if it is complete.
    fn decode(&mut self) -> Result<(), Problem> {
        let before = self.pending.len();
        let (decoder, pending) = (&mut self.decoder, &mut self.pending);
        // The decoder takes it for granted that a message has the header that it names.
        let decoded = catch_unwind(AssertUnwindSafe(|| decoder.decode(pending)));
        let batch = decoded.map_err(|_| fault("a message of the stream is malformed"))?.map_err(|error| unreadable(&error))?;
        self.undecoded += before - self.pending.len();
        if self.undecoded > LARGEST_BATCH || batch.as_ref().is_some_and(|batch| largest_dictionary(batch) > LARGEST_BATCH) {
            let most = LARGEST_BATCH >> 20;
            return Err(fault(&format!("a record batch may have at most {most} MiB; write batches of fewer rows")));
        }
        if self.columns.is_none()
            && let Some(schema) = self.decoder.schema()
        {
            self.columns = Some(Arc::new(self.columns_of(&schema)?));
        }
        if let Some(batch) = batch {
            if batch.num_rows() > MOST_ROWS {
                return Err(fault(&format!("a record batch may have at most {MOST_ROWS} rows")));
            }
            self.undecoded = 0;
            self.current = Some((batch, 0)).filter(|(batch, _)| batch.num_rows() > 0);
        }
        Ok(())
    }

    fn columns_of(&self, schema: &Schema) -> Result<Columns, Problem> {
        if schema.fields().len() > MOST_COLUMNS {
            return Err(fault(&format!("a stream may have at most {MOST_COLUMNS} columns")));
        }
        let names: Vec<String> = schema.fields().iter().map(|field| field.name().clone()).collect();
        let mut columns = self.wanted.columns(&names).map_err(Problem::Invalid)?;
        let mut faults = Vec::new();
        for (i, field) in schema.fields().iter().enumerate() {
            let kind = kind_of(field.data_type());
            let taken = columns.field_of[i].map_or(Ok(()), |place| match kind {
                CellKind::Texts => columns.takes(place, kind, "texts"),
                CellKind::Flags => columns.takes(place, kind, "booleans"),
                _ => columns.takes(place, kind, field.data_type()),
            });
            faults.extend(taken.err());
            if let Some(echo) = columns.echo_of[i] {
                let is_own = self.wanted.keeps_arrays && kind != CellKind::Texts;
                if !is_own && kind == CellKind::Others {
                    faults.push(FieldFault::new(
                        "/echo",
                        format!("`{}` is of a kind that is not repeated: {}", field.name(), field.data_type()),
                    ));
                }
                columns.kept[echo] = is_own.then(|| field.data_type().clone());
            }
        }
        if faults.is_empty() { Ok(columns) } else { Err(Problem::Invalid(faults)) }
    }

    /// Adds the rows of a part of a record batch.
    fn take(&mut self, part: &RecordBatch, block: &mut Block) {
        let Some(columns) = &self.columns else { return };
        self.has_rows = true;
        block.with(columns);
        block.begin_rows(part.num_rows());
        for (i, array) in part.columns().iter().enumerate() {
            if let Some(field) = columns.field_of[i] {
                column_of(array, field, block);
            }
            if let Some(echo) = columns.echo_of[i] {
                match columns.kept[echo] {
                    Some(_) => block.keep(echo, array),
                    None => echo_of(array, echo, block),
                }
            }
        }
        block.end_rows();
    }
}

fn fault(detail: &str) -> Problem {
    Problem::Unreadable(SeriesFault { line: 0, column: 0, detail: detail.to_owned() })
}

fn unreadable(error: &ArrowError) -> Problem {
    // Compressed buffers tell a size that only their decompression can prove. A packed body is unpacked within its bounds.
    if error.to_string().contains("IPC decompression") {
        return fault(
            "the buffers of a record batch are compressed; write them without compression, and pack the whole body instead (Content-Encoding: zstd or gzip)",
        );
    }
    fault(&format!("the body is not an Arrow stream that can be read: {error}"))
}
