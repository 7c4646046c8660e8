//! The answer of a batch: a row for each of its rows, and an end that tells a whole answer from one that was cut.

use super::answers::{Answers, OK, STATUS};
use super::arrow;
use crate::extract::RowsForm;
use crate::quantity::Cell;
use crate::reply::arrow::ArrowStream;
use crate::reply::{End, RowFormat};
use crate::rows::{Block, Columns, EchoedCell};

/// Writes rows in a form.
#[derive(Debug)]
pub(super) enum Writer {
    /// With the names of all columns.
    Text(RowFormat, Vec<String>),
    Arrow(ArrowStream),
    /// None: the numbers stay where they are, for a caller in the same process.
    Memory,
}

impl Writer {
    /// Behind the columns of the body that are repeated stand those of `names`, and the status.
    pub(super) fn new(form: RowsForm, columns: &Columns, names: impl Iterator<Item = &'static str>) -> Self {
        let echoed = columns.echoed.iter();
        let own = |names: &mut dyn Iterator<Item = &'static str>| names.chain([STATUS]).map(str::to_owned).collect::<Vec<_>>();
        let mut names = names;
        match form {
            RowsForm::Csv => Self::Text(RowFormat::Csv, echoed.cloned().chain(own(&mut names)).collect()),
            RowsForm::Ndjson => Self::Text(RowFormat::Ndjson, echoed.map(|name| escaped(name)).chain(own(&mut names)).collect()),
            RowsForm::Arrow => Self::Arrow(arrow::stream(columns, names)),
        }
    }

    /// What stands before the first row.
    pub(super) fn head(&self, output: &mut Vec<u8>) {
        match self {
            Self::Text(format, names) => format.head(names.iter().map(String::as_str), output),
            Self::Arrow(stream) => stream.head(output),
            Self::Memory => {}
        }
    }

    /// The rows of a block.
    pub(super) fn rows(&self, block: &Block, answers: &mut Answers, output: &mut Vec<u8>) {
        let (format, names) = match self {
            Self::Text(format, names) => (format, names),
            Self::Arrow(stream) => return arrow::rows(stream, block, answers, output),
            Self::Memory => return,
        };
        for row in 0..block.rows() {
            let echoes = block.echoes().iter().map(|echoed| match echoed.cell(row) {
                EchoedCell::Nothing => Cell::Nothing,
                EchoedCell::Literal(text) => Cell::Literal(text),
                EchoedCell::Text(text) => Cell::Word(text),
            });
            let numbers = answers.numbers.iter().map(|column| Cell::Number(column[row]));
            let status = Cell::Word(answers.faults[row].as_deref().unwrap_or(OK));
            format.row(names.iter().map(String::as_str).zip(echoes.chain(numbers).chain([status])), output);
        }
    }

    /// The end of a whole answer.
    pub(super) fn end(&self, end: &End, output: &mut Vec<u8>) {
        match self {
            Self::Text(format, _) => format.end(end, output),
            Self::Arrow(stream) => stream.end(end, output),
            Self::Memory => {}
        }
    }

    /// The end of an answer that is not complete; false where the form has no place for it.
    pub(super) fn broken(&self, problem: &str, output: &mut Vec<u8>) -> bool {
        match self {
            Self::Text(format, _) => format.broken(problem, output),
            Self::Arrow(_) | Self::Memory => return false,
        }
        true
    }
}

/// The name of a column of the body as it stands between the quotes of JSON.
fn escaped(name: &str) -> String {
    let quoted = serde_json::to_string(name).unwrap_or_default();
    quoted.get(1..quoted.len() - 1).unwrap_or_default().to_owned()
}
