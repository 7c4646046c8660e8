//! A whole series at once, in pieces, for tests and for fuzzing.

use super::{Column, Read, Reader, SeriesFault};

/// All that a reader makes of a series.
#[derive(Debug, PartialEq)]
pub(crate) struct Whole {
    /// The rows by their bits, and whether one had a cell that could not be read.
    pub(crate) rows: Vec<([u64; Column::COUNT], bool)>,
    /// Cells that could not be read, and the first.
    pub(crate) unreadable: (u64, Option<SeriesFault>),
    pub(crate) fault: Option<SeriesFault>,
}

/// The samples that `reader` finds in the pieces of a series; the last piece ends it.
pub(crate) fn all(mut reader: Reader, pieces: &[&[u8]]) -> Whole {
    let mut rows = Vec::new();
    for (i, piece) in pieces.iter().enumerate() {
        let mut left = *piece;
        let fault = loop {
            match reader.next(&mut left, i + 1 == pieces.len()) {
                Ok(Read::Row(row)) => rows.push((row.cells.map(f64::to_bits), row.unreadable)),
                Ok(Read::More) => break None,
                Ok(Read::End) => break Some(None),
                Err(fault) => break Some(Some(fault)),
            }
        };
        if let Some(fault) = fault {
            let unreadable = reader.unreadable();
            return Whole { rows, unreadable: (unreadable.count, unreadable.first.clone()), fault };
        }
        assert!(left.is_empty(), "what is there is used");
    }
    panic!("the last piece ends the series");
}
