//! The rows of a block, one after the other.

use std::sync::Arc;
use std::time::Instant;

use terramechanics_reading::FieldFault;

use super::answers::{Answers, in_words};
use super::plan::Plan;
use crate::api::forces::ForcesCase;
use crate::compute::SLICE;
use crate::request::error_fault;
use crate::request::pull::SlipFrom;
use crate::rows::Block;
use crate::stream::Job;
use crate::varied::{RowStatus, Templates};
use crate::warning::Tally;

/// Rows between two readings of the clock, which takes a good part of the time of a cheap row.
const ROWS_PER_LOOK: usize = 16;

/// A block under way, and what reads its rows.
pub(super) struct Rows {
    plan: Arc<Plan>,
    templates: Templates<ForcesCase>,
    pub(super) block: Block,
    next: usize,
    /// Whether the row before may have taken long.
    is_costly: bool,
    pub(super) answers: Answers,
    pub(super) output: Vec<u8>,
}

impl Rows {
    pub(super) fn new(plan: Arc<Plan>) -> Self {
        let (templates, block, output) = (Templates::default(), Block::default(), Vec::new());
        Self { plan, templates, block, next: 0, is_costly: false, answers: Answers::default(), output }
    }

    /// Makes room for another block, behind so many rows.
    pub(super) fn begin(&mut self, block: Block) {
        self.answers.numbers.resize_with(self.plan.values.len(), Vec::new);
        self.answers.numbers.iter_mut().for_each(Vec::clear);
        self.answers.faults.clear();
        self.answers.tally = Tally::behind(block.first);
        (self.block, self.next) = (block, 0);
        self.templates.begin();
    }

    fn row(&mut self, row: usize) {
        let Self { plan, templates, block, is_costly, answers, .. } = self;
        answers.tally.begin_row();
        let case = match block.fault(row) {
            Some(fault) => Err(vec![FieldFault::new("", fault)]),
            None => templates.case(&plan.constants, &plan.columns.fields, block, row, &mut answers.assumed),
        };
        let Plan { values, .. } = &**plan;
        let fault = match case {
            Ok(case) => {
                answers.has_case = true;
                *is_costly = !case.operation.model.method.is_closed_form() || matches!(case.slip, SlipFrom::Pull(_));
                let mut columns = answers.numbers.iter_mut();
                let put = |number| columns.next().into_iter().for_each(|column| column.push(number));
                match case.answer(values.iter().copied(), &mut answers.tally, put) {
                    Ok(()) => None,
                    Err(error) => {
                        let fault = error_fault(&error, &case.operation.sinkage);
                        Some(in_words(RowStatus::NoSolution, &[fault]))
                    }
                }
            }
            Err(found) => {
                answers.numbers.iter_mut().for_each(|column| column.push(f64::NAN));
                Some(answers.refuse(found, block, row, &plan.columns))
            }
        };
        answers.faults.push(fault);
    }
}

impl Job for Rows {
    fn slice(&mut self) -> bool {
        let slice_end = Instant::now() + SLICE;
        while self.next < self.block.rows() {
            self.row(self.next);
            self.next += 1;
            if (self.is_costly || self.next.is_multiple_of(ROWS_PER_LOOK)) && Instant::now() >= slice_end {
                return false;
            }
        }
        let plan = self.plan.clone();
        plan.writer.rows(&self.block, &mut self.answers, &mut self.output);
        true
    }
}
