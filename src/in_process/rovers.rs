//! Rovers in rows, block by block.

use std::sync::Arc;

use terramechanics_reading::Node;

use crate::api::batch::{Answers, in_words};
use crate::api::vehicle::{VehicleCase, rover_columns};
use crate::compute::Pace;
use crate::quantity::About;
use crate::rows::{Block, Columns};
use crate::varied::{Templates, Varied};
use crate::warning::Tally;

/// The column that takes most of the time of a row, and is found where it is asked for.
const LARGEST: &str = "largest_slope_rad";

/// What the rows have in common.
pub(super) struct RoverPlan {
    constants: Node<'static>,
    columns: Arc<Columns>,
    about: Vec<&'static About>,
    /// The places of those columns in a row.
    places: Vec<usize>,
    with_largest: bool,
}

impl RoverPlan {
    /// The plan of rows with these columns, whose answers have those columns that `is_asked` names.
    pub(super) fn new(constants: Node<'static>, columns: Arc<Columns>, is_asked: impl Fn(&About) -> bool) -> Self {
        let (places, about): (Vec<usize>, Vec<&'static About>) =
            rover_columns().enumerate().filter(|(_, about)| is_asked(about)).unzip();
        let with_largest = about.iter().any(|about| about.name == LARGEST);
        Self { constants, columns, about, places, with_largest }
    }

    /// The columns of the answer.
    pub(super) fn columns(&self) -> &[&'static About] {
        &self.about
    }

    /// What answers one block after the other.
    pub(super) fn worker(self: &Arc<Self>) -> RoverRows {
        RoverRows { plan: self.clone(), templates: Templates::default(), cells: Vec::new() }
    }
}

/// Answers one block after the other.
pub(super) struct RoverRows {
    plan: Arc<RoverPlan>,
    templates: Templates<VehicleCase>,
    /// The numbers that it gave.
    cells: Vec<f64>,
}

impl RoverRows {
    /// What the rows of the block give, and the block with its room.
    pub(super) fn answer(&mut self, block: Block) -> (Answers, Block) {
        let mut answers = Answers { tally: Tally::behind(block.first), ..Answers::default() };
        answers.numbers.resize_with(self.plan.about.len(), || Vec::with_capacity(block.rows()));
        self.templates.begin();
        for row in 0..block.rows() {
            answers.tally.begin_row();
            self.cells.clear();
            let fault = self.row(&block, row, &mut answers);
            for (column, place) in answers.numbers.iter_mut().zip(&self.plan.places) {
                column.push(self.cells.get(*place).copied().unwrap_or(f64::NAN));
            }
            answers.faults.push(fault);
        }
        (answers, block)
    }

    /// What a row gives, into the cells; in words what was wrong with it, if something was.
    fn row(&mut self, block: &Block, row: usize, answers: &mut Answers) -> Option<Box<str>> {
        let Self { plan, templates, cells } = self;
        let case = templates.case(&plan.constants, &plan.columns.fields, block, row, &mut answers.assumed);
        let found = match case.map(|case| (case, case.refusal())) {
            Ok((case, None)) => {
                answers.has_case = true;
                match case.answer(plan.with_largest, cells, &mut answers.tally, &Pace::at_once()) {
                    Ok(()) => return None,
                    Err(error) => {
                        let (status, fault) = case.refused(&error);
                        return Some(in_words(status, &[fault]));
                    }
                }
            }
            Ok((_, Some(refusal))) => vec![refusal],
            Err(found) => found,
        };
        Some(answers.refuse(found, block, row, &plan.columns))
    }
}
