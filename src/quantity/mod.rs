//! The quantities of answers: name, unit, symbol and meaning of each, and where its value comes from.
//!
//! One row of [`TABLE`] is all that an answer, its schema, its CSV and NDJSON and the list in `/v1/model` know of a quantity.

mod cell;
mod columns;
mod number;
mod point;
mod point_columns;
mod sample;
mod sample_columns;
mod schema;
mod table;
mod unit;

pub(crate) use cell::{Cell, Digits, csv, line, ndjson_line, write_table};
pub(crate) use columns::{Columns, Shape, Values};
pub(crate) use number::number;
pub(crate) use point::{OfPoint, Part, Point, PointValue};
pub(crate) use point_columns::{PointColumns, every_point_column, point_columns, point_rows};
pub(crate) use sample::{Beside, OfSample, Row, SampleValue};
pub(crate) use sample_columns::{SampleCells, SampleColumns, SampleLists};
pub(crate) use schema::{Field, add_units, object_of, with_fields};
pub(crate) use table::TABLE;
pub(crate) use unit::{of_name as unit_of_name, shown, with_unit};

/// The description of a quantity.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) struct About {
    /// Name on the wire; its suffix is its unit.
    pub(crate) name: &'static str,
    /// Symbol in the equations; empty where it has none.
    pub(crate) symbol: &'static str,
    /// Unit by the Unified Code for Units of Measure: 1 for a ratio, empty for a word.
    pub(crate) unit: &'static str,
    /// What it is, and where it is null.
    pub(crate) meaning: &'static str,
}

/// A quantity that answers have.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Quantity {
    pub(crate) about: About,
    /// How an operating point gives it, where it does.
    pub(crate) point: Option<OfPoint>,
    /// How a sample of a track gives it, where it does.
    pub(crate) sample: Option<OfSample>,
}

impl About {
    pub(crate) const fn new(name: &'static str, symbol: &'static str, unit: &'static str, meaning: &'static str) -> Self {
        Self { name, symbol, unit, meaning }
    }

    /// The quantity in words, for the contract: symbol, unit, meaning.
    pub(crate) fn description(&self) -> String {
        match (self.symbol, self.unit) {
            ("", "") => self.meaning.to_owned(),
            ("", unit) => format!("{} ({}).", self.meaning.trim_end_matches('.'), shown(unit)),
            (symbol, unit) => format!("{symbol} ({}): {}", shown(unit), self.meaning),
        }
    }
}

impl Quantity {
    const fn new(name: &'static str, symbol: &'static str, unit: &'static str, meaning: &'static str) -> Self {
        Self { about: About::new(name, symbol, unit, meaning), point: None, sample: None }
    }

    const fn of_point(self, part: Part, value: PointValue) -> Self {
        Self { point: Some(OfPoint { part, value }), ..self }
    }

    /// The operations whose answers have it.
    pub(crate) fn operations(&self) -> impl Iterator<Item = &'static str> {
        let of_point = self.point.into_iter().flat_map(|of| of.operations());
        of_point.copied().chain(self.sample.map(|_| "/v1/track"))
    }

    const fn of_sample(self, value: SampleValue) -> Self {
        Self { sample: Some(OfSample { value }), ..self }
    }
}
