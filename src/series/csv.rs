//! Tables of telemetry: separated by commas, semicolons or tabs, with a decimal point or comma, with or without a byte order
//! mark, carriage returns, quotes, comments after `#` and a row of units below the header.

use csv_core::{ReadRecordResult, ReaderBuilder};

use super::{Cells, Column, LONGEST_ROW, Layout, Read, SeriesFault};
use crate::wire::nearest;

/// Cells that a row may have: more than there are columns, so that a wrong header can be named.
const MOST_CELLS: usize = 64;

/// How the unit of each column may be written in a row of units; brackets around it are left out.
const UNITS: [&[&str]; Column::COUNT] = [
    &["s", "sec"],
    &["-", "–", "1", ""],
    &["m/s", "m s-1", "m s^-1", "m·s⁻¹", "ms-1"],
    &["rad/s", "1/s", "rad s-1", "rad s^-1", "rad·s⁻¹"],
    &["m"],
    &["N m", "N·m", "Nm", "N*m", "N.m"],
    &["N"],
];

/// Reads a table piece by piece.
pub(crate) struct CsvReader {
    state: State,
    record: [u8; LONGEST_ROW],
    filled: usize,
    ends: [usize; MOST_CELLS],
    cells: usize,
    /// Line ends that are behind, and the last byte that is.
    newlines: u64,
    latest: u8,
    /// The column of each cell, from the header.
    order: Vec<usize>,
    layout: Layout,
}

enum State {
    /// The header is not complete yet: what there is of it and of comments before it.
    Start(Vec<u8>),
    /// The header is read next, then rows; what was held back for it is read first.
    Rows { core: Box<csv_core::Reader>, held: Vec<u8>, used: usize, expected: Expected },
}

#[derive(Clone, Copy, PartialEq, Eq)]
enum Expected {
    Header,
    UnitsOrRow,
    Row,
}

impl std::fmt::Debug for CsvReader {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        f.debug_struct("CsvReader").field("newlines", &self.newlines).finish_non_exhaustive()
    }
}

impl Default for CsvReader {
    fn default() -> Self {
        Self {
            state: State::Start(Vec::new()),
            record: [0; LONGEST_ROW],
            filled: 0,
            ends: [0; MOST_CELLS],
            cells: 0,
            newlines: 0,
            latest: 0,
            order: Vec::new(),
            layout: Layout::default(),
        }
    }
}

impl CsvReader {
    pub(super) fn layout(&self) -> Option<Layout> {
        (!self.order.is_empty()).then_some(self.layout)
    }

