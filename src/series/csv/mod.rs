//! Tables of telemetry: separated by commas, semicolons or tabs, with a decimal point or comma, with or without a byte order
//! mark, carriage returns, quotes, comments after `#` and a row of units below the header.

mod header;
#[cfg(test)]
mod tests;

use csv_core::{ReadRecordResult, ReaderBuilder};

use super::{Column, ExtraColumns, LONGEST_ROW, Layout, Read, Row, SeriesFault, Unreadable};
use header::{BYTE_ORDER_MARK, CellFault, Header, first_line, number, separator};

/// Cells that a row may have: more than a log has columns.
const MOST_CELLS: usize = 256;

/// Reads a table piece by piece.
pub(crate) struct CsvReader {
    extra: ExtraColumns,
    state: State,
    record: [u8; LONGEST_ROW],
    filled: usize,
    ends: [usize; MOST_CELLS],
    cells: usize,
    /// Line ends that are behind, and the last byte that is.
    line_ends: u64,
    latest: u8,
    /// The line in which the record starts.
    line: u64,
    header: Header,
    /// Whether there was a row of numbers.
    has_rows: bool,
    unreadable: Unreadable,
}

enum State {
    /// The header is not complete yet: what there is of it and of comments before it.
    Start(Vec<u8>),
    /// The header is read next, then rows; what was held back for it is read first.
    Rows { core: Box<csv_core::Reader>, held: Vec<u8>, used: usize, expected: Expected, within: Within },
}

#[derive(Clone, Copy, PartialEq, Eq)]
enum Expected {
    Header,
    UnitsOrRow,
    Row,
}

/// Where in a table the next byte stands.
#[derive(Clone, Copy, PartialEq, Eq)]
enum Within {
    /// Between records.
    Nothing,
    /// At the beginning of a line with `#`: a comment, unless it turns out as one of [`ERRORS`].
    Hash([u8; LONGEST_ERROR], usize),
    Comment,
    Record,
}

/// What spreadsheets write into a cell that has no value; in the first column it looks like a comment.
const ERRORS: [&[u8]; 7] = [b"#N/A", b"#DIV/0!", b"#VALUE!", b"#REF!", b"#NAME?", b"#NUM!", b"#NULL!"];
const LONGEST_ERROR: usize = 7;

impl std::fmt::Debug for CsvReader {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        f.debug_struct("CsvReader").field("line", &self.line).finish_non_exhaustive()
    }
}

