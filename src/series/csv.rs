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

/// All that a reader makes of the pieces of a table, of which the last ends it: rows by their bits, and the fault.
#[cfg(any(test, fuzzing))]
pub(crate) fn all(pieces: &[&[u8]]) -> (Vec<[u64; Column::COUNT]>, Option<SeriesFault>) {
    let mut reader = CsvReader::default();
    let mut rows = Vec::new();
    for (i, piece) in pieces.iter().enumerate() {
        let mut left = *piece;
        loop {
            match reader.next(&mut left, i + 1 == pieces.len()) {
                Ok(Read::Row(cells)) => rows.push(cells.map(f64::to_bits)),
                Ok(Read::More) => break,
                Ok(Read::End) => return (rows, None),
                Err(fault) => return (rows, Some(fault)),
            }
        }
        assert!(left.is_empty(), "what is there is used");
    }
    panic!("the last piece ends the series");
}

#[cfg(test)]
mod tests {
    use super::*;

    const AWKWARD: &[&str] = &[
        "\u{feff}# log\r\n\r\n\"time_s\";slip\r\n[s];(-)\r\n0,5;\"0,25\"\r\n\r\n# go\r\n1,5;-0,125\r\n;NaN",
        "time_s,slip\n0,0.1\n1,\"0\n.1\"\n2,0.3\n",
        "time_s\tslip\n1e-3\t1E+2\n-.5\tinf\n",
        "slip,time_s\n0.1\n",
        "\n\n#\n",
        "time_s,slip",
    ];

    #[test]
    fn the_pieces_in_which_a_table_comes_make_no_difference() {
        for text in AWKWARD.iter().map(|text| text.as_bytes()) {
            let whole = all(&[text]);
            for at in 0..=text.len() {
                assert_eq!(all(&[&text[..at], &text[at..]]), whole, "split at {at}");
                assert_eq!(all(&[&text[..at], b"", &text[at..], b""]), whole, "with nothing between at {at}");
            }
            let bytes: Vec<&[u8]> = text.chunks(1).chain([&b""[..]]).collect();
            assert_eq!(all(&bytes), whole, "byte by byte");
        }
        assert_eq!(all(&[AWKWARD[0].as_bytes()]).0.len(), 3);
    }

    /// Numbers that look random and are the same in every run (Marsaglia's xorshift).
    struct Numbers(u64);

    impl Numbers {
        fn below(&mut self, limit: usize) -> usize {
            self.0 ^= self.0 << 13;
            self.0 ^= self.0 >> 7;
            self.0 ^= self.0 << 17;
            (self.0 % limit as u64) as usize
        }
    }

    #[test]
    fn no_text_and_no_pieces_of_it_make_the_reader_panic_or_differ() {
        const PARTS: [&str; 32] = [
            "0,1\n",
            "0,1\n",
            "0,1\n",
            ".5;1,5\r\n",
            ".5;1,5\r\n",
            ".5;1,5\r\n",
            "1\t.5\n",
            "1\t.5\n",
            "1\t.5\n",
            "\"0\"",
            "\n",
            "\n",
            "\r\n",
            "\r",
            ",",
            ",",
            ";",
            "\t",
            "\"",
            "#",
            " ",
            "0",
            "1",
            "-",
            ".5",
            "1e9",
            "nan",
            "s",
            "time_s",
            "slip",
            "\u{feff}",
            "\0",
        ];
        const HEADERS: [&str; 4] = ["time_s,slip\n", "time_s;slip\r\n", "\u{feff}\"slip\"\ttime_s\n", ""];
        let mut numbers = Numbers(0x9e37_79b9_7f4a_7c15);
        let (mut rows, mut faults) = (0, 0);
        for _ in 0..4000 {
            let mut text = HEADERS[numbers.below(HEADERS.len())].to_owned();
            for _ in 0..numbers.below(12) {
                text.push_str(PARTS[numbers.below(PARTS.len())]);
            }
            let whole = all(&[text.as_bytes()]);
            let mut pieces = Vec::new();
            let mut left = text.as_bytes();
            while !left.is_empty() {
                let (piece, rest) = left.split_at(1 + numbers.below(left.len().min(9)));
                pieces.push(piece);
                left = rest;
            }
            pieces.push(b"");
            assert_eq!(all(&pieces), whole, "{text:?}");
            rows += whole.0.len();
            faults += usize::from(whole.1.is_some());
        }
        assert!(rows > 300 && faults > 300, "{rows} rows and {faults} faults are no test");
    }

    #[test]
    fn lines_are_counted_whatever_ends_them() {
        for (text, line, column) in [
            ("time_s,slip\n0,0\n1,x", 3, 2),
            ("time_s,slip\r\n0,0\r\n1,x\r\n", 3, 2),
            ("\n\n# c\ntime_s,slip\n\n0,x\n", 6, 2),
            ("time_s,slip\n0,0,0", 2, 3),
        ] {
            let fault = all(&[text.as_bytes()]).1.expect("a fault");
            assert_eq!((fault.line, fault.column), (line, column), "{text:?}");
        }
    }

    #[test]
    fn a_row_without_end_is_refused_in_bounded_memory() {
        let mut reader = CsvReader::default();
        let endless = [b'1'; 1000];
        let fault = (0..100).find_map(|i| {
            let mut left: &[u8] = if i == 0 { b"time_s,slip\n" } else { &endless };
            reader.next(&mut left, false).err()
        });
        assert_eq!(fault.map(|fault| fault.line), Some(2));
    }
}
