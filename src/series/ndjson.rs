//! Telemetry as one JSON object a line: `{"time_s": 0.1, "slip": 0.2}`.

use super::{Column, ExtraColumns, LONGEST_ROW, Layout, Read, Row, SeriesFault, Unreadable};
use crate::wire::{Entry, Field, Number, Object, Scope, read, wire_object};

const ANY: Number = Number::new("", f64::NEG_INFINITY, f64::INFINITY);

/// How a sample is written, for those who wrote something else.
const HOW: &str = "write one object a line, such as {\"time_s\": 0.1, \"slip\": 0.2}, with null for a missing value";

wire_object! {
    /// One sample.
    SampleDto as "Sample" {
        time_s: f64 = ANY,
        slip: f64 = ANY,
        forward_velocity_m_s: f64 = ANY,
        angular_velocity_rad_s: f64 = ANY,
        sinkage_m: f64 = ANY,
        torque_n_m: f64 = ANY,
        normal_load_n: f64 = ANY,
    }
}

impl SampleDto {
    /// In the order of [`Column::NAMES`].
    fn entries(&self) -> [Entry<'_, f64>; Column::COUNT] {
        [
            self.time_s(),
            self.slip(),
            self.forward_velocity_m_s(),
            self.angular_velocity_rad_s(),
            self.sinkage_m(),
            self.torque_n_m(),
            self.normal_load_n(),
        ]
    }

    /// All names that do not belong, in words.
    fn oddities_in_words(&self, extra: ExtraColumns) -> Option<String> {
        let faults = std::cell::RefCell::default();
        extra.report(self, &Scope::root(&faults));
        let faults = faults.into_inner().into_iter();
        let described: Vec<_> =
            faults.map(|fault| format!("`{}`: {}", fault.pointer.trim_start_matches('/'), fault.detail)).collect();
        (!described.is_empty()).then(|| described.join("; "))
    }
}

/// Reads lines piece by piece. The columns of the series are those of its first sample.
#[derive(Debug)]
pub(crate) struct NdjsonReader {
    extra: ExtraColumns,
    /// The beginning of a line whose end has not come yet.
    held: Vec<u8>,
    /// Lines that are behind.
    lines: u64,
    layout: Option<Layout>,
    unreadable: Unreadable,
}

impl NdjsonReader {
    pub(super) fn new(extra: ExtraColumns) -> Self {
        Self { extra, held: Vec::new(), lines: 0, layout: None, unreadable: Unreadable::default() }
    }

    pub(super) fn layout(&self) -> Option<Layout> {
        self.layout
    }

    pub(super) fn unreadable(&self) -> &Unreadable {
        &self.unreadable
    }

    pub(super) fn next(&mut self, input: &mut &[u8], last: bool) -> Result<Read, SeriesFault> {
        loop {
            let end = input.iter().position(|byte| *byte == b'\n');
            let (line, rest) = input.split_at(end.unwrap_or(input.len()));
            if self.held.len() + line.len() > LONGEST_ROW {
                return Err(self.fault(0, format!("a line may have at most {LONGEST_ROW} bytes")));
            }
            *input = rest.split_first().map_or(rest, |(_, rest)| rest);
            if end.is_none() && !last {
                self.held.extend_from_slice(line);
                return Ok(Read::More);
            }
            let held = std::mem::take(&mut self.held);
            let row = if held.is_empty() { self.row(line) } else { self.row(&[&held, line].concat()) }?;
            self.lines += u64::from(end.is_some());
            match row {
                Some(row) => return Ok(Read::Row(row)),
                None if end.is_none() && self.layout.is_none() => return Err(self.fault(0, "the series has no samples")),
                None if end.is_none() => return Ok(Read::End),
                None => {}
            }
        }
    }

    /// The sample of a line; none where it is blank.
    fn row(&mut self, line: &[u8]) -> Result<Option<Row>, SeriesFault> {
        let line = if self.lines == 0 { line.strip_prefix("\u{feff}".as_bytes()).unwrap_or(line) } else { line };
        if line.trim_ascii().is_empty() {
            return Ok(None);
        }
        let sample = match self.parsed(line)? {
            Field::Given(sample) => sample,
            Field::Wrong(found) => return Err(self.fault(0, format!("must be an object, not {found}; {HOW}"))),
            Field::Absent => return Ok(None),
        };
        if !sample.oddities().is_empty()
            && let Some(oddities) = sample.oddities_in_words(self.extra)
        {
            return Err(self.fault(0, oddities));
        }
        let mut row = Row { cells: [f64::NAN; Column::COUNT], unreadable: false };
        let mut given = Layout::default();
        for (index, entry) in sample.entries().iter().enumerate() {
            match entry.field {
                Field::Absent => continue,
                Field::Given(value) => row.cells[index] = *value,
                Field::Wrong(found) if found == "null" => {}
                Field::Wrong(found) => {
                    let fault = || self.fault(0, format!("`{}` must be a number or null, not {found}", entry.name));
                    if self.layout.is_none() {
                        return Err(fault()); // the form is wrong rather than the value, and nothing is lost yet
                    }
                    let first = self.unreadable.first.is_none().then(fault);
                    self.unreadable.count(first);
                    row.unreadable = true;
                }
            }
            given.add(index);
            if self.layout.is_some_and(|layout| !layout.0[index]) {
                return Err(self.fault(0, format!("the first sample has no `{}`, so none may have it", entry.name)));
            }
        }
        self.layout.get_or_insert(given);
        Ok(Some(row))
    }