impl CsvReader {
    pub(super) fn new(extra: ExtraColumns) -> Self {
        Self {
            extra,
            state: State::Start(Vec::new()),
            record: [0; LONGEST_ROW],
            filled: 0,
            ends: [0; MOST_CELLS],
            cells: 0,
            line_ends: 0,
            latest: 0,
            line: 1,
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
        if !self.has_started(input, last)? {
            return Ok(Read::More);
        }
        loop {
            match self.read_record(input, last)? {
                ReadRecordResult::InputEmpty => return Ok(Read::More),
                ReadRecordResult::End if self.header.order.is_empty() => return Err(self.fault(0, "the table has no header")),
                ReadRecordResult::End if !self.has_rows => return Err(self.fault(0, "the table has no samples")),
                ReadRecordResult::End => return Ok(Read::End),
                ReadRecordResult::OutputFull => {
                    return Err(self.fault(0, format!("a row may have at most {LONGEST_ROW} bytes; is a quote not closed?")));
                }
                ReadRecordResult::OutputEndsFull => {
                    return Err(self.fault(0, format!("a row may have at most {MOST_CELLS} cells")));
                }
                ReadRecordResult::Record => {
                    let read = self.record();
                    (self.filled, self.cells) = (0, 0);
                    if let Some(row) = read? {
                        return Ok(Read::Row(row));
                    }
                }
            }
        }
    }

    /// Waits for the first line that is neither empty nor a comment, and takes the separator from it.
    fn has_started(&mut self, input: &mut &[u8], last: bool) -> Result<bool, SeriesFault> {
        let State::Start(held) = &mut self.state else { return Ok(true) };
        while let Some((&byte, rest)) = input.split_first() {
            *input = rest;
            held.push(byte);
            let ended = matches!(byte, b'\n' | b'\r');
            if ended && first_line(held).is_some() {
                break;
            }
            if held.len() >= LONGEST_ROW {
                return Err(self.fault(0, format!("the header may have at most {LONGEST_ROW} bytes")));
            }
        }
        let complete = held.last().is_some_and(|byte| matches!(byte, b'\n' | b'\r')) && first_line(held).is_some();
        if !complete && !last {
            return Ok(false);
        }
        if held.starts_with(&[0xff, 0xfe]) || held.starts_with(&[0xfe, 0xff]) {
            return Err(self.fault(0, "the table is UTF-16, save it as UTF-8"));
        }
        let mut held = std::mem::take(held);
        if held.starts_with(BYTE_ORDER_MARK) {
            held.drain(..BYTE_ORDER_MARK.len());
        }
        let core = Box::new(ReaderBuilder::new().delimiter(first_line(&held).map_or(b',', separator)).build());
        self.state = State::Rows { core, held, used: 0, expected: Expected::Header, within: Within::Nothing };
        Ok(true)
    }

    fn read_record(&mut self, input: &mut &[u8], last: bool) -> Result<ReadRecordResult, SeriesFault> {
        let State::Rows { core, held, used, within, .. } = &mut self.state else { return Ok(ReadRecordResult::InputEmpty) };
        loop {
            let from_held = *used < held.len();
            let source = if from_held { &held[*used..] } else { *input };
            if source.is_empty() && !last {
                return Ok(ReadRecordResult::InputEmpty);
            }
            let mut outcome = (ReadRecordResult::InputEmpty, 0, 0, 0);
            match (*within, source.first()) {
                // Comments end with a carriage return as well, which the reader of records would pass over.
                (Within::Nothing, Some(b'#')) => *within = Within::Hash([0; LONGEST_ERROR], 0),
                (Within::Nothing, Some(b'\n' | b'\r')) => outcome.1 = 1,
                (Within::Nothing, Some(_)) => {
                    *within = Within::Record;
                    self.line = self.line_ends + 1;
                }
                (Within::Hash(mut begun, length), Some(&byte)) => {
                    begun[length] = byte; // none of the errors goes on after the longest
                    let begun_with = &begun[..=length];
                    if ERRORS.contains(&begun_with) {
                        *within = Within::Record;
                        self.line = self.line_ends + 1;
                        let (_, _, written, ended) = core.read_record(begun_with, &mut self.record, &mut self.ends);
                        outcome = (ReadRecordResult::InputEmpty, 1, written, ended);
                    } else if ERRORS.iter().any(|error| error.starts_with(begun_with)) {
                        *within = Within::Hash(begun, length + 1);
                        outcome.1 = 1;
                    } else {
                        *within = Within::Comment;
                    }
                }
                (Within::Comment, Some(_)) => {
                    let end = source.iter().position(|byte| matches!(byte, b'\n' | b'\r'));
                    outcome.1 = end.unwrap_or(source.len());
                    *within = if end.is_some() { Within::Nothing } else { Within::Comment };
                }
                (Within::Record, Some(_)) => {
                    outcome = core.read_record(source, &mut self.record[self.filled..], &mut self.ends[self.cells..]);
                }
                (Within::Nothing | Within::Hash(..) | Within::Comment, None) => outcome.0 = ReadRecordResult::End,
                (Within::Record, None) => {
                    // The line end that the last row may lack: only within quotes it is one more byte of the cell.
                    outcome = core.read_record(b"\n", &mut self.record[self.filled..], &mut self.ends[self.cells..]);
                    if outcome.0 == ReadRecordResult::InputEmpty {
                        return Err(self.fault(self.cells + 1, "the quote before this cell is not closed"));
                    }
                    outcome.1 = 0;
                }
            }
            let (result, read, written, ended) = outcome;
            self.line_ends += line_ends(self.latest, &source[..read]);
            self.latest = source[..read].last().copied().unwrap_or(self.latest);
            if from_held {
                *used += read;
            } else {
                *input = &input[read..];
            }
            self.filled += written;
            self.cells += ended;
            if result == ReadRecordResult::Record {
                *within = Within::Nothing;
            }
            if result != ReadRecordResult::InputEmpty {
                return Ok(result);
            }
        }
    }

    /// What a record gives: a sample, or nothing where it is the header, a row of units or blank.
    fn record(&mut self) -> Result<Option<Row>, SeriesFault> {
        let State::Rows { expected, .. } = &mut self.state else { return Ok(None) };
        if self.cells == 1 && self.record[..self.ends[0]].trim_ascii().is_empty() {
            return Ok(None); // blanks
        }
        match std::mem::replace(expected, if *expected == Expected::Header { Expected::UnitsOrRow } else { Expected::Row }) {
            Expected::Header => {
                self.header = Header::read(&self.words(), self.extra).map_err(|fault| self.fault_in(fault))?;
                Ok(None)
            }
            Expected::UnitsOrRow if self.is_of_units() => {
                self.header.check_units(&self.words()).map_err(|fault| self.fault_in(fault))?;
                Ok(None)
            }
            _ => self.row().map(Some),
        }
    }

    fn cell(&self, index: usize) -> &[u8] {
        let start = if index == 0 { 0 } else { self.ends[index - 1] };
        self.record[start..self.ends[index]].trim_ascii()
    }

    fn word(&self, index: usize) -> String {
        terramechanics_reading::shortened(&String::from_utf8_lossy(self.cell(index)))
    }

    fn words(&self) -> Vec<String> {
        (0..self.cells).map(|at| self.word(at)).collect()
    }

    /// Whether the row below the header has a word where the time should be.
    fn is_of_units(&self) -> bool {
        let time = self.header.order.iter().position(|&index| index == Some(Column::Time as usize));
        self.cells == self.header.order.len() && time.is_some_and(|at| number(self.cell(at)).is_none())
    }

    fn row(&mut self) -> Result<Row, SeriesFault> {
        let expected = self.header.order.len();
        if self.cells != expected {
            let (at, found) = (self.cells.min(expected) + 1, self.cells);
            return Err(self.fault(at, format!("the number of cells is {found}, the header has {expected}")));
        }
        let mut row = Row { cells: [f64::NAN; Column::COUNT], unreadable: false };
        for at in 0..expected {
            let Some(index) = self.header.order[at] else { continue };
            let Some(value) = number(self.cell(at)) else {
                let fault =
                    || self.fault(at + 1, format!("`{}` is not a number (column `{}`)", self.word(at), Column::NAMES[index]));
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
        self.fault(column, detail)
    }

    /// A fault of the row that was read last.
    fn fault(&self, column: usize, detail: impl Into<String>) -> SeriesFault {
        SeriesFault { line: self.line, column, detail: detail.into() }
    }
}

/// Line ends in a text that comes after the byte `before`: line feeds, carriage returns, or both together as one.
fn line_ends(before: u8, text: &[u8]) -> u64 {
    let feeds = text.iter().filter(|byte| **byte == b'\n').count();
    let returns = text.iter().filter(|byte| **byte == b'\r').count();
    let mut both = usize::from(before == b'\r' && text.first() == Some(&b'\n'));
    if returns > 0 {
        both += text.windows(2).filter(|pair| *pair == b"\r\n").count();
    }
    (feeds + returns - both) as u64
}
