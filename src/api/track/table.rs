//! Results of a run, row by row, with an end that tells a whole answer from one that was cut.

use serde::Serialize;

use super::found::FoundTrack;
use super::reply::{EventReply, HeadReply};
use crate::quantity::{Beside, Cell, Digits, Row, SampleCells, line};
use crate::reply::{AssumedReply, RowFormat, comment, object};
use crate::warning::Warning;

/// Writes the rows of a run.
#[derive(Debug, Clone)]
pub(crate) struct Table {
    format: RowFormat,
    cells: SampleCells,
}

impl Table {
    /// The format.
    pub(crate) fn format(&self) -> RowFormat {
        self.format
    }

    pub(crate) fn new(format: RowFormat, beside: Beside) -> Self {
        Self { format, cells: SampleCells::with(beside) }
    }

    /// What stands before the first row.
    pub(crate) fn head(&self, out: &mut Vec<u8>) {
        if self.format == RowFormat::Csv {
            self.cells.header(out);
        }
    }

    pub(crate) fn row(&self, row: &Row<'_>, out: &mut Vec<u8>) {
        match self.format {
            RowFormat::Csv => self.cells.csv(row, out),
            RowFormat::Ndjson => self.cells.ndjson(row, out),
        }
    }

    /// The lines after the last row of a whole answer.
    pub(crate) fn end(&self, found: &FoundTrack, out: &mut Vec<u8>) {
        let FoundTrack { rows, events, warnings, assumed, .. } = found;
        let head = HeadReply::of(found);
        let events: Vec<EventReply> = events.iter().map(EventReply::from).collect();
        match self.format {
            RowFormat::Csv => {
                for (name, word) in head.named() {
                    comment(&["setting", name, word], out);
                }
                for warning in warnings {
                    comment(&["warning", warning.code(), &warning.detail()], out);
                }
                for EventReply { code, row, from_s, to_s } in &events {
                    let mut times = Vec::new();
                    line([Cell::Number(*from_s), Cell::Number(*to_s)], Digits::Json, &mut times);
                    let times = String::from_utf8(times).unwrap_or_default();
                    comment(&["event", code, &row.to_string(), times.trim_end()], out);
                }
                comment(&["end", &rows.to_string()], out);
            }
            RowFormat::Ndjson => {
                let assumed = assumed.clone().map(|assumed| assumed.into_iter().map(AssumedReply::from).collect());
                object(&Last { end: true, rows: *rows, head, warnings, events: &events, assumed }, out);
            }
        }
    }
}

/// The last line of a whole answer.
#[derive(Serialize)]
struct Last<'a> {
    end: bool,
    rows: u64,
    #[serde(flatten)]
    head: HeadReply,
    warnings: &'a [Warning],
    events: &'a [EventReply],
    #[serde(skip_serializing_if = "Option::is_none")]
    assumed: Option<Vec<AssumedReply>>,
}
