//! Rows as one JSON object a line: `{"soil.cohesion_pa": 200, "slip": 0.2}`, or the same with objects within.

use std::sync::Arc;

use terramechanics_reading::{Fields, Node, Unread, json};

use super::echo::EchoedCell;
use super::{Block, Columns, Read, Wanted};
use crate::problem::Problem;
use crate::series::{Line, Lines, SeriesFault};

/// How a row is written, for those who wrote something else.
const HOW: &str = "write one object a line, such as {\"soil.cohesion_pa\": 200, \"slip\": 0.2}";

/// Reads lines piece by piece. The columns are the fields of the first object.
pub(crate) struct NdjsonRows {
    wanted: Wanted,
    lines: Lines,
    columns: Option<Arc<Columns>>,
    /// The names of the columns.
    names: Vec<String>,
    /// What is wrong with the first line, as long as no line told the columns.
    first_fault: Option<SeriesFault>,
}

impl NdjsonRows {
    pub(super) fn new(wanted: Wanted) -> Self {
        Self { wanted, lines: Lines::default(), columns: None, names: Vec::new(), first_fault: None }
    }

    pub(super) fn columns(&self) -> Option<&Arc<Columns>> {
        self.columns.as_ref()
    }

    pub(super) fn fill(&mut self, input: &mut &[u8], last: bool, block: &mut Block) -> Result<Read, Problem> {
        loop {
            if block.is_full() {
                return if self.columns.is_some() { Ok(Read::Full) } else { Err(self.no_columns()) };
            }
            match self.lines.next(input, last).map_err(Problem::Unreadable)? {
                Line::More => return Ok(Read::More),
                Line::End if self.columns.is_none() => return Err(self.no_columns()),
                Line::End => return Ok(Read::End),
                Line::Text(line) => self.line(&line, block)?,
            }
        }
    }

    /// No line told the columns: the form is wrong rather than a row.
    fn no_columns(&mut self) -> Problem {
        let fault = self.first_fault.take();
        Problem::Unreadable(fault.unwrap_or_else(|| self.lines.fault(0, "there are no rows")))
    }

    fn line(&mut self, line: &[u8], block: &mut Block) -> Result<(), Problem> {
        let (column, detail) = match json(line) {
            Ok(Node::Object(fields)) => return self.row(&fields, block),
            Ok(other) => (0, format!("must be an object, not {}; {HOW}", other.in_words())),
            Err(Unread::TooMuch) => (0, Unread::TooMuch.to_string()),
            Err(Unread::NotJson(error)) => {
                let said = error.to_string();
                let said = said.split(" at line ").next().unwrap_or_default();
                (error.column(), format!("the line is not JSON, {said}; {HOW}"))
            }
        };
        let fault = self.lines.fault(column, detail);
        block.faulty_row(fault.to_string());
        if self.columns.is_none() {
            self.first_fault.get_or_insert(fault);
        }
        Ok(())
    }

    fn row(&mut self, fields: &Fields<'_>, block: &mut Block) -> Result<(), Problem> {
        let columns = match &self.columns {
            Some(columns) => columns,
            None => {
                let mut names = Vec::new();
                each(fields, "", &mut |name, _| names.push(name.to_owned()));
                let columns = self.wanted.columns(&names).map_err(Problem::Invalid)?;
                block.with(&columns);
                self.names = names;
                self.columns.insert(Arc::new(columns))
            }
        };
        // Most rows have the same fields in the same order.
        let (mut next, mut seen, mut odd) = (0, vec![false; self.names.len()], None);
        each(fields, "", &mut |name, value| {
            let here = if self.names.get(next).is_some_and(|known| known == name) { Some(next) } else { None };
            let at = here.or_else(|| self.names.iter().position(|known| known == name));
            let Some(at) = at.filter(|at| !seen[*at]) else {
                odd.get_or_insert_with(|| match at {
                    Some(_) => format!("`{}` is given more than once", terramechanics_reading::shortened(name)),
                    None => format!("the first object has no `{}`, so none may have it", terramechanics_reading::shortened(name)),
                });
                return;
            };
            next = at + 1;
            seen[at] = true;
            if let Some(field) = columns.field_of[at] {
                match value {
                    Node::Null => {}
                    Node::Number(value) => block.number(field, *value),
                    Node::Text(text) => block.text(field, text, |text| Node::Text(text.to_owned().into())),
                    other => block.other(field, other.detached()),
                }
            }
            if let Some(column) = columns.echo_of[at] {
                echo(block, column, value);
            }
        });
        match odd {
            None => block.end_row(),
            Some(odd) => block.faulty_row(self.lines.fault(0, odd).to_string()),
        }
        Ok(())
    }
}

/// Calls `take` with every value that is no object, by its name with dots between the objects and their fields.
fn each(fields: &Fields<'_>, around: &str, take: &mut impl FnMut(&str, &Node<'_>)) {
    for (name, value) in fields.iter() {
        let full;
        let name = match around {
            "" => name,
            around => {
                full = format!("{around}.{name}");
                &full
            }
        };
        match value {
            Node::Object(within) => each(within, name, take),
            value => take(name, value),
        }
    }
}

fn echo(block: &mut Block, column: usize, value: &Node<'_>) {
    match value {
        Node::Number(value) => {
            // A whole number is written as one, as it probably came.
            let is_whole = value.fract() == 0.0 && value.abs() < 9e15;
            let text = if is_whole { format!("{}", *value as i64) } else { format!("{value:?}") };
            block.echo(column, EchoedCell::Literal(&text));
        }
        Node::Flag(flag) => block.echo(column, EchoedCell::Literal(if *flag { "true" } else { "false" })),
        Node::Text(text) | Node::Parameter(text) => block.echo(column, EchoedCell::Text(text)),
        Node::Null | Node::List(_) | Node::Object(_) => block.echo(column, EchoedCell::Nothing),
    }
}
