//! The search from one start: Levenberg–Marquardt within bounds.
//!
//! An active set around the unbounded method keeps the bounds. Unknowns at a bound that the data push outward are held; the
//! others are fitted, and put back to a bound where a step crosses it. This is repeated until neither the values nor the set of
//! held unknowns changes. A transform that maps the bounds to infinity would be shorter, but its derivative vanishes at a
//! bound: a start there could never leave, and an estimate there, such as the cohesion of dry sand, would be approached for
//! ever.

use std::cell::Cell;

use levenberg_marquardt::{LeastSquaresProblem, LevenbergMarquardt, TerminationReason};
use nalgebra::{DMatrix, DVector, Dyn, Owned};

use crate::obstacle::Obstacle;
use crate::problem::Problem;
use crate::range::LARGEST;

/// Why a search ended.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum StopReason {
    /// No step makes the sum of the losses smaller by more than rounding.
    NoFurtherDecrease,
    /// Steps became as small as rounding.
    SmallStep,
    /// The residuals are orthogonal to every direction in which the unknowns can move.
    Stationary,
    /// The model meets the data exactly.
    ExactFit,
    /// The evaluations or the time were spent before the search ended.
    Budget,
    /// The search could go on, but the model has no answer at any next step.
    ModelRefuses,
    /// Numbers overflowed.
    NotFinite,
}

impl StopReason {
    /// Whether the search ended at a minimum.
    #[must_use]
    pub fn is_success(self) -> bool {
        matches!(self, Self::NoFurtherDecrease | Self::SmallStep | Self::Stationary | Self::ExactFit)
    }
}

/// Where a search ended.
#[derive(Debug, Clone)]
pub(crate) struct Found {
    pub(crate) values: Vec<f64>,
    /// Sum of the losses.
    pub(crate) cost: f64,
    pub(crate) stop: StopReason,
    /// Steps for which derivatives were taken.
    pub(crate) iterations: u32,
}

/// Rounds of the active set.
const ROUNDS: u32 = 12;

/// Relative decrease and relative step at which a search ends.
const TOLERANCE: f64 = 1e-14;

/// Share of the scale of a residual's derivative below which it does not push.
const PUSH: f64 = 1e-12;

/// A search that the model stopped is not at a minimum if the cosine between residuals and a derivative is above this.
const UPHILL: f64 = 1e-6;

/// Relative decrease and step at which a refit near a minimum ends. It finds a rise of the cost of a few percent to a few
/// percent of that rise.
const ROUGHLY: f64 = 1e-4;

/// The minimum that is reached from `start`.
pub(crate) fn from_start(problem: &Problem<'_>, start: &[f64]) -> Result<Found, Obstacle> {
    minimum(problem, start, ROUNDS, TOLERANCE)
}

/// The approximate cost of the minimum that is reached from `start`; the cost at the start where the search fails.
pub(crate) fn refitted_cost(problem: &Problem<'_>, start: &[f64]) -> Result<f64, Obstacle> {
    let found = minimum(problem, start, 1, ROUGHLY)?;
    if found.stop == StopReason::Budget && problem.is_spent() { Err(Obstacle::Budget) } else { Ok(found.cost) }
}

