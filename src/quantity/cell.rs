//! Cells of a table and the lines that they make: the one writer of CSV (RFC 4180) and of lines of JSON.

use std::borrow::Cow;
use std::io::{self, Write};

/// A cell: a number, NaN where there is none, a word, or nothing.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) enum Cell<'a> {
    Number(f64),
    Word(&'a str),
    /// What is written as it stands, such as a number that is repeated.
    Literal(&'a str),
    Nothing,
}

/// Writes a number in the fewest digits that parse to the same number, as the JSON of the service has it.
fn number(value: f64, out: &mut Vec<u8>) {
    out.extend_from_slice(zmij::Buffer::new().format_finite(value).as_bytes());
}

/// A line of a CSV; an empty cell for no number.
pub(crate) fn line<'a>(cells: impl IntoIterator<Item = Cell<'a>>, out: &mut Vec<u8>) {
    for (i, cell) in cells.into_iter().enumerate() {
        if i > 0 {
            out.push(b',');
        }
        match cell {
            Cell::Number(value) if value.is_finite() => number(value, out),
            Cell::Number(_) | Cell::Nothing => {}
            Cell::Word(word) => out.extend_from_slice(quoted(word).as_bytes()),
            Cell::Literal(text) => out.extend_from_slice(text.as_bytes()),
        }
    }
    out.push(b'\n');
}

/// A text as a cell: in quotes where a separator, a quote or a line end would break the table, or the line might pass for a comment.
fn quoted(text: &str) -> Cow<'_, str> {
    if text.contains([',', ';', '\t', '"', '\r', '\n']) || text.starts_with('#') {
        format!("\"{}\"", text.replace('"', "\"\"")).into()
    } else {
        text.into()
    }
}

/// A JSON object in a line, of names that need no escape; null for no number.
pub(crate) fn ndjson_line<'a>(cells: impl IntoIterator<Item = (&'a str, Cell<'a>)>, out: &mut Vec<u8>) {
    let mut before = b'{';
    for (name, cell) in cells {
        out.extend_from_slice(&[before, b'"']);
        out.extend_from_slice(name.as_bytes());
        out.extend_from_slice(b"\":");
        match cell {
            Cell::Number(value) if value.is_finite() => number(value, out),
            Cell::Number(_) | Cell::Nothing => out.extend_from_slice(b"null"),
            Cell::Literal(text) => out.extend_from_slice(text.as_bytes()),
            // Writing to memory cannot fail.
            Cell::Word(word) => drop(serde_json::to_writer(&mut *out, word)),
        }
        before = b',';
    }
    out.extend_from_slice(b"}\n");
}

/// A table: a header with the names of the columns, then a line per row.
///
/// # Errors
/// Those of `out`.
pub(crate) fn write_table(columns: &[(Cow<'static, str>, &[f64])], out: &mut impl Write) -> io::Result<()> {
    let rows = columns.first().map_or(0, |(_, column)| column.len());
    let mut text = Vec::new();
    line(columns.iter().map(|(name, _)| Cell::Word(name)), &mut text);
    out.write_all(&text)?;
    for row in 0..rows {
        text.clear();
        line(columns.iter().map(|(_, column)| Cell::Number(column[row])), &mut text);
        out.write_all(&text)?;
    }
    Ok(())
}

/// The same as a text in memory.
pub(crate) fn csv(columns: &[(Cow<'static, str>, &[f64])]) -> Vec<u8> {
    let mut out = Vec::new();
    // Writing to memory cannot fail.
    let _ = write_table(columns, &mut out);
    out
}

#[cfg(test)]
mod tests {
    use super::*;

    fn text(write: impl FnOnce(&mut Vec<u8>)) -> String {
        let mut out = Vec::new();
        write(&mut out);
        String::from_utf8(out).expect("text")
    }

    #[test]
    fn a_table_has_names_rows_and_empty_cells() {
        let table = |columns: &[(Cow<'static, str>, &[f64])]| String::from_utf8(csv(columns)).expect("text");
        assert_eq!(
            table(&[("slip".into(), &[0.0, 0.1]), ("torque_n_m".into(), &[f64::NAN, 1e-7])]),
            "slip,torque_n_m\n0.0,\n0.1,1e-7\n"
        );
        let odd = table(&[("a, b".into(), &[1.0]), ("5\" wide".into(), &[f64::INFINITY])]);
        assert_eq!(odd, "\"a, b\",\"5\"\" wide\"\n1.0,\n");
    }

    #[test]
    fn a_line_of_json_has_null_for_no_number() {
        let cells = [("slip", Cell::Number(0.5)), ("torque_n_m", Cell::Number(f64::NAN)), ("status", Cell::Word("ok"))];
        assert_eq!(text(|out| ndjson_line(cells, out)), "{\"slip\":0.5,\"torque_n_m\":null,\"status\":\"ok\"}\n");
    }

    #[test]
    fn a_number_is_the_one_that_was_meant_in_the_words_of_json() {
        for value in [1.5e-5, 0.1 + 0.2, 1e16, 123_456_789_012_345_680.0, -5e-324, f64::MAX, 1e-4, 5e-5, -0.0, 1.0] {
            let cell = text(|out| line([Cell::Number(value)], out));
            assert_eq!(cell.trim_end().parse::<f64>().map(f64::to_bits), Ok(value.to_bits()), "{cell}");
            assert_eq!(cell.trim_end(), serde_json::to_string(&value).expect("JSON"));
        }
    }
}
