//! The operation as a function of the variables.

use terramechanics_optimum::Refusal;
use terramechanics_reading::{Assumption, FieldFault};

use crate::api::optimum::request::Sought;
use crate::compute::Pace;
use crate::problem::Problem;
use crate::quantity::About;
use crate::varied::{RowStatus, Template, Varied, tell_invalid};
use crate::warning::{Tally, Warning, of_assumptions};

/// The operation, asked with one set of values after the other.
pub(super) struct Asked<'s, R> {
    sought: &'s Sought<R>,
    pace: &'s Pace,
    template: Template<R>,
    cells: Vec<f64>,
    /// The constraint that the rover climbs, by its place among the outputs, and the column that says whether it does.
    climb: Option<[usize; 2]>,
    /// Points that had an answer, those of them with a rover for which no slip gives the pull, and at how many each formula had a value.
    answered: u32,
    stuck: u32,
    finite: Vec<u32>,
    /// What is to be said of all points that were tried; only where none has an answer it is told.
    tally: Tally,
}

/// A point in full.
pub(super) struct FullRow {
    pub(super) columns: Vec<(&'static About, f64)>,
    pub(super) warnings: Vec<Warning>,
    pub(super) assumed: Option<Vec<Assumption>>,
}

/// Points in full, column by column.
type FullRows = (Vec<(&'static About, Vec<f64>)>, Vec<Warning>, Option<Vec<Assumption>>);

impl<'s, R: Varied> Asked<'s, R> {
    pub(super) fn of(sought: &'s Sought<R>, pace: &'s Pace) -> Self {
        let (goals, columns) = (&sought.goals, sought.sample.columns());
        let climbs = columns.iter().position(|about| about.name == CLIMBS);
        let first = 1 + usize::from(goals.against.is_some());
        let climb = goals.climb().zip(climbs).map(|(constraint, column)| [first + constraint, column]);
        let finite = vec![0; first + goals.constraints.len()];
        let template = sought.template.clone();
        Self { sought, pace, template, cells: Vec::new(), climb, answered: 0, stuck: 0, finite, tally: Tally::default() }
    }

    /// The goals and the constrained quantities.
    ///
    /// # Errors
    /// That there is no answer. One of the quantities may have no value.
    pub(super) fn outputs(&mut self, values: &[f64]) -> Result<Vec<f64>, Refusal> {
        let status = Self::ask(&mut self.template, values, &mut self.cells, &mut self.tally, self.pace);
        if !has_numbers(status) {
            return Err(Refusal::NoAnswer);
        }
        let formulas = self.sought.goals.formulas();
        let outputs: Vec<f64> = formulas.map(|formula| formula.value(values, &self.cells)).collect();
        self.answered += 1;
        self.stuck += u32::from(status == RowStatus::NotClimbed);
        self.finite.iter_mut().zip(&outputs).for_each(|(finite, output)| *finite += u32::from(output.is_finite()));
        match self.climb {
            // A slope below the largest one may be a descent on which nothing holds the rover.
            Some([spare, climbs]) if outputs[spare] >= 0.0 && self.cells.get(climbs) != Some(&1.0) => Err(Refusal::NoAnswer),
            _ => Ok(outputs),
        }
    }

    /// Asks with these values: the cells of the row, and how it went.
    fn ask(template: &mut Template<R>, values: &[f64], cells: &mut Vec<f64>, tally: &mut Tally, pace: &Pace) -> RowStatus {
        cells.clear();
        match template.case(values) {
            Ok(case) => case.row(cells, tally, pace),
            Err(faults) => tell_invalid(faults, tally),
        }
    }

    /// The point with these values.
    pub(super) fn row(&mut self, values: &[f64]) -> FullRow {
        let (columns, mut warnings, assumed) = self.rows(std::iter::once(values));
        let first = |(about, values): (&'static About, Vec<f64>)| (about, values.first().copied().unwrap_or(f64::NAN));
        warnings.extend(of_assumptions(assumed.as_deref().unwrap_or_default()));
        FullRow { columns: columns.into_iter().map(first).collect(), warnings, assumed }
    }

    /// The points with these values.
    pub(super) fn rows<'v>(&mut self, points: impl Iterator<Item = &'v [f64]>) -> FullRows {
        let mut columns: Vec<(&'static About, Vec<f64>)> =
            self.sought.sample.columns().into_iter().map(|about| (about, Vec::new())).collect();
        let mut tally = Tally::default();
        for values in points {
            tally.begin_row();
            Self::ask(&mut self.template, values, &mut self.cells, &mut tally, self.pace);
            let cells = self.cells.iter().copied().chain(std::iter::repeat(f64::NAN));
            columns.iter_mut().zip(cells).for_each(|((_, list), cell)| list.push(cell));
        }
        (columns, tally.into_warnings(), self.template.assumed().map(<[Assumption]>::to_vec))
    }

    /// Why none of so many points could be used: the request has no answer anywhere, or a formula has no value where it has one.
    pub(super) fn no_answer(&mut self, evaluations: u32) -> Problem {
        let answered = self.answered;
        if answered == 0 {
            let (reason, hints) = self.first_reason();
            let reason = reason.map_or_else(String::new, |reason| format!(". The first: {reason}"));
            let detail = format!("has no answer at any of {evaluations} points within the bounds{reason}");
            return Problem::Refused(vec![FieldFault::new("/request", detail)], hints);
        }
        let why = if self.stuck == answered { ", because the rover climbs its slope at none of them" } else { "" };
        let goals = &self.sought.goals;
        let told = || goals.formulas().zip(goals.pointers()).zip(&self.finite);
        let never = told().filter(|(_, finite)| **finite == 0).map(|((formula, pointer), _)| {
            let of = formula.text.as_str();
            let detail =
                format!("`{of}` has no finite value at any of the {answered} points within the bounds that have an answer{why}");
            FieldFault::new(pointer, detail)
        });
        let never: Vec<FieldFault> = never.collect();
        if !never.is_empty() {
            return Problem::Invalid(never);
        }
        let rarest = told().min_by_key(|(_, finite)| **finite);
        let fault = rarest.map(|((formula, pointer), finite)| {
            let of = formula.text.as_str();
            let detail = format!(
                "`{of}` has a finite value at {finite} of {answered} points within the bounds, but the other quantities have none there"
            );
            FieldFault::new(pointer, detail)
        });
        Problem::Invalid(fault.into_iter().collect())
    }

    /// Why a point had no answer, and what of the request may be meant otherwise.
    fn first_reason(&mut self) -> (Option<String>, Vec<Warning>) {
        let (hints, reasons): (Vec<_>, Vec<_>) =
            std::mem::take(&mut self.tally).into_warnings().into_iter().partition(Warning::is_hint);
        (reasons.first().map(Warning::detail), hints)
    }
}

/// The column that says whether a rover climbs.
const CLIMBS: &str = "climbs";

/// Whether a row has numbers: a rover that does not climb its slope still has its largest slope.
fn has_numbers(status: RowStatus) -> bool {
    match status {
        RowStatus::Ok | RowStatus::NotClimbed => true,
        RowStatus::Invalid | RowStatus::NoSolution => false,
    }
}
