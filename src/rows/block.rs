//! Rows in columns.

use std::collections::HashMap;

use terramechanics_reading::Node;

use super::columns::Columns;
use super::echo::{Echoed, EchoedCell};

/// Which fields a row has, by bits: the first stands for the first field.
#[derive(Debug, Clone, Copy, Default, PartialEq, Eq, Hash)]
pub(crate) struct Shape {
    /// The fields that are there.
    pub(crate) present: u64,
    /// Those of them that are no numbers.
    pub(crate) textual: u64,
}

/// Rows in columns, with room that is used again.
#[derive(Debug, Default)]
pub(crate) struct Block {
    /// Rows before it.
    pub(crate) first: u64,
    /// By field, then by row: the number, or the place among the texts.
    values: Vec<Vec<f64>>,
    shapes: Vec<Shape>,
    row: Shape,
    texts: Texts,
    /// Rows that cannot be read, ascending, and why.
    faults: Vec<(usize, String)>,
    echoes: Vec<Echoed>,
}

/// Values that are no numbers, each once.
#[derive(Debug, Default)]
struct Texts {
    list: Vec<Node<'static>>,
    places: HashMap<String, usize>,
}

impl Block {
    /// Rows of a full block.
    pub(crate) const ROWS: usize = 2048;

    /// Makes room for rows of these columns.
    pub(super) fn with(&mut self, columns: &Columns) {
        self.values.resize_with(columns.fields.len(), Vec::new);
        self.echoes.resize_with(columns.echoed.len(), Echoed::default);
    }

    /// Without rows; `first` come before those that it will have.
    pub(crate) fn clear(&mut self, first: u64) {
        self.first = first;
        self.values.iter_mut().for_each(Vec::clear);
        self.echoes.iter_mut().for_each(Echoed::clear);
        self.shapes.clear();
        self.faults.clear();
        self.texts.list.clear();
        self.texts.places.clear();
    }

    pub(crate) fn rows(&self) -> usize {
        self.shapes.len()
    }

    pub(super) fn is_full(&self) -> bool {
        self.rows() >= Self::ROWS
    }

    /// The row has this number.
    #[inline]
    pub(super) fn number(&mut self, field: usize, value: f64) {
        self.row.present |= 1 << field;
        self.values[field].push(value);
    }

    /// The row has this text, which is kept as `made` makes it.
    pub(super) fn text(&mut self, field: usize, text: &str, made: impl FnOnce(&str) -> Node<'static>) {
        let place = match self.texts.places.get(text) {
            Some(place) => *place,
            None => {
                self.texts.list.push(made(text));
                self.texts.places.insert(text.to_owned(), self.texts.list.len() - 1);
                self.texts.list.len() - 1
            }
        };
        self.placed(field, place);
    }

    /// The row has this value, which is neither a number nor a text.
    pub(super) fn other(&mut self, field: usize, value: Node<'static>) {
        self.texts.list.push(value);
        self.placed(field, self.texts.list.len() - 1);
    }

    fn placed(&mut self, field: usize, place: usize) {
        self.row.present |= 1 << field;
        self.row.textual |= 1 << field;
        self.values[field].push(place as f64);
    }

    /// The row has this in a column that is repeated.
    pub(super) fn echo(&mut self, column: usize, cell: EchoedCell<'_>) {
        self.echoes[column].push(cell);
    }

    /// The row ends; what it did not have is absent.
    pub(super) fn end_row(&mut self) {
        let rows = self.shapes.len() + 1;
        self.values.iter_mut().filter(|values| values.len() < rows).for_each(|values| values.push(f64::NAN));
        self.echoes.iter_mut().filter(|echo| echo.len() < rows).for_each(|echo| echo.push(EchoedCell::Nothing));
        self.shapes.push(std::mem::take(&mut self.row));
    }

    /// The row that comes next cannot be read.
    pub(super) fn faulty_row(&mut self, detail: String) {
        self.faults.push((self.rows(), detail));
        self.end_row();
    }

    /// The shape of a row.
    #[inline]
    pub(crate) fn shape(&self, row: usize) -> Shape {
        self.shapes[row]
    }

    /// Why a row cannot be read, if it cannot.
    pub(crate) fn fault(&self, row: usize) -> Option<&str> {
        let at = self.faults.binary_search_by_key(&row, |(row, _)| *row).ok()?;
        Some(&self.faults[at].1)
    }

    /// The number of a row in a field, or the place of its text.
    #[inline]
    pub(crate) fn value(&self, field: usize, row: usize) -> f64 {
        self.values[field][row]
    }

    /// What a row has in a field, as it was sent.
    pub(crate) fn node(&self, field: usize, row: usize) -> Node<'static> {
        let (value, shape) = (self.value(field, row), self.shape(row));
        if shape.present >> field & 1 == 0 {
            Node::Null
        } else if shape.textual >> field & 1 == 0 {
            Node::Number(value)
        } else {
            self.texts.list.get(value as usize).cloned().unwrap_or(Node::Null)
        }
    }

    /// The columns that are repeated.
    pub(crate) fn echoes(&self) -> &[Echoed] {
        &self.echoes
    }
}
