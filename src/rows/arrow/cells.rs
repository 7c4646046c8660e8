//! The cells of Arrow's arrays as those of rows.

use arrow_array::cast::AsArray;
use arrow_array::types::{
    Float32Type, Float64Type, Int8Type, Int16Type, Int32Type, Int64Type, UInt8Type, UInt16Type, UInt32Type, UInt64Type,
};
use arrow_array::{Array, ArrayRef, RecordBatch};
use arrow_schema::DataType;
use terramechanics_reading::Node;

use crate::rows::columns::CellKind;
use crate::rows::{Block, EchoedCell};

/// What the cells of a column of that type are.
pub(super) fn kind_of(of: &DataType) -> CellKind {
    match of {
        DataType::Utf8 | DataType::LargeUtf8 | DataType::Utf8View => CellKind::Texts,
        DataType::Dictionary(_, values) if kind_of(values) == CellKind::Texts => CellKind::Texts,
        DataType::Float32 | DataType::Float64 => CellKind::Numbers,
        of if of.is_integer() => CellKind::Numbers,
        DataType::Boolean => CellKind::Flags,
        DataType::Null => CellKind::Nothing,
        _ => CellKind::Others,
    }
}

/// Bytes of the largest dictionary of a record batch.
pub(super) fn largest_dictionary(batch: &RecordBatch) -> usize {
    let sizes = batch.columns().iter().filter_map(|array| Some(array.as_any_dictionary_opt()?.values().get_buffer_memory_size()));
    sizes.max().unwrap_or(0)
}

/// A cell of an array.
enum Value<'a> {
    Number(f64),
    Flag(bool),
    Text(&'a str),
}

/// Calls `take` with every cell that is not null, by its row.
fn each(array: &ArrayRef, mut take: impl FnMut(usize, Value<'_>)) {
    macro_rules! numbers {
        ($($of:pat => $kind:ty),+) => {
            match array.data_type() {
                $($of => {
                    let numbers = array.as_primitive::<$kind>();
                    for (row, number) in numbers.values().iter().enumerate() {
                        if numbers.is_valid(row) {
                            take(row, Value::Number(*number as f64));
                        }
                    }
                })+
                DataType::Boolean => {
                    let flags = array.as_boolean();
                    flags.iter().enumerate().for_each(|(row, flag)| {
                        flag.into_iter().for_each(|flag| take(row, Value::Flag(flag)));
                    });
                }
                DataType::Utf8 => texts(array.as_string::<i32>().iter(), take),
                DataType::LargeUtf8 => texts(array.as_string::<i64>().iter(), take),
                DataType::Utf8View => texts(array.as_string_view().iter(), take),
                DataType::Dictionary(..) => of_dictionary(array, take),
                _ => {}
            }
        };
    }
    numbers!(
        DataType::Float64 => Float64Type, DataType::Float32 => Float32Type,
        DataType::Int8 => Int8Type, DataType::Int16 => Int16Type, DataType::Int32 => Int32Type, DataType::Int64 => Int64Type,
        DataType::UInt8 => UInt8Type, DataType::UInt16 => UInt16Type, DataType::UInt32 => UInt32Type, DataType::UInt64 => UInt64Type
    );
}

fn texts<'a>(cells: impl Iterator<Item = Option<&'a str>>, mut take: impl FnMut(usize, Value<'_>)) {
    for (row, text) in cells.enumerate() {
        text.into_iter().for_each(|text| take(row, Value::Text(text)));
    }
}

fn of_dictionary(array: &ArrayRef, mut take: impl FnMut(usize, Value<'_>)) {
    let Some(dictionary) = array.as_any_dictionary_opt().filter(|dictionary| !dictionary.values().is_empty()) else { return };
    let places = dictionary.normalized_keys();
    let values = dictionary.values();
    let mut cells = |text: &dyn Fn(usize) -> Option<String>| {
        let known: Vec<Option<String>> =
            if values.len() <= places.len() { (0..values.len()).map(text).collect() } else { Vec::new() };
        for (row, &place) in places.iter().enumerate().filter(|(row, _)| dictionary.keys().is_valid(*row)) {
            let looked_up;
            let found = match known.get(place) {
                Some(found) => found,
                None => {
                    looked_up = text(place);
                    &looked_up
                }
            };
            found.iter().for_each(|text| take(row, Value::Text(text)));
        }
    };
    match values.data_type() {
        DataType::Utf8 => {
            let texts = values.as_string::<i32>();
            cells(&|place| texts.is_valid(place).then(|| texts.value(place).to_owned()));
        }
        DataType::LargeUtf8 => {
            let texts = values.as_string::<i64>();
            cells(&|place| texts.is_valid(place).then(|| texts.value(place).to_owned()));
        }
        DataType::Utf8View => {
            let texts = values.as_string_view();
            cells(&|place| texts.is_valid(place).then(|| texts.value(place).to_owned()));
        }
        _ => {}
    }
}

/// Adds the cells of a column that is a field.
pub(super) fn column_of(array: &ArrayRef, field: usize, block: &mut Block) {
    if let (DataType::Float64, 0) = (array.data_type(), array.null_count()) {
        return block.all_numbers(field, array.as_primitive::<Float64Type>().values());
    }
    each(array, |row, value| match value {
        Value::Number(number) => block.number_at(row, field, number),
        Value::Flag(flag) => block.other_at(row, field, Node::Flag(flag)),
        Value::Text(text) => block.text_at(row, field, text, |text| Node::Text(text.to_owned().into())),
    });
}

/// Adds the cells of a column that is repeated as text.
pub(super) fn echo_of(array: &ArrayRef, echo: usize, block: &mut Block) {
    let is_whole = array.data_type().is_integer();
    let mut next = 0;
    each(array, |row, value| {
        (next..row).for_each(|_| block.echo(echo, EchoedCell::Nothing));
        next = row + 1;
        match value {
            Value::Number(number) if is_whole => block.echo(echo, EchoedCell::Literal(&format!("{number:.0}"))),
            Value::Number(number) if number.is_finite() => block.echo(echo, EchoedCell::Literal(&format!("{number:?}"))),
            Value::Number(_) => block.echo(echo, EchoedCell::Nothing),
            Value::Flag(flag) => block.echo(echo, EchoedCell::Literal(if flag { "true" } else { "false" })),
            Value::Text(text) => block.echo(echo, EchoedCell::Text(text)),
        }
    });
    (next..array.len()).for_each(|_| block.echo(echo, EchoedCell::Nothing));
}