fn minimum(problem: &Problem<'_>, start: &[f64], rounds: u32, tolerance: f64) -> Result<Found, Obstacle> {
    let mut values = start.to_vec();
    let mut cost = problem.cost_at(&values)?;
    let mut iterations = 0;
    let mut held_before: Option<Vec<usize>> = None;
    let mut stop = StopReason::Budget;
    for _ in 0..rounds {
        let free = match free_unknowns(problem, &values) {
            Ok(free) => free,
            Err(obstacle) => {
                stop = stop_of(obstacle);
                break;
            }
        };
        let unchanged = held_before.as_ref() == Some(&free);
        if free.is_empty() {
            stop = StopReason::Stationary;
            break;
        }
        let adapter = Adapter {
            problem,
            free: &free,
            values: values.clone(),
            point: DVector::from_iterator(free.len(), free.iter().map(|&i| problem.scaled(&values)[i])),
            obstacle: Cell::new(None),
            refused: Cell::new(false),
            iterations: Cell::new(0),
        };
        let search = LevenbergMarquardt::new().with_ftol(tolerance).with_xtol(tolerance).with_patience(60).with_stepbound(10.0);
        let (adapter, report) = search.minimize(adapter);
        let reached = adapter.current();
        iterations += adapter.iterations.get();
        stop = reason(&report.termination, adapter.obstacle.get());
        if stop.is_success() && adapter.refused.get() && adapter.steepness().is_some_and(|cosine| cosine > UPHILL) {
            stop = StopReason::ModelRefuses;
        }
        let reached_cost = match problem.cost_at(&reached) {
            Ok(cost) => cost,
            Err(Obstacle::Budget) => {
                stop = StopReason::Budget;
                break;
            }
            Err(_) => break,
        };
        let improved = reached_cost < cost * (1.0 - 1e-9);
        if reached_cost <= cost {
            (values, cost) = (reached, reached_cost);
        }
        if !stop.is_success() || (unchanged && !improved) {
            break;
        }
        held_before = Some(free);
    }
    Ok(Found { values, cost, stop, iterations })
}

/// The unknowns that are not at a bound or that the data push away from it.
fn free_unknowns(problem: &Problem<'_>, values: &[f64]) -> Result<Vec<usize>, Obstacle> {
    let all: Vec<usize> = (0..values.len()).collect();
    let at_bound = |i: usize| values[i] <= problem.sought[i].bounds.lower || values[i] >= problem.sought[i].bounds.upper;
    if !all.iter().any(|&i| at_bound(i)) {
        return Ok(all);
    }
    let base = problem.predictions(values)?;
    let residuals = problem.weighted(&base)?;
    let jacobian = problem.jacobian(values, &base, &all)?;
    let influence = residuals.map(|residual| problem.loss.influence(residual));
    let scale = influence.norm();
    let pushed_off = |i: usize| {
        let column = jacobian.column(i);
        let descent = -column.dot(&influence);
        let inward = if values[i] <= problem.sought[i].bounds.lower { descent } else { -descent };
        inward > PUSH * column.norm() * scale
    };
    Ok(all.into_iter().filter(|&i| !at_bound(i) || pushed_off(i)).collect())
}

fn stop_of(obstacle: Obstacle) -> StopReason {
    match obstacle {
        Obstacle::Budget => StopReason::Budget,
        Obstacle::Row { .. } | Obstacle::Values => StopReason::ModelRefuses,
    }
}

fn reason(termination: &TerminationReason, obstacle: Option<Obstacle>) -> StopReason {
    match termination {
        TerminationReason::ResidualsZero => StopReason::ExactFit,
        TerminationReason::Orthogonal => StopReason::Stationary,
        TerminationReason::Converged { ftol: true, .. } => StopReason::NoFurtherDecrease,
        TerminationReason::Converged { ftol: false, .. } => StopReason::SmallStep,
        // These tests passed to rounding but not to the tolerance, which is some tens of roundings.
        TerminationReason::NoImprovementPossible(_) => StopReason::NoFurtherDecrease,
        TerminationReason::LostPatience => StopReason::Budget,
        TerminationReason::User(_) => obstacle.map_or(StopReason::ModelRefuses, stop_of),
        TerminationReason::Numerical(_)
        | TerminationReason::NoParameters
        | TerminationReason::NoResiduals
        | TerminationReason::WrongDimensions(_) => StopReason::NotFinite,
    }
}

/// The free unknowns as the method moves them.
struct Adapter<'a> {
    problem: &'a Problem<'a>,
    free: &'a [usize],
    /// All values; only those of held unknowns are used.
    values: Vec<f64>,
    /// The free unknowns, scaled, also beyond a bound.
    point: DVector<f64>,
    /// What ended the search, where it was not the method itself.
    obstacle: Cell<Option<Obstacle>>,
    /// Whether the model has refused a step since derivatives were last taken.
    refused: Cell<bool>,
    iterations: Cell<u32>,
}

