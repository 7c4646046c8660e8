//! Columns of a body that its answer repeats.

use arrow_array::ArrayRef;

/// A cell that is repeated.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) enum EchoedCell<'a> {
    /// There is nothing in it.
    Nothing,
    /// What JSON writes without quotes, such as a number.
    Literal(&'a str),
    /// A text.
    Text(&'a str),
}

#[derive(Debug, Clone, Copy, PartialEq, Eq)]
enum Kind {
    Nothing,
    Literal,
    Text,
}

/// A column that is repeated.
#[derive(Debug, Default)]
pub(crate) struct Echoed {
    text: String,
    /// Of each cell where its text ends, and what it is.
    cells: Vec<(usize, Kind)>,
    /// In place of cells, the parts of the column as they came.
    arrays: Vec<ArrayRef>,
}

impl Echoed {
    /// A column with nothing in its first rows.
    pub(super) fn nothing(rows: usize) -> Self {
        Self { cells: vec![(0, Kind::Nothing); rows], ..Self::default() }
    }

    pub(super) fn clear(&mut self) {
        self.text.clear();
        self.cells.clear();
        self.arrays.clear();
    }

    pub(super) fn keep(&mut self, array: &ArrayRef) {
        self.arrays.push(array.clone());
    }

    /// The parts of a column that is repeated as it came.
    pub(crate) fn arrays(&self) -> &[ArrayRef] {
        &self.arrays
    }

    pub(super) fn len(&self) -> usize {
        self.cells.len()
    }

    pub(super) fn push(&mut self, cell: EchoedCell<'_>) {
        let (text, kind) = match cell {
            EchoedCell::Nothing => ("", Kind::Nothing),
            EchoedCell::Literal(text) => (text, Kind::Literal),
            EchoedCell::Text(text) => (text, Kind::Text),
        };
        self.text.push_str(text);
        self.cells.push((self.text.len(), kind));
    }

    /// The cell of a row.
    pub(crate) fn cell(&self, row: usize) -> EchoedCell<'_> {
        let Some(&(end, kind)) = self.cells.get(row) else { return EchoedCell::Nothing };
        let start = if row == 0 { 0 } else { self.cells[row - 1].0 };
        let text = &self.text[start..end];
        match kind {
            Kind::Nothing => EchoedCell::Nothing,
            Kind::Literal => EchoedCell::Literal(text),
            Kind::Text => EchoedCell::Text(text),
        }
    }
}
