//! The records of a table: its cells row by row, wherever the pieces of input end, and the line in which each starts.

use csv_core::{ReadRecordResult, ReaderBuilder};

use super::header::{BYTE_ORDER_MARK, first_line, separator};
use crate::series::{LONGEST_ROW, SeriesFault};

/// Cells that a row may have: more than a log has columns.
const MOST_CELLS: usize = 256;

/// Reads records piece by piece.
pub(crate) struct Records {
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
    /// Whether a line with `#` at its beginning is a comment.
    has_comments: bool,
}

/// What is found next in a table.
pub(crate) enum Next {
    /// A record, until it is cleared.
    Record,
    /// The input is used up.
    More,
    End,
}

enum State {
    /// The header is not complete yet: what there is of it and of comments before it.
    Start(Vec<u8>),
    /// The header is read next, then rows; what was held back for it is read first.
    Rows { core: Box<csv_core::Reader>, held: Vec<u8>, used: usize, within: Within },
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

impl Records {
    pub(crate) fn new() -> Self {
        Self {
            state: State::Start(Vec::new()),
            record: [0; LONGEST_ROW],
            filled: 0,
            ends: [0; MOST_CELLS],
            cells: 0,
            line_ends: 0,
            latest: 0,
            line: 1,
            has_comments: true,
        }
    }

    /// From here on a `#` begins a cell like any other.
    pub(crate) fn end_comments(&mut self) {
        self.has_comments = false;
    }

    /// The next record; takes what it uses off `input`. With `last` nothing comes after `input`.
    pub(crate) fn next(&mut self, input: &mut &[u8], last: bool) -> Result<Next, SeriesFault> {
        if !self.has_started(input, last)? {
            return Ok(Next::More);
        }
        match self.read_record(input, last)? {
            ReadRecordResult::InputEmpty => Ok(Next::More),
            ReadRecordResult::End => Ok(Next::End),
            ReadRecordResult::Record => Ok(Next::Record),
            ReadRecordResult::OutputFull => {
                Err(self.fault(0, format!("a row may have at most {LONGEST_ROW} bytes; is a quote not closed?")))
            }
            ReadRecordResult::OutputEndsFull => Err(self.fault(0, format!("a row may have at most {MOST_CELLS} cells"))),
        }
    }

    /// Makes room for the next record.
    pub(crate) fn clear(&mut self) {
        (self.filled, self.cells) = (0, 0);
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
        self.state = State::Rows { core, held, used: 0, within: Within::Nothing };
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
                (Within::Nothing, Some(b'#')) if self.has_comments => *within = Within::Hash([0; LONGEST_ERROR], 0),
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

    /// How many cells the record has.
    pub(crate) fn cells(&self) -> usize {
        self.cells
    }

    /// A cell without the blanks around it.
    pub(crate) fn cell(&self, index: usize) -> &[u8] {
        let start = if index == 0 { 0 } else { self.ends[index - 1] };
        self.record[start..self.ends[index]].trim_ascii()
    }

    /// A cell as a word for a message.
    pub(crate) fn word(&self, index: usize) -> String {
        terramechanics_reading::shortened(&String::from_utf8_lossy(self.cell(index)))
    }

    /// All cells as words.
    pub(crate) fn words(&self) -> Vec<String> {
        (0..self.cells).map(|at| self.word(at)).collect()
    }

    /// The line in which the record starts.
    pub(crate) fn line(&self) -> u64 {
        self.line
    }

    /// A fault of the record that was read last.
    pub(crate) fn fault(&self, column: usize, detail: impl Into<String>) -> SeriesFault {
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
