//! Telemetry as one JSON object a line: `{"time_s": 0.1, "slip": 0.2}`.

use super::{Cells, Column, LONGEST_ROW, Layout, Read, SeriesFault};
use crate::wire::{Field, Number, Object, Scope, read, wire_object};

const ANY: Number = Number::new("", f64::NEG_INFINITY, f64::INFINITY);

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

/// Reads lines piece by piece. The columns of the series are those of its first sample.
#[derive(Debug, Default)]
pub(crate) struct NdjsonReader {
    /// The beginning of a line whose end has not come yet.
    held: Vec<u8>,
    /// Lines that are behind.
    lines: u64,
    layout: Option<Layout>,
}

impl NdjsonReader {
    pub(super) fn layout(&self) -> Option<Layout> {
        self.layout
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
            let cells = if held.is_empty() { self.row(line) } else { self.row(&[&held, line].concat()) }?;
            self.lines += u64::from(end.is_some());
            match cells {
                Some(cells) => return Ok(Read::Row(cells)),
                None if end.is_none() && self.layout.is_none() => return Err(self.fault(0, "the series has no samples")),
                None if end.is_none() => return Ok(Read::End),
                None => {}
            }
        }
    }

    /// The sample of a line; none where it is blank.
    fn row(&mut self, line: &[u8]) -> Result<Option<Cells>, SeriesFault> {
        let line = if self.lines == 0 { line.strip_prefix("\u{feff}".as_bytes()).unwrap_or(line) } else { line };
        if line.trim_ascii().is_empty() {
            return Ok(None);
        }
        let field = read::<SampleDto>(line).map_err(|error| self.fault(error.column(), error.to_string()))?;
        let sample = match &field {
            Field::Given(sample) if sample.oddities().is_empty() => sample,
            Field::Given(sample) => return Err(self.fault(0, oddity(sample))),
            Field::Wrong(found) => return Err(self.fault(0, format!("must be an object, not {found}"))),
            Field::Absent => return Ok(None),
        };
        let entries = [
            sample.time_s(),
            sample.slip(),
            sample.forward_velocity_m_s(),
            sample.angular_velocity_rad_s(),
            sample.sinkage_m(),
            sample.torque_n_m(),
            sample.normal_load_n(),
        ];
        let mut cells = [f64::NAN; Column::COUNT];
        let mut given = Layout::default();
        for (index, entry) in entries.iter().enumerate() {
            match entry.field {
                Field::Absent => continue,
                Field::Given(value) => cells[index] = *value,
                Field::Wrong(found) if found == "null" => {}
                Field::Wrong(found) => {
                    return Err(self.fault(0, format!("`{}` must be a number or null, not {found}", entry.name)));
                }
            }
            given.add(index);
            if self.layout.is_some_and(|layout| !layout.0[index]) {
                return Err(self.fault(0, format!("the first sample has no `{}`, so none may have it", entry.name)));
            }
        }
        self.layout.get_or_insert(given);
        Ok(Some(cells))
    }

    fn fault(&self, column: usize, detail: impl Into<String>) -> SeriesFault {
        SeriesFault { line: self.lines + 1, column, detail: detail.into() }
    }
}

/// The first name that does not belong, in words.
fn oddity(sample: &SampleDto) -> String {
    let faults = std::cell::RefCell::default();
    sample.report_oddities(&Scope::root(&faults));
    faults
        .into_inner()
        .first()
        .map_or_else(String::new, |fault| format!("{} {}", fault.pointer.trim_start_matches('/'), fault.detail))
}

#[cfg(test)]
mod tests {
    use super::*;

    fn all(pieces: &[&[u8]]) -> (Vec<[u64; Column::COUNT]>, Option<SeriesFault>) {
        let mut reader = NdjsonReader::default();
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

    #[test]
    fn the_pieces_in_which_lines_come_make_no_difference() {
        for text in [
            "\u{feff}{\"time_s\":0,\"slip\":0.1}\r\n\r\n{\"slip\":null,\"time_s\":1e0}\n{\"time_s\":2}",
            "{\"time_s\":0}\n{\"time_s\":1}\n",
            "{\"time_s\":0}\n{\"time_s\":1,}\n{\"time_s\":2}",
            "\n \n",
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
        let mut reader = NdjsonReader::default();
        let fault = (0..100).find_map(|_| reader.next(&mut &[b' '; 1000][..], false).err());
        assert_eq!(fault.map(|fault| fault.line), Some(1));
    }
}
