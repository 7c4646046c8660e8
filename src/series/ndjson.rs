//! Telemetry as one JSON object a line: `{"time_s": 0.1, "slip": 0.2}`.

use terramechanics_reading::{Fields, Node, Unread, json, shortened};

use super::{Column, ExtraColumns, Layout, Line, Lines, Read, Row, SeriesFault, Unreadable};
use crate::words::HINTS;

/// How a sample is written, for those who wrote something else.
const HOW: &str = "write one object a line, such as {\"time_s\": 0.1, \"slip\": 0.2}, with null for a missing value";

/// Most unknown names that are reported for one line.
const MOST_ODDITIES: usize = 20;

/// The column of each field, or all names that do not belong in words.
fn columns(fields: &Fields<'_>, extra: ExtraColumns) -> Result<[Option<usize>; Column::COUNT], String> {
    let mut found = [None; Column::COUNT];
    let mut oddities = Vec::new();
    for (at, (name, _)) in fields.iter().enumerate() {
        match Column::NAMES.iter().position(|known| *known == name) {
            Some(index) if found[index].is_none() => found[index] = Some(at),
            Some(_) => oddities.push(format!("`{name}`: is given more than once")),
            None if extra == ExtraColumns::Ignore => {}
            None => {
                let hint = HINTS.unknown_field(name, &Column::NAMES, &[]);
                oddities.push(format!("`{}`: unknown field; {hint}", shortened(name)));
            }
        }
        if oddities.len() == MOST_ODDITIES {
            break;
        }
    }
    if oddities.is_empty() { Ok(found) } else { Err(oddities.join("; ")) }
}

/// Reads lines piece by piece. The columns of the series are those of its first sample.
#[derive(Debug)]
pub(crate) struct NdjsonReader {
    extra: ExtraColumns,
    lines: Lines,
    layout: Option<Layout>,
    unreadable: Unreadable,
}

impl NdjsonReader {
    pub(super) fn new(extra: ExtraColumns) -> Self {
        Self { extra, lines: Lines::default(), layout: None, unreadable: Unreadable::default() }
    }

    pub(super) fn layout(&self) -> Option<Layout> {
        self.layout
    }

    pub(super) fn unreadable(&self) -> &Unreadable {
        &self.unreadable
    }

    pub(super) fn next(&mut self, input: &mut &[u8], last: bool) -> Result<Read, SeriesFault> {
        match self.lines.next(input, last)? {
            Line::Text(line) => self.row(&line).map(Read::Row),
            Line::More => Ok(Read::More),
            Line::End if self.layout.is_none() => Err(self.fault(0, "the series has no samples")),
            Line::End => Ok(Read::End),
        }
    }

    /// The sample of a line.
    fn row(&mut self, line: &[u8]) -> Result<Row, SeriesFault> {
        let text; // what the words that are no numbers were replaced in
        let sample = match json(line) {
            Ok(sample) => sample,
            Err(_) => {
                text = without_words(line);
                self.parsed(&text)?
            }
        };
        let Node::Object(fields) = &sample else {
            return Err(self.fault(0, format!("must be an object, not {}; {HOW}", sample.in_words())));
        };
        let mut row = Row { cells: [f64::NAN; Column::COUNT], unreadable: false };
        let mut given = Layout::default();
        let columns = columns(fields, self.extra).map_err(|oddities| self.fault(0, oddities))?;
        for (index, at) in columns.into_iter().enumerate() {
            match at.and_then(|at| fields.get(at)) {
                None => continue,
                Some(Node::Number(value)) => row.cells[index] = *value,
                Some(Node::Null) => {}
                Some(other) => {
                    let name = Column::NAMES[index];
                    let fault = || self.fault(0, format!("`{name}` must be a number or null, not {}", other.in_words()));
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
                let name = Column::NAMES[index];
                return Err(self.fault(0, format!("the first sample has no `{name}`, so none may have it")));
            }
        }
        self.layout.get_or_insert(given);
        Ok(row)
    }

    fn parsed<'t>(&self, (text, longer_at): &'t (Vec<u8>, Vec<usize>)) -> Result<Node<'t>, SeriesFault> {
        let error = match json(text) {
            Ok(sample) => return Ok(sample),
            Err(Unread::TooMuch) => return Err(self.fault(0, Unread::TooMuch.to_string())),
            Err(Unread::NotJson(error)) => error,
        };
        let column = error.column() - longer_at.iter().filter(|at| **at < error.column()).count();
        let said = error.to_string();
        let said = said.split(" at line ").next().unwrap_or_default();
        Err(self.fault(column, format!("the line is not JSON, {said}; {HOW}")))
    }

    fn fault(&self, column: usize, detail: impl Into<String>) -> SeriesFault {
        self.lines.fault(column, detail)
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
