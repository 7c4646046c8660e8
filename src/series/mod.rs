//! Time series of telemetry as they stand on the wire: read piece by piece, in constant memory, wherever the pieces end.

mod csv;
mod lines;
mod ndjson;
#[cfg(any(test, fuzzing))]
mod pieces;

use csv::CsvReader;
pub(crate) use csv::{Next, Records, number};
pub(crate) use lines::{Line, Lines};
use ndjson::NdjsonReader;
#[cfg(fuzzing)]
pub(crate) use pieces::all;

use std::fmt;

/// A column that a series may have.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum Column {
    Time,
    Slip,
    ForwardVelocity,
    AngularVelocity,
    Sinkage,
    Torque,
    NormalLoad,
}

impl Column {
    pub(crate) const COUNT: usize = 7;

    /// Names on the wire, in the order of the variants.
    pub(crate) const NAMES: [&str; Self::COUNT] =
        ["time_s", "slip", "forward_velocity_m_s", "angular_velocity_rad_s", "sinkage_m", "torque_n_m", "normal_load_n"];

    pub(crate) const fn name(self) -> &'static str {
        Self::NAMES[self as usize]
    }
}

/// The values of one sample, by column; NaN for one that is missing.
pub(crate) type Cells = [f64; Column::COUNT];

/// A sample as it was read.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Row {
    pub(crate) cells: Cells,
    /// Whether one of the missing values was there, but is no number.
    pub(crate) unreadable: bool,
}

/// What becomes of columns that no sample has.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum ExtraColumns {
    Refuse,
    Ignore,
}

/// How they can be left out, for those who sent them.
pub(crate) const LEAVING_OUT: &str = "extra_columns=ignore leaves unknown ones out";

/// The columns that a series has.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub(crate) struct Layout([bool; Column::COUNT]);

impl Layout {
    pub(crate) fn has(self, column: Column) -> bool {
        self.0[column as usize]
    }

    pub(crate) fn add(&mut self, index: usize) {
        self.0[index] = true;
    }
}

/// Longest row of a series, and longest header (bytes).
pub(crate) const LONGEST_ROW: usize = 8192;

/// Why a series cannot be read any further.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct SeriesFault {
    /// Line, from 1; 0 where there are no lines.
    pub(crate) line: u64,
    /// Column, from 1: of a table the cell, of a JSON text the character; 0 where the whole line is meant.
    pub(crate) column: usize,
    /// What is wrong.
    pub(crate) detail: String,
}

impl fmt::Display for SeriesFault {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self.column {
            _ if self.line == 0 => f.write_str(&self.detail),
            0 => write!(f, "line {}: {}", self.line, self.detail),
            column => write!(f, "line {}, column {column}: {}", self.line, self.detail),
        }
    }
}

/// Values that are no numbers and were taken as missing.
#[derive(Debug, Clone, Default)]
pub(crate) struct Unreadable {
    pub(crate) count: u64,
    pub(crate) first: Option<SeriesFault>,
}

impl Unreadable {
    /// Counts a value. `first` gives the place of the first one and is none for the others.
    fn count(&mut self, first: Option<SeriesFault>) {
        self.count += 1;
        self.first = self.first.take().or(first);
    }
}

/// What a reader makes of its input.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) enum Read {
    /// A sample.
    Row(Row),
    /// The input is used up.
    More,
    /// The series is at its end.
    End,
}

/// A reader of a series.
#[derive(Debug)]
pub(crate) enum Reader {
    Csv(Box<CsvReader>),
    Ndjson(NdjsonReader),
}

impl Reader {
    pub(crate) fn csv(extra: ExtraColumns) -> Self {
        Self::Csv(Box::new(CsvReader::new(extra)))
    }

    pub(crate) fn ndjson(extra: ExtraColumns) -> Self {
        Self::Ndjson(NdjsonReader::new(extra))
    }

    /// The next sample; takes what it uses off `input`. With `last` nothing comes after `input`.
    ///
    /// # Errors
    /// Where the series cannot be read any further.
    pub(crate) fn next(&mut self, input: &mut &[u8], last: bool) -> Result<Read, SeriesFault> {
        match self {
            Self::Csv(reader) => reader.next(input, last),
            Self::Ndjson(reader) => reader.next(input, last),
        }
    }

    /// The columns, once they are known: with the first sample at the latest.
    pub(crate) fn layout(&self) -> Option<Layout> {
        match self {
            Self::Csv(reader) => reader.layout(),
            Self::Ndjson(reader) => reader.layout(),
        }
    }

    /// The values so far that are no numbers.
    pub(crate) fn unreadable(&self) -> &Unreadable {
        match self {
            Self::Csv(reader) => reader.unreadable(),
            Self::Ndjson(reader) => reader.unreadable(),
        }
    }
}
