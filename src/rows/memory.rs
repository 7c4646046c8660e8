//! Rows that are columns in memory already.

use std::ops::Range;

use terramechanics_reading::{FieldFault, Node};

use super::columns::CellKind;
use super::{Block, Columns, Wanted};

/// The cells of a column.
#[derive(Debug, Clone, Copy)]
pub enum Cells<'a> {
    /// A number in every row.
    Numbers(&'a [f64]),
    /// A number in every row whose flag is not 0.
    SomeNumbers(&'a [f64], &'a [u8]),
    /// The place of a text among `texts`; none where the place is not among them, such as -1.
    Texts {
        /// By row.
        places: &'a [i32],
        /// Each text once.
        texts: &'a [String],
    },
    /// True or false; none where it is neither 1 nor 0.
    Flags(&'a [u8]),
}

impl Cells<'_> {
    /// Number of rows; none where two lists of one column differ.
    #[must_use]
    pub fn rows(&self) -> Option<usize> {
        match self {
            Self::Numbers(values) => Some(values.len()),
            Self::SomeNumbers(values, there) => (values.len() == there.len()).then_some(values.len()),
            Self::Texts { places, .. } => Some(places.len()),
            Self::Flags(flags) => Some(flags.len()),
        }
    }
}

/// What is wrong with the kinds of the cells.
pub(crate) fn unfit(columns: &Columns, cells: &[Cells<'_>]) -> Vec<FieldFault> {
    let of_fields = cells.iter().zip(&columns.field_of).filter_map(|(cells, field)| Some((cells, (*field)?)));
    let taken = of_fields.map(|(cells, field)| match cells {
        Cells::Numbers(_) | Cells::SomeNumbers(..) => columns.takes(field, CellKind::Numbers, "numbers"),
        Cells::Texts { texts: [], .. } => columns.takes(field, CellKind::Nothing, "nothing"),
        Cells::Texts { .. } => columns.takes(field, CellKind::Texts, "texts"),
        Cells::Flags(_) => columns.takes(field, CellKind::Flags, "booleans"),
    });
    taken.filter_map(Result::err).collect()
}

/// The columns of these names.
///
/// # Errors
/// All that is wrong with them.
pub(crate) fn columns_of(wanted: &Wanted, names: &[String]) -> Result<Columns, Vec<FieldFault>> {
    wanted.columns(names)
}

/// Adds `rows` of the cells to a block. Each column of `columns` has its cells there, and they have these rows.
pub(crate) fn fill(columns: &Columns, cells: &[Cells<'_>], rows: Range<usize>, block: &mut Block) {
    block.with(columns);
    block.begin_rows(rows.len());
    for (cells, field) in cells.iter().zip(&columns.field_of).filter_map(|(cells, field)| Some((cells, (*field)?))) {
        match *cells {
            Cells::Numbers(values) => block.all_numbers(field, &values[rows.clone()]),
            Cells::SomeNumbers(values, there) => {
                for (row, at) in rows.clone().enumerate().filter(|(_, at)| there[*at] != 0) {
                    block.number_at(row, field, values[at]);
                }
            }
            Cells::Texts { places, texts } => {
                for (row, at) in rows.clone().enumerate() {
                    if let Some(text) = usize::try_from(places[at]).ok().and_then(|place| texts.get(place)) {
                        block.text_at(row, field, text, |text| Node::Text(text.to_owned().into()));
                    }
                }
            }
            Cells::Flags(flags) => {
                for (row, at) in rows.clone().enumerate().filter(|(_, at)| flags[*at] <= 1) {
                    block.other_at(row, field, Node::Flag(flags[at] == 1));
                }
            }
        }
    }
    block.end_rows();
}
