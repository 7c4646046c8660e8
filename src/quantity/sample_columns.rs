//! The quantities of samples as rows and as columns.

use super::cell::{Cell, Digits, line, ndjson_line};
use super::columns::{Columns, Shape, Values};
use super::sample::{Beside, Row, SampleValue};
use super::schema::Field;
use super::{About, TABLE};

/// The rows of the table that a sample has.
fn sample_rows() -> impl Iterator<Item = (&'static About, SampleValue)> {
    TABLE.iter().filter_map(|quantity| Some((&quantity.about, quantity.sample?.value)))
}

/// The columns of a run.
#[derive(Debug, Clone, Default)]
pub(crate) struct SampleCells(Vec<(&'static About, SampleValue)>);

impl SampleCells {
    pub(crate) fn with(beside: Beside) -> Self {
        Self(sample_rows().filter(|(_, value)| value.is_there(beside)).collect())
    }

    /// The header of a CSV.
    pub(crate) fn header(&self, out: &mut Vec<u8>) {
        line(self.0.iter().map(|(about, _)| Cell::Word(about.name)), Digits::Json, out);
    }

    /// A line of a CSV.
    pub(crate) fn csv(&self, row: &Row<'_>, out: &mut Vec<u8>) {
        line(self.0.iter().map(|(_, value)| value.cell(row)), Digits::Json, out);
    }

    /// A line of JSON.
    pub(crate) fn ndjson(&self, row: &Row<'_>, out: &mut Vec<u8>) {
        ndjson_line(self.0.iter().map(|(about, value)| (about.name, value.cell(row))), out);
    }
}

/// Columns of samples.
#[derive(Debug, Clone)]
pub(crate) struct OfSamples;

pub(crate) type SampleColumns = Columns<OfSamples>;

impl Shape for OfSamples {
    const NAME: &'static str = "TrackedColumns";
    const DOC: &'static str = "Columns of one length. The row of a sample without a result is null, except for its time and, where only the \
                               forces have no solution, its slip; `status` has the reason.";

    fn fields() -> Vec<Field> {
        let field = |(about, value): (&'static About, SampleValue)| Field {
            about,
            nullable: !matches!(value, SampleValue::Word(_)),
            present: match value {
                SampleValue::Number(_) | SampleValue::Word(_) => None,
                SampleValue::WithTorque(_) => Some("where a torque was measured"),
                SampleValue::OfLoad(_) => Some("where the load is known beside the sinkage"),
                SampleValue::Running(_) => Some("where `strength` was asked for"),
            },
        };
        sample_rows().map(field).collect()
    }
}

/// Columns of samples in the making.
#[derive(Debug, Default)]
pub(crate) struct SampleLists {
    cells: SampleCells,
    lists: Vec<Values>,
}

impl SampleLists {
    /// Without rows, with room for `rows`.
    pub(crate) fn with(beside: Beside, rows: usize) -> Self {
        let cells = SampleCells::with(beside);
        let list = |(_, value): &(_, SampleValue)| match value {
            SampleValue::Word(_) => Values::Words(Vec::with_capacity(rows)),
            _ => Values::Numbers(Vec::with_capacity(rows)),
        };
        let lists = cells.0.iter().map(list).collect();
        Self { cells, lists }
    }

    pub(crate) fn push(&mut self, row: &Row<'_>) {
        for ((_, value), list) in self.cells.0.iter().zip(&mut self.lists) {
            match (value.cell(row), list) {
                (Cell::Number(value), Values::Numbers(list)) => list.push(value),
                (Cell::Word(word), Values::Words(list)) => list.push(word),
                _ => {} // a list is of what its cells are
            }
        }
    }

    pub(crate) fn into_columns(self) -> SampleColumns {
        Columns::new(self.cells.0.into_iter().map(|(about, _)| about).zip(self.lists).collect())
    }
}