impl Adapter<'_> {
    /// The values at the current point, within the bounds.
    fn current(&self) -> Vec<f64> {
        let mut values = self.values.clone();
        for (place, &i) in self.free.iter().enumerate() {
            let bounds = self.problem.sought[i].bounds;
            values[i] = self.problem.scales[i].outward(self.point[place]).clamp(bounds.lower, bounds.upper);
        }
        values
    }

    /// The largest cosine between the residuals and a derivative; none without derivatives or without residuals.
    fn steepness(&self) -> Option<f64> {
        let residuals = self.residuals()?;
        let jacobian = self.jacobian()?;
        let cosine = |column: nalgebra::DVectorView<'_, f64>| {
            let scale = column.norm() * residuals.norm();
            if scale > 0.0 { column.dot(&residuals).abs() / scale } else { 0.0 }
        };
        Some(jacobian.column_iter().map(|column| cosine(column.as_view())).fold(0.0, f64::max))
    }

    /// Whether the point lies beyond a bound of the unknown at `place`, where nothing changes any more.
    fn is_beyond(&self, place: usize) -> bool {
        let i = self.free[place];
        let value = self.problem.scales[i].outward(self.point[place]);
        let bounds = self.problem.sought[i].bounds;
        value < bounds.lower || value > bounds.upper
    }
}

impl LeastSquaresProblem<f64, Dyn, Dyn> for Adapter<'_> {
    type ResidualStorage = Owned<f64, Dyn>;
    type JacobianStorage = Owned<f64, Dyn, Dyn>;
    type ParameterStorage = Owned<f64, Dyn>;

    fn set_params(&mut self, x: &DVector<f64>) {
        self.point.copy_from(x);
    }

    fn params(&self) -> DVector<f64> {
        self.point.clone()
    }

    fn residuals(&self) -> Option<DVector<f64>> {
        let predictions = self.problem.predictions(&self.current());
        match predictions.and_then(|predictions| self.problem.weighted(&predictions)) {
            Ok(residuals) => Some(residuals.map(|residual| self.problem.loss.transformed(residual).value)),
            Err(Obstacle::Budget) => {
                self.obstacle.set(Some(Obstacle::Budget));
                None
            }
            Err(Obstacle::Row { .. } | Obstacle::Values) => {
                self.refused.set(true);
                let rows = self.problem.measured_count().max(self.problem.sought.len());
                Some(DVector::from_element(rows, LARGEST)) // so far off that the step is taken back
            }
        }
    }

    fn jacobian(&self) -> Option<DMatrix<f64>> {
        self.iterations.set(self.iterations.get() + 1);
        self.refused.set(false);
        let values = self.current();
        let derivatives = self.problem.predictions(&values).and_then(|base| {
            let residuals = self.problem.weighted(&base)?;
            let mut jacobian = self.problem.jacobian(&values, &base, self.free)?;
            for (row, &residual) in residuals.iter().enumerate() {
                let slope = self.problem.loss.transformed(residual).slope;
                jacobian.row_mut(row).scale_mut(slope);
            }
            for place in 0..self.free.len() {
                if self.is_beyond(place) {
                    jacobian.column_mut(place).fill(0.0);
                }
            }
            Ok(jacobian)
        });
        derivatives.map_err(|obstacle| self.obstacle.set(Some(obstacle))).ok()
    }
}

/// Further starts: points of the additive recurrence of the generalised golden ratio (Roberts 2018), which fill any number of
/// dimensions evenly and are the same in every run.
pub(crate) fn further_start(problem: &Problem<'_>, number: u32) -> Vec<f64> {
    let dimensions = problem.sought.len();
    // The root of x^(d+1) = x + 1, by the fixed point that contracts from anywhere above 1.
    let root = (0..64).fold(2.0_f64, |x, _| (1.0 + x).powf(1.0 / (dimensions as f64 + 1.0)));
    let point = |(i, one): (usize, &crate::problem::Sought)| {
        let share = (0.5 + f64::from(number) * root.powi(-(i as i32 + 1))).fract();
        let range = one.unknown.search_range(&one.bounds);
        let scale = problem.scales[i];
        let (lower, upper) = (scale.inward(range.lower), scale.inward(range.upper));
        scale.outward(lower + share * (upper - lower)).clamp(one.bounds.lower, one.bounds.upper)
    };
    problem.sought.iter().enumerate().map(point).collect()
}
