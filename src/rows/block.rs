//! Rows in columns.

use std::collections::HashMap;

use arrow_array::ArrayRef;
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
    /// Rows before those that were begun at once.
    begun: usize,
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

impl Texts {
    fn place_of(&mut self, text: &str, made: impl FnOnce(&str) -> Node<'static>) -> usize {
        match self.places.get(text) {
            Some(place) => *place,
            None => {
                let place = self.add(made(text));
                self.places.insert(text.to_owned(), place);
                place
            }
        }
    }

    fn add(&mut self, value: Node<'static>) -> usize {
        self.list.push(value);
        self.list.len() - 1
    }
}

impl Block {
    /// Rows of a full block.
    pub(crate) const ROWS: usize = 2048;

    /// Makes room for rows of these columns. Rows that are there already have nothing in them.
    pub(super) fn with(&mut self, columns: &Columns) {
        let rows = self.rows();
        if self.values.len() < columns.fields.len() {
            self.values.resize_with(columns.fields.len(), || vec![f64::NAN; rows]);
        }
        if self.echoes.len() < columns.echoed.len() {
            self.echoes.resize_with(columns.echoed.len(), || Echoed::nothing(rows));
        }
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
        let place = self.texts.place_of(text, made);
        self.placed(field, place);
    }

    /// The row has this value, which is neither a number nor a text.
    pub(super) fn other(&mut self, field: usize, value: Node<'static>) {
        let place = self.texts.add(value);
        self.placed(field, place);
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

    /// How many rows have room.
    pub(super) fn room(&self) -> usize {
        Self::ROWS - self.rows().min(Self::ROWS)
    }

    /// So many rows begin at once, whose columns come one after the other.
    pub(super) fn begin_rows(&mut self, rows: usize) {
        self.begun = self.rows();
        self.shapes.resize(self.begun + rows, Shape::default());
    }

    /// All rows that were begun have these numbers.
    pub(super) fn all_numbers(&mut self, field: usize, values: &[f64]) {
        self.values[field].extend_from_slice(values);
        self.shapes[self.begun..].iter_mut().for_each(|shape| shape.present |= 1 << field);
    }

    /// That of the rows that were begun has this number.
    pub(super) fn number_at(&mut self, row: usize, field: usize, value: f64) {
        self.values[field].resize(self.begun + row, f64::NAN);
        self.values[field].push(value);
        self.shapes[self.begun + row].present |= 1 << field;
    }

    /// It has this text.
    pub(super) fn text_at(&mut self, row: usize, field: usize, text: &str, made: impl FnOnce(&str) -> Node<'static>) {
        let place = self.texts.place_of(text, made);
        self.number_at(row, field, place as f64);
        self.shapes[self.begun + row].textual |= 1 << field;
    }

    /// It has this value, which is neither a number nor a text.
    pub(super) fn other_at(&mut self, row: usize, field: usize, value: Node<'static>) {
        let place = self.texts.add(value);
        self.number_at(row, field, place as f64);
        self.shapes[self.begun + row].textual |= 1 << field;
    }

    /// They have this column, which is repeated as it is.
    pub(super) fn keep(&mut self, column: usize, array: &ArrayRef) {
        self.echoes[column].keep(array);
    }

    /// The rows that were begun end; what they did not have is absent.
    pub(super) fn end_rows(&mut self) {
        let rows = self.rows();
        self.values.iter_mut().for_each(|values| values.resize(rows, f64::NAN));
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
