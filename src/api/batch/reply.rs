//! The answer of a batch: a row for each of its rows, and an end that tells a whole answer from one that was cut.

use crate::extract::RowsForm;
use crate::quantity::Cell;
use crate::reply::{End, RowFormat};
use crate::rows::{Block, EchoedCell};

use super::evaluate::Answers;

/// Name of the column that says how a row went.
pub(super) const STATUS: &str = "status";

/// The status of a row that has an answer.
const OK: &str = "ok";

/// Writes rows in a form.
#[derive(Debug)]
pub(super) struct Writer {
    form: RowsForm,
    /// Of all columns, the status last.
    names: Vec<String>,
}

/// The name of a column of the body as the form has it.
fn written(name: &str, form: RowsForm) -> String {
    match form {
        RowsForm::Csv => name.to_owned(),
        RowsForm::Ndjson => {
            let quoted = serde_json::to_string(name).unwrap_or_default();
            quoted.get(1..quoted.len() - 1).unwrap_or_default().to_owned()
        }
    }
}

impl Writer {
    pub(super) fn new(form: RowsForm, echoed: &[String], names: impl Iterator<Item = &'static str>) -> Self {
        let own = names.chain([STATUS]).map(str::to_owned);
        Self { form, names: echoed.iter().map(|name| written(name, form)).chain(own).collect() }
    }

    fn format(&self) -> RowFormat {
        match self.form {
            RowsForm::Csv => RowFormat::Csv,
            RowsForm::Ndjson => RowFormat::Ndjson,
        }
    }

    /// What stands before the first row.
    pub(super) fn head(&self, output: &mut Vec<u8>) {
        self.format().head(self.names.iter().map(String::as_str), output);
    }

    /// The rows of a block.
    pub(super) fn rows(&self, block: &Block, answers: &Answers, output: &mut Vec<u8>) {
        let format = self.format();
        for row in 0..block.rows() {
            let echoes = block.echoes().iter().map(|echoed| match echoed.cell(row) {
                EchoedCell::Nothing => Cell::Nothing,
                EchoedCell::Literal(text) => Cell::Literal(text),
                EchoedCell::Text(text) => Cell::Word(text),
            });
            let numbers = answers.numbers.iter().map(|column| Cell::Number(column[row]));
            let status = Cell::Word(answers.faults[row].as_deref().unwrap_or(OK));
            format.row(self.names.iter().map(String::as_str).zip(echoes.chain(numbers).chain([status])), output);
        }
    }

    /// The end of a whole answer.
    pub(super) fn end(&self, end: &End, output: &mut Vec<u8>) {
        self.format().end(end, output);
    }

    /// The end of an answer that is not complete.
    pub(super) fn broken(&self, problem: &str, output: &mut Vec<u8>) {
        self.format().broken(problem, output);
    }
}