    pub(super) fn next(&mut self, input: &mut &[u8], last: bool) -> Result<Read, SeriesFault> {
        if !self.has_started(input, last)? {
            return Ok(Read::More);
        }
        loop {
            match self.read_record(input, last) {
                ReadRecordResult::InputEmpty => return Ok(Read::More),
                ReadRecordResult::End if self.order.is_empty() => return Err(self.fault(0, "the table has no header")),
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
                    if let Some(cells) = read? {
                        return Ok(Read::Row(cells));
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
            if ended && header(held).is_some() {
                break;
            }
            if held.len() >= LONGEST_ROW {
                return Err(self.fault(0, format!("the header may have at most {LONGEST_ROW} bytes")));
            }
        }
        let complete = held.last().is_some_and(|byte| matches!(byte, b'\n' | b'\r')) && header(held).is_some();
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
        let separator = header(&held).map_or(b',', separator);
        let core = Box::new(ReaderBuilder::new().delimiter(separator).comment(Some(b'#')).build());
        self.state = State::Rows { core, held, used: 0, expected: Expected::Header };
        Ok(true)
    }

    fn read_record(&mut self, input: &mut &[u8], last: bool) -> ReadRecordResult {
        let State::Rows { core, held, used, .. } = &mut self.state else { return ReadRecordResult::InputEmpty };
        loop {
            let from_held = *used < held.len();
            let source = if from_held { &held[*used..] } else { *input };
            if source.is_empty() && !last {
                return ReadRecordResult::InputEmpty;
            }
            // An empty source tells the reader that there is no more.
            let (result, read, written, ended) =
                core.read_record(source, &mut self.record[self.filled..], &mut self.ends[self.cells..]);
            let behind = source[..read].iter().filter(|byte| **byte == b'\n').count();
            self.newlines += behind as u64;
            self.latest = source[..read].last().copied().unwrap_or(self.latest);
            if from_held {
                *used += read;
            } else {
                *input = &input[read..];
            }
            self.filled += written;
            self.cells += ended;
            if result != ReadRecordResult::InputEmpty {
                return result;
            }
        }
    }

    /// What a record gives: a sample, or nothing where it is the header, a row of units or blank.
    fn record(&mut self) -> Result<Option<Cells>, SeriesFault> {
        let State::Rows { expected, .. } = &mut self.state else { return Ok(None) };
        if self.cells == 1 && self.record[..self.ends[0]].trim_ascii().is_empty() {
            return Ok(None); // blanks
        }
        match std::mem::replace(expected, if *expected == Expected::Header { Expected::UnitsOrRow } else { Expected::Row }) {
            Expected::Header => self.header().map(|()| None),
            Expected::UnitsOrRow if self.is_of_units() => self.units().map(|()| None),
            _ => self.row().map(Some),
        }
    }

    fn cell(&self, index: usize) -> &[u8] {
        let start = if index == 0 { 0 } else { self.ends[index - 1] };
        self.record[start..self.ends[index]].trim_ascii()
    }

    fn word(&self, index: usize) -> String {
        crate::wire::shortened(&String::from_utf8_lossy(self.cell(index)))
    }

    fn header(&mut self) -> Result<(), SeriesFault> {
        for at in 0..self.cells {
            let name = self.word(at);
            let Some(index) = Column::NAMES.iter().position(|known| *known == name) else {
                let known = match nearest(&name, &Column::NAMES) {
                    Some(near) => format!("did you mean `{near}`?"),
                    None => format!("known are {}", Column::NAMES.join(", ")),
                };
                return Err(self.fault(at + 1, format!("unknown column `{name}`; {known}")));
            };
            if self.order.contains(&index) {
                return Err(self.fault(at + 1, format!("the column `{name}` is there more than once")));
            }
            self.order.push(index);
            self.layout.add(index);
        }
        Ok(())
    }

    /// Whether the row below the header has a word where the time should be.
    fn is_of_units(&self) -> bool {
        let time = self.order.iter().position(|&index| index == Column::Time as usize);
        self.cells == self.order.len() && time.is_some_and(|at| number(self.cell(at)).is_none())
    }

    fn units(&self) -> Result<(), SeriesFault> {
        for (at, &index) in self.order.iter().enumerate() {
            let word = self.word(at);
            let unit = word.trim_matches(['[', ']', '(', ')', ' ']);
            if !UNITS[index].contains(&unit) {
                let name = Column::NAMES[index];
                return Err(
                    self.fault(at + 1, format!("`{word}` is no number, and not the unit of `{name}`, {}", UNITS[index][0]))
                );
            }
        }
        Ok(())
    }

    fn row(&self) -> Result<Cells, SeriesFault> {
        if self.cells != self.order.len() {
            let at = self.cells.min(self.order.len()) + 1;
            let (found, expected) = (self.cells, self.order.len());
            return Err(self.fault(at, format!("the number of cells is {found}, the header has {expected}")));
        }
        let mut cells = [f64::NAN; Column::COUNT];
        for (at, &index) in self.order.iter().enumerate() {
            cells[index] = number(self.cell(at)).ok_or_else(|| {
                self.fault(at + 1, format!("`{}` is not a number (column `{}`)", self.word(at), Column::NAMES[index]))
            })?;
        }
        Ok(cells)
    }

    /// A fault of the row that was read last.
    fn fault(&self, column: usize, detail: impl Into<String>) -> SeriesFault {
        let line = if self.latest == b'\n' { self.newlines } else { self.newlines + 1 };
        SeriesFault { line, column, detail: detail.into() }
    }
}

const BYTE_ORDER_MARK: &[u8] = "\u{feff}".as_bytes();

/// The first line that is neither blank nor a comment.
fn header(text: &[u8]) -> Option<&[u8]> {
    let text = text.strip_prefix(BYTE_ORDER_MARK).unwrap_or(text);
    text.split(|byte| matches!(byte, b'\n' | b'\r')).find(|line| !line.trim_ascii().is_empty() && !line.starts_with(b"#"))
}

fn separator(header: &[u8]) -> u8 {
    [b';', b'\t'].into_iter().find(|separator| header.contains(separator)).unwrap_or(b',')
}

/// The number in a cell: NaN for an empty one and for the words that stand for a missing value, none for any other text.
fn number(cell: &[u8]) -> Option<f64> {
    let text = std::str::from_utf8(cell).ok()?;
    if let Ok(number) = text.parse() {
        return Some(number);
    }
    if ["", "na", "n/a", "null", "none", "-"].iter().any(|missing| text.eq_ignore_ascii_case(missing)) {
        return Some(f64::NAN);
    }
    // A decimal comma, where the point does not stand for something else.
    if text.len() <= 40 && text.matches(',').count() == 1 && !text.contains('.') {
        return text.replace(',', ".").parse().ok();
    }
    None
}
