//! The operation as a function of the variables.

use terramechanics_optimum::Refusal;
use terramechanics_reading::Assumption;

use crate::api::optimum::request::{Goal, Goals, Sought};
use crate::quantity::About;
use crate::varied::{RowStatus, Template, Varied, tell_invalid};
use crate::warning::{Tally, Warning, of_assumptions};

/// The operation, asked with one set of values after the other.
pub(super) struct Asked<'s, R> {
    sought: &'s Sought<R>,
    template: Template<R>,
    cells: Vec<f64>,
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
    pub(super) fn of(sought: &'s Sought<R>) -> Self {
        Self { sought, template: sought.template.clone(), cells: Vec::new(), tally: Tally::default() }
    }

    /// The goals and the constrained quantities.
    ///
    /// # Errors
    /// That there is no answer, or that one of the quantities has no value.
    pub(super) fn outputs(&mut self, values: &[f64]) -> Result<Vec<f64>, Refusal> {
        let status = Self::ask(&mut self.template, values, &mut self.cells, &mut self.tally);
        if !has_numbers(status) {
            return Err(Refusal::NoAnswer);
        }
        let Goals { goal, constraints, against } = &self.sought.goals;
        let against = against.iter().map(|(Goal { formula, .. }, _)| formula);
        let formulas = std::iter::once(&goal.formula).chain(against).chain(constraints.iter().map(|of| &of.quantity));
        Ok(formulas.map(|formula| formula.value(values, &self.cells)).collect())
    }

    /// Asks with these values: the cells of the row, and how it went.
    fn ask(template: &mut Template<R>, values: &[f64], cells: &mut Vec<f64>, tally: &mut Tally) -> RowStatus {
        cells.clear();
        match template.case(values) {
            Ok(case) => case.row(cells, tally),
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
            Self::ask(&mut self.template, values, &mut self.cells, &mut tally);
            let cells = self.cells.iter().copied().chain(std::iter::repeat(f64::NAN));
            columns.iter_mut().zip(cells).for_each(|((_, list), cell)| list.push(cell));
        }
        (columns, tally.into_warnings(), self.template.assumed().map(<[Assumption]>::to_vec))
    }

    /// Why a point had no answer, and what of the request may be meant otherwise.
    pub(super) fn first_reason(&mut self) -> (Option<String>, Vec<Warning>) {
        let (hints, reasons): (Vec<_>, Vec<_>) =
            std::mem::take(&mut self.tally).into_warnings().into_iter().partition(Warning::is_hint);
        (reasons.first().map(Warning::detail), hints)
    }
}

/// Whether a row has numbers: a rover that does not climb its slope still has its largest slope.
fn has_numbers(status: RowStatus) -> bool {
    match status {
        RowStatus::Ok | RowStatus::NotClimbed => true,
        RowStatus::Invalid | RowStatus::NoSolution => false,
    }
}
