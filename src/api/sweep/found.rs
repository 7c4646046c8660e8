//! The points of a sweep, row by row.

use std::ops::Range;
use std::sync::Arc;

use terramechanics_reading::Assumption;

use super::grid::Grid;
use super::request::Sweep;
use crate::compute::Pace;
use crate::quantity::About;
use crate::varied::{RowStatus, Template, Varied, tell_invalid};
use crate::warning::{Tally, Warning, of_assumptions};

/// A sweep under way, or some of its rows.
#[derive(Debug)]
pub(super) struct Running<R> {
    template: Template<R>,
    grid: Arc<Grid>,
    tally: Tally,
    /// Places of the columns of the operation that no axis has, among all that a row of the operation has.
    kept: Vec<usize>,
    columns: Vec<&'static About>,
    /// The rows that are left.
    rows: Range<usize>,
    /// The values of the point.
    values: Vec<f64>,
    /// The row as the operation gives it.
    row: Vec<f64>,
}

/// The findings of a sweep that has ended.
#[derive(Debug)]
pub(super) struct FoundGrid {
    pub(super) rows: usize,
    pub(super) warnings: Vec<Warning>,
    /// What was assumed of the request; no list where nothing may be.
    pub(super) assumed: Option<Vec<Assumption>>,
}

impl<R: Varied> Running<R> {
    pub(super) fn of(sweep: &Sweep<R>) -> Self {
        let Sweep { template, grid, sample } = sweep;
        let (template, grid) = (template.clone(), Arc::new(grid.clone()));
        let rows = 0..grid.len();
        let all = sample.columns();
        let is_axis = |about: &About| grid.axes().iter().any(|axis| axis.path.dotted() == about.name);
        let kept: Vec<usize> = (0..all.len()).filter(|&i| !is_axis(all[i])).collect();
        let columns = kept.iter().map(|&i| all[i]).collect();
        Self { template, grid, tally: Tally::default(), kept, columns, rows, values: Vec::new(), row: Vec::new() }
    }

    /// The same sweep with these of its rows.
    pub(super) fn part(&self, rows: Range<usize>) -> Self {
        let Self { template, grid, kept, columns, .. } = self;
        let (values, row) = (Vec::new(), Vec::new());
        let (template, grid, kept, columns) = (template.clone(), grid.clone(), kept.clone(), columns.clone());
        Self { template, grid, tally: Tally::behind(rows.start as u64), kept, columns, rows, values, row }
    }

    /// Puts these of its rows in place of those that were done.
    pub(super) fn restart(&mut self, rows: Range<usize>) {
        self.tally = Tally::behind(rows.start as u64);
        self.rows = rows;
    }

    /// Adds what is to be said of the rows of `part`, which come behind those so far.
    pub(super) fn follow(&mut self, part: &mut Self) {
        self.tally.follow(std::mem::take(&mut part.tally));
        if self.template.assumed().is_none() {
            self.template.assume(part.template.assumed());
        }
    }

    /// The names of the axes.
    pub(super) fn axes(&self) -> Vec<String> {
        self.grid.axes().iter().map(|axis| axis.path.dotted()).collect()
    }

    /// The columns of the operation, save those that an axis has.
    pub(super) fn columns(&self) -> &[&'static About] {
        &self.columns
    }

    /// Points in all.
    pub(super) fn len(&self) -> usize {
        self.grid.len()
    }

    /// The next row: the values of the axes and of the columns into `cells`, and how it went; none after the last.
    pub(super) fn next_row(&mut self, cells: &mut Vec<f64>, pace: &Pace) -> Option<RowStatus> {
        let next = self.rows.next()?;
        self.values.clear();
        self.row.clear();
        self.grid.point(next, &mut self.values);
        self.tally.begin_row();
        cells.extend_from_slice(&self.values);
        let status = match self.template.case(&self.values) {
            Ok(case) => case.row(&mut self.row, &mut self.tally, pace),
            Err(faults) => tell_invalid(faults, &mut self.tally),
        };
        cells.extend(self.kept.iter().map(|&i| self.row.get(i).copied().unwrap_or(f64::NAN)));
        Some(status)
    }

    /// What is to be said at the end.
    pub(super) fn end(&mut self) -> FoundGrid {
        let assumed = self.template.assumed().map(<[Assumption]>::to_vec);
        let mut warnings = std::mem::take(&mut self.tally).into_warnings();
        warnings.extend(of_assumptions(assumed.as_deref().unwrap_or_default()));
        FoundGrid { rows: self.grid.len(), warnings, assumed }
    }
}
