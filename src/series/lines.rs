//! The lines of a text, wherever the pieces of input end.

use std::borrow::Cow;

use super::{LONGEST_ROW, SeriesFault};

/// Reads lines piece by piece.
#[derive(Debug, Default)]
pub(crate) struct Lines {
    /// The beginning of a line whose end has not come yet.
    held: Vec<u8>,
    /// Lines that are behind.
    behind: u64,
    /// Whether the line that was read last has an end, so that another one follows.
    ended: bool,
}

/// What is found next.
#[derive(Debug)]
pub(crate) enum Line<'a> {
    /// A line without its end.
    Text(Cow<'a, [u8]>),
    /// The input is used up.
    More,
    End,
}

impl Lines {
    /// The next line that is not blank; takes what it uses off `input`. With `last` nothing comes after `input`.
    ///
    /// # Errors
    /// That a line is too long.
    pub(crate) fn next<'a>(&mut self, input: &mut &'a [u8], last: bool) -> Result<Line<'a>, SeriesFault> {
        loop {
            self.behind += u64::from(std::mem::take(&mut self.ended));
            if input.is_empty() {
                if !last {
                    return Ok(Line::More);
                } else if self.held.is_empty() {
                    return Ok(Line::End);
                }
            }
            let end = input.iter().position(|byte| *byte == b'\n');
            let (line, rest) = input.split_at(end.unwrap_or(input.len()));
            if self.held.len() + line.len() > LONGEST_ROW {
                return Err(self.fault(0, format!("a line may have at most {LONGEST_ROW} bytes")));
            }
            *input = rest.split_first().map_or(rest, |(_, rest)| rest);
            if end.is_none() && !last {
                self.held.extend_from_slice(line);
                return Ok(Line::More);
            }
            self.ended = end.is_some();
            let held = std::mem::take(&mut self.held);
            let mut line = if held.is_empty() { Cow::Borrowed(line) } else { Cow::Owned([&held, line].concat()) };
            if self.behind == 0 && line.starts_with(BYTE_ORDER_MARK) {
                line = Cow::Owned(line[BYTE_ORDER_MARK.len()..].to_vec());
            }
            if !line.trim_ascii().is_empty() {
                return Ok(Line::Text(line));
            }
        }
    }

    /// A fault of the line that was read last.
    pub(crate) fn fault(&self, column: usize, detail: impl Into<String>) -> SeriesFault {
        SeriesFault { line: self.behind + 1, column, detail: detail.into() }
    }
}

const BYTE_ORDER_MARK: &[u8] = "\u{feff}".as_bytes();