    fn parsed(&self, line: &[u8]) -> Result<Field<SampleDto>, SeriesFault> {
        if let Ok(sample) = read(line) {
            return Ok(sample);
        }
        let (text, longer_at) = without_words(line);
        let error = match read(&text) {
            Ok(sample) => return Ok(sample),
            Err(error) => error,
        };
        let column = error.column() - longer_at.iter().filter(|at| **at < error.column()).count();
        let said = error.to_string();
        let said = said.split(" at line ").next().unwrap_or_default();
        Err(self.fault(column, format!("the line is not JSON, {said}; {HOW}")))
    }

    fn fault(&self, column: usize, detail: impl Into<String>) -> SeriesFault {
        SeriesFault { line: self.lines + 1, column, detail: detail.into() }
    }
}

/// The line with null for each of the words that Python and JavaScript write for a number that is none, and where that made it a
/// byte longer.
fn without_words(line: &[u8]) -> (Vec<u8>, Vec<usize>) {
    const WORDS: [(&[u8], &[u8]); 3] = [(b"NaN", b"null"), (b"-Infinity", b"null     "), (b"Infinity", b"null    ")];
    let (mut text, mut longer_at) = (Vec::with_capacity(line.len()), Vec::new());
    let mut left = line;
    let mut quoted = false;
    while let Some((&byte, rest)) = left.split_first() {
        match WORDS.iter().find(|(word, _)| !quoted && left.starts_with(word)) {
            Some((word, null)) => {
                text.extend_from_slice(null);
                if null.len() > word.len() {
                    longer_at.push(text.len() - 1);
                }
                left = &left[word.len()..];
            }
            None => {
                let escape = quoted && byte == b'\\' && !rest.is_empty();
                quoted ^= byte == b'"';
                let (taken, rest) = left.split_at(if escape { 2 } else { 1 });
                text.extend_from_slice(taken);
                left = rest;
            }
        }
    }
    (text, longer_at)
}

#[cfg(test)]
mod tests {
    use super::super::Reader;
    use super::super::pieces::{self, Whole};
    use super::*;

    fn all(pieces: &[&[u8]]) -> Whole {
        pieces::all(Reader::ndjson(ExtraColumns::Refuse), pieces)
    }

    #[test]
    fn the_values_of_a_sample_are_in_the_order_of_the_columns() {
        assert_eq!(SampleDto::default().entries().map(|entry| entry.name), Column::NAMES);
    }

    #[test]
    fn words_that_are_no_numbers_are_null_outside_of_strings() {
        let text = |line: &[u8]| String::from_utf8(without_words(line).0).expect("text");
        assert_eq!(text(b"[NaN,-Infinity,Infinity]"), "[null,null     ,null    ]");
        for line in ["{\"NaN\":\"a\\\"NaN\"}", "\"\\\\\"", "\"\\", "\"", ""] {
            assert_eq!(text(line.as_bytes()), line);
        }
    }

    #[test]
    fn the_pieces_in_which_lines_come_make_no_difference() {
        for text in [
            "\u{feff}{\"time_s\":0,\"slip\":0.1}\r\n\r\n{\"slip\":null,\"time_s\":1e0}\n{\"time_s\":2}",
            "{\"time_s\":0}\n{\"time_s\":1}\n",
            "{\"time_s\":0}\n{\"time_s\":1,}\n{\"time_s\":2}",
            "\n \n",
            "{\"time_s\":0,\"slip\":NaN}\n{\"time_s\":1,\"slip\":\"x\"}\n{\"time_s\":NaN,\"slip\":-Infinity,}",
        ] {
            let text = text.as_bytes();
            let whole = all(&[text]);
            for at in 0..=text.len() {
                assert_eq!(all(&[&text[..at], &text[at..]]), whole, "split at {at}");
                assert_eq!(all(&[&text[..at], b"", &text[at..], b""]), whole, "with nothing between at {at}");
            }
        }
    }

    #[test]
    fn a_line_without_end_is_refused_in_bounded_memory() {
        let mut reader = NdjsonReader::new(ExtraColumns::Refuse);
        let fault = (0..100).find_map(|_| reader.next(&mut &[b' '; 1000][..], false).err());
        assert_eq!(fault.map(|fault| fault.line), Some(1));
    }
}
