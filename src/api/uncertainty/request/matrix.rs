//! A square of numbers, row by row.

use terramechanics_reading::{Item, Kind, Node, Number, Scope};
use utoipa::openapi::schema::{ArrayBuilder, KnownFormat, ObjectBuilder, SchemaFormat, Type};
use utoipa::openapi::{RefOr, Schema};

/// Rows of coefficients from −1 to 1.
#[derive(Debug, Clone, Copy)]
pub(super) struct Matrix {
    /// Most rows, and most coefficients of a row.
    pub(super) most: usize,
}

const COEFFICIENT: Number = Number::new("1", -1.0, 1.0);

impl Kind for Matrix {
    type Value<'a> = Vec<Vec<f64>>;

    fn read<'a>(&self, node: &'a Node<'a>, place: Scope<'a>) -> Option<Vec<Vec<f64>>> {
        let Node::List(list) = node else {
            place.fault(format_args!("must be an array of rows, not {}", node.in_words()));
            return None;
        };
        if list.len() > self.most {
            place.fault(format_args!("must have at most {} rows", self.most));
            return None;
        }
        let row = |(i, item): (usize, Item<'_, '_>)| {
            let place = place.item(i);
            let row = match item {
                Item::Other(Node::List(row)) => row,
                other => {
                    place.fault(format_args!("must be an array of numbers, not {}", other.in_words()));
                    return None;
                }
            };
            if !row.others().is_empty() || row.len() > self.most {
                place.fault(format_args!("must have at most {} numbers {COEFFICIENT}", self.most));
                return None;
            }
            if let Some((column, coefficient)) =
                row.numbers().iter().enumerate().find(|(_, number)| !COEFFICIENT.allows(**number))
            {
                place.fault(format_args!("must have numbers {COEFFICIENT}; the one at {column} is {coefficient}"));
                return None;
            }
            Some(row.numbers().to_vec())
        };
        let rows: Vec<Option<Vec<f64>>> = list.items().enumerate().map(row).collect();
        rows.into_iter().collect()
    }

    fn schema(&self, meaning: &str) -> RefOr<Schema> {
        let [least, largest] = COEFFICIENT.range();
        let number = ObjectBuilder::new()
            .schema_type(Type::Number)
            .format(Some(SchemaFormat::KnownFormat(KnownFormat::Double)))
            .minimum(Some(least))
            .maximum(Some(largest));
        let row = ArrayBuilder::new().items(number).max_items(Some(self.most));
        ArrayBuilder::new().items(row).max_items(Some(self.most)).description(Some(meaning)).into()
    }

    fn what(&self) -> &'static str {
        "an array of rows"
    }
}
