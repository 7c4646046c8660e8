//! A batch under way: blocks of rows in, blocks of answers out.

use std::sync::Arc;

use axum::body::Bytes;
use terramechanics_reading::{Assumption, FieldFault, Path};

use super::answers::Answers;
use super::evaluate::Rows;
use super::plan::Plan;
use super::reply::Writer;
use super::request::answered;
use crate::extract::RowsForm;
use crate::problem::Problem;
use crate::reply::{AssumedReply, End};
use crate::rows::{Block, Columns, Read, Reader, Wanted};
use crate::stream::{BlockWork, Taken};
use crate::varied::shared;
use crate::warning::{Tally, of_assumptions};

/// A batch under way.
pub(super) struct Batch {
    reader: Reader,
    wanted: Wanted,
    form: RowsForm,
    /// Once the columns are known.
    plan: Option<Arc<Plan>>,
    /// The block that is filled.
    block: Block,
    /// Rows that were read.
    rows: u64,
    /// What blocks need, to be used again.
    spare: Vec<Rows>,
    /// Whether the answer has begun.
    has_begun: bool,
    tally: Tally,
    assumed: Vec<Assumption>,
}

impl Batch {
    pub(super) fn new(wanted: Wanted, body: RowsForm, form: RowsForm) -> Self {
        let reader = match body {
            RowsForm::Csv => Reader::csv(wanted.clone()),
            RowsForm::Ndjson => Reader::ndjson(wanted.clone()),
            RowsForm::Arrow => Reader::arrow(Wanted { keeps_arrays: form == RowsForm::Arrow, ..wanted.clone() }),
        };
        Self {
            reader,
            wanted,
            form,
            plan: None,
            block: Block::default(),
            rows: 0,
            spare: Vec::new(),
            has_begun: false,
            tally: Tally::default(),
            assumed: Vec::new(),
        }
    }

    /// What all rows have in common, once the columns are known.
    fn plan(&mut self) -> Option<Arc<Plan>> {
        if self.plan.is_none() {
            let columns = self.reader.columns()?.clone();
            let answered: Vec<_> = answered(&self.wanted, &columns.fields).collect();
            let names = answered.iter().map(|(about, _)| about.name);
            let writer = Writer::new(self.form, &columns, names);
            let values = answered.iter().map(|(_, value)| *value).collect();
            self.plan = Some(Arc::new(Plan { constants: self.wanted.constants.clone(), columns, values, writer }));
        }
        self.plan.clone()
    }
}

/// The faults of the request that no row can mend, where all rows of the first block have them.
pub(crate) fn shared_faults(answers: &Answers, columns: &Columns) -> Vec<FieldFault> {
    if answers.has_case {
        return Vec::new();
    }
    let pointers: Vec<String> = columns.fields.iter().map(Path::pointer).collect();
    let is_of_all = |fault: &FieldFault| fault.figures.as_ref().is_none_or(|figures| figures.maximum_from.is_none());
    let shared = shared(&answers.refused, &pointers).into_iter().filter(|of_rows| of_rows.field.is_none());
    // A row that cannot be read has a fault of its own, which is that of no field.
    shared
        .map(|of_rows| of_rows.fault)
        .filter(|fault| !fault.pointer.is_empty() && is_of_all(fault) && !columns.may_mend(&fault.pointer))
        .collect()
}

impl BlockWork for Batch {
    type Job = Rows;

    fn media_type(&self) -> &'static str {
        self.form.content_type()
    }

    fn holds_input(&self) -> bool {
        self.reader.holds_input()
    }

    fn take(&mut self, input: &mut Bytes, last: bool) -> Result<Taken<Rows>, Problem> {
        let mut left: &[u8] = input;
        let read = self.reader.fill(&mut left, last, &mut self.block);
        *input = input.slice(input.len() - left.len()..);
        Ok(match read? {
            Read::More => Taken::NeedsInput,
            Read::Full => self.flush().map_or(Taken::NeedsInput, Taken::Block),
            Read::End => Taken::End(self.flush()),
        })
    }

    fn flush(&mut self) -> Option<Box<Rows>> {
        if self.block.rows() == 0 {
            return None;
        }
        let plan = self.plan()?;
        let mut rows = Box::new(self.spare.pop().unwrap_or_else(|| Rows::new(plan)));
        let mut next = std::mem::take(&mut rows.block);
        self.rows += self.block.rows() as u64;
        next.clear(self.rows);
        rows.begin(std::mem::replace(&mut self.block, next));
        Some(rows)
    }

    fn give(&mut self, mut rows: Box<Rows>) -> Result<Bytes, Problem> {
        let mut output = Vec::new();
        if !self.has_begun {
            let faults = self.plan.as_ref().map_or_else(Vec::new, |plan| shared_faults(&rows.answers, &plan.columns));
            if !faults.is_empty() {
                return Err(Problem::Invalid(faults));
            }
            self.has_begun = true;
            self.plan.iter().for_each(|plan| plan.writer.head(&mut output));
        }
        self.tally.follow(std::mem::take(&mut rows.answers.tally));
        for assumption in rows.answers.assumed.drain(..) {
            if !self.assumed.contains(&assumption) {
                self.assumed.push(assumption);
            }
        }
        rows.answers.refused.clear();
        if output.is_empty() {
            let room = rows.output.len();
            output = std::mem::replace(&mut rows.output, Vec::with_capacity(room));
        } else {
            output.append(&mut rows.output);
        }
        self.spare.push(*rows);
        Ok(output.into())
    }

    fn end(&mut self) -> Bytes {
        let mut output = Vec::new();
        let mut warnings = std::mem::take(&mut self.tally).into_warnings();
        warnings.extend(of_assumptions(&self.assumed));
        let assumed = std::mem::take(&mut self.assumed).into_iter().map(AssumedReply::from).collect::<Vec<_>>();
        let assumed = if assumed.is_empty() { None } else { Some(assumed) };
        let end = End { end: true, rows: self.rows, warnings, assumed };
        self.plan.iter().for_each(|plan| plan.writer.end(&end, &mut output));
        output.into()
    }

    fn broken(&self, problem: &Problem) -> Option<Bytes> {
        let mut output = Vec::new();
        let is_told = self.plan.as_ref()?.writer.broken(&problem.detail(), &mut output);
        is_told.then(|| output.into())
    }
}
