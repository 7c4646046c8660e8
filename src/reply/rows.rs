//! Answers that are written row by row, with an end that tells a whole one from one that was cut.

use std::io::Write;

use serde::Serialize;

use crate::quantity::{Cell, Digits, line, ndjson_line};

/// A format that is written row by row.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum RowFormat {
    /// A header, rows, and comments after `#` at the end; the last comment is `#end,<rows>`.
    Csv,
    /// An object per row; at the end an object with `end`.
    Ndjson,
}

impl RowFormat {
    /// What stands before the first row.
    pub(crate) fn head<'a>(self, names: impl IntoIterator<Item = &'a str>, out: &mut Vec<u8>) {
        if self == Self::Csv {
            line(names.into_iter().map(Cell::Word), Digits::Json, out);
        }
    }

    /// A row.
    pub(crate) fn row<'a>(self, cells: impl IntoIterator<Item = (&'a str, Cell<'a>)>, out: &mut Vec<u8>) {
        match self {
            Self::Csv => line(cells.into_iter().map(|(_, cell)| cell), Digits::Json, out),
            Self::Ndjson => ndjson_line(cells, out),
        }
    }

    /// The line after the last row where the answer ends too early.
    pub(crate) fn broken(self, problem: &str, out: &mut Vec<u8>) {
        match self {
            Self::Csv => comment(&["error", problem], out),
            Self::Ndjson => object(&serde_json::json!({ "error": problem }), out),
        }
    }
}

/// A comment of several cells; the last may be any text without a line end.
pub(crate) fn comment(cells: &[&str], out: &mut Vec<u8>) {
    let _ = writeln!(out, "#{}", cells.join(",").replace(['\n', '\r'], " "));
}

/// A line that is an object.
pub(crate) fn object<T: Serialize>(value: &T, out: &mut Vec<u8>) {
    let _ = serde_json::to_writer(&mut *out, value);
    out.push(b'\n');
}
