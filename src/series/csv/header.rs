//! The header of a table, the row of units below it, and the numbers under it.

use super::super::{Column, ExtraColumns, LEAVING_OUT, Layout};
use crate::words::nearest;

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

pub(super) const BYTE_ORDER_MARK: &[u8] = "\u{feff}".as_bytes();

/// The columns of a table as its header names them.
#[derive(Debug, Default)]
pub(super) struct Header {
    /// The column of each cell; none for one that is left out.
    pub(super) order: Vec<Option<usize>>,
    pub(super) layout: Layout,
}

/// What is wrong with a header, or with the row of units below it: the cell, from 1, and why.
pub(super) type CellFault = (usize, String);

impl Header {
    /// The header with these names.
    pub(super) fn read(names: &[String], extra: ExtraColumns) -> Result<Self, CellFault> {
        let mut header = Self::default();
        let mut unknown = Vec::new();
        for (at, name) in names.iter().enumerate() {
            let index = Column::NAMES.iter().position(|known| known == name);
            match index {
                Some(index) if header.order.contains(&Some(index)) => {
                    return Err((at + 1, format!("the column `{name}` is there more than once")));
                }
                Some(index) => header.layout.add(index),
                None if extra == ExtraColumns::Refuse => unknown.push(at),
                None => {}
            }
            header.order.push(index);
        }
        match unknown.as_slice() {
            [] => Ok(header),
            &[first, ..] => Err((first + 1, unknown_columns(names, &unknown))),
        }
    }

    /// That the words are the units of the columns.
    pub(super) fn check_units(&self, words: &[String]) -> Result<(), CellFault> {
        for (at, (index, word)) in self.order.iter().zip(words).enumerate() {
            let Some(index) = *index else { continue };
            let unit = word.trim_matches(['[', ']', '(', ')', ' ']);
            if !UNITS[index].contains(&unit) {
                let name = Column::NAMES[index];
                return Err((at + 1, format!("`{word}` is no number, and not the unit of `{name}`, {}", UNITS[index][0])));
            }
        }
        Ok(())
    }
}

/// All names that no column has, each with the one that was probably meant.
fn unknown_columns(names: &[String], unknown: &[usize]) -> String {
    let described = unknown.iter().map(|&at| match nearest(&names[at], &Column::NAMES) {
        Some(near) => format!("`{}`, did you mean `{near}`?", names[at]),
        None => format!("`{}`", names[at]),
    });
    let described = described.collect::<Vec<_>>().join("; ");
    let some = if unknown.len() == 1 { "unknown column" } else { "unknown columns" };
    format!("{some} {described}; known are {}; {LEAVING_OUT}", Column::NAMES.join(", "))
}

/// The first line that is neither blank nor a comment.
pub(super) fn first_line(text: &[u8]) -> Option<&[u8]> {
    let text = text.strip_prefix(BYTE_ORDER_MARK).unwrap_or(text);
    text.split(|byte| matches!(byte, b'\n' | b'\r')).find(|line| !line.trim_ascii().is_empty() && !line.starts_with(b"#"))
}

/// The separator of a header: a semicolon or a tab where there is one outside of quotes, else a comma.
pub(super) fn separator(header: &[u8]) -> u8 {
    let is_there = |separator: &u8| header.split(|byte| *byte == b'"').step_by(2).any(|outside| outside.contains(separator));
    [b';', b'\t'].into_iter().find(is_there).unwrap_or(b',')
}

/// The number in a cell: NaN for an empty one and for the words that stand for a missing value, none for any other text.
pub(crate) fn number(cell: &[u8]) -> Option<f64> {
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
