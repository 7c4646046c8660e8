//! The answer of a batch as an Arrow stream: a record batch for each block.

use std::sync::Arc;

use arrow_array::{ArrayRef, StringArray};
use arrow_schema::DataType;

use super::answers::{Answers, OK, STATUS};
use crate::reply::arrow::{ArrowStream, numbers, texts};
use crate::rows::{Block, Columns, EchoedCell};

/// The stream with the columns that are repeated, those of the answer and the status.
pub(super) fn stream(columns: &Columns, own: impl Iterator<Item = &'static str>) -> ArrowStream {
    let echoed = columns.echoed.iter().zip(&columns.kept);
    let echoed = echoed.map(|(name, kind)| (name.clone(), kind.clone().unwrap_or(DataType::Utf8)));
    ArrowStream::new(echoed.chain(own.map(|name| (name.to_owned(), DataType::Float64))), STATUS)
}

/// Writes the rows of a block.
pub(super) fn rows(stream: &ArrowStream, block: &Block, answers: &mut Answers, output: &mut Vec<u8>) {
    let echoes = block.echoes().iter().map(|echoed| match echoed.arrays() {
        [] => texts((0..block.rows()).map(|row| match echoed.cell(row) {
            EchoedCell::Nothing => None,
            EchoedCell::Literal(text) | EchoedCell::Text(text) => Some(text),
        })),
        [one] => one.clone(),
        _ => Arc::new(StringArray::new_null(0)),
    });
    let mut columns: Vec<ArrayRef> = echoes.collect();
    columns.extend(answers.numbers.iter_mut().map(|column| numbers(std::mem::take(column))));
    columns.push(texts((0..block.rows()).map(|row| Some(answers.faults[row].as_deref().unwrap_or(OK)))));
    stream.rows(columns, output);
}
