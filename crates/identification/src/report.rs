//! What is said of a fit once its search is over.

use terramechanics::Error;

use crate::design::{self, DesignGap};
use crate::error::FitError;
use crate::estimate::Estimate;
use crate::finding::Judgement;
use crate::fitted_column::FittedColumn;
use crate::observations::Column;
use crate::obstacle::Obstacle;
use crate::problem::Problem;
use crate::quantity::Quantity;
use crate::search::{Found, StopReason};
use crate::setup::{Prediction, Setup};
use crate::uncertainty::{Evidence, Scatter, Uncertainty};
use crate::unknown::Unknown;

/// The result of a fit.
#[derive(Debug, Clone, PartialEq)]
pub struct Fit {
    /// One per unknown, in the order asked for.
    pub estimates: Vec<Estimate>,
    /// Why the search ended.
    pub stop: StopReason,
    /// Steps of the best search.
    pub iterations: u32,
    /// Evaluations of the forces, over all starts.
    pub evaluations: u64,
    /// Correlation of the estimates; none with one that has no standard error.
    pub correlation: Vec<Vec<Option<f64>>>,
    /// Condition number of the derivatives with columns of length one; infinite where a direction is dead.
    pub condition_number: f64,
    /// Directions in which the data do not change: the share of every unknown, on the scale of its effect.
    pub dead_directions: Vec<Vec<(Unknown, f64)>>,
    /// What the operating points do not vary, with the unknowns that this leaves open.
    pub gaps: Vec<(DesignGap, Vec<Unknown>)>,
    /// Measurements minus determined directions.
    pub degrees_of_freedom: f64,
    /// Sum of squares over the degrees of freedom, where standard deviations were given: about one if they and the model hold.
    pub reduced_chi_square: Option<f64>,
    /// The fitted columns.
    pub columns: Vec<FittedColumn>,
    /// Sinkage of every sample (m).
    pub sinkage: Vec<f64>,
    /// The setup with the estimates.
    pub setup: Setup,
}

impl Fit {
    /// Whether the search ended at a minimum. That alone does not make the estimates unique.
    #[must_use]
    pub fn converged(&self) -> bool {
        self.stop.is_success()
    }

    /// Whether the data determine every unknown.
    #[must_use]
    pub fn is_identifiable(&self) -> bool {
        self.estimates.iter().all(|estimate| estimate.identifiability.is_determined())
    }
}

/// The report on the minimum `best` and on `others` that are as good. The problem has a budget of its own for it.
pub(crate) fn report(problem: &Problem<'_>, best: &Found, others: &[Found]) -> Result<Fit, FitError> {
    let mut stop = best.stop;
    let refused = |obstacle| match obstacle {
        Obstacle::Row { row, error } => FitError::Refused { row, error },
        Obstacle::Values => FitError::Refused { row: 0, error: Error::NotFinite },
        Obstacle::Budget => FitError::OutOfBudget,
    };
    let predictions = problem.predictions(&best.values).map_err(refused)?;
    let residuals = problem.weighted(&predictions).map_err(refused)?;
    let all: Vec<usize> = (0..problem.sought.len()).collect();
    let setup = problem.setup_at(&best.values);
    let useful: Vec<f64> = problem
        .sought
        .iter()
        .enumerate()
        .map(|(i, one)| {
            let value = best.values[i];
            one.unknown.useful_width(value, &setup) / problem.scales[i].slope(value).abs().max(f64::MIN_POSITIVE)
        })
        .collect();
    let known = problem.jacobian(&best.values, &predictions, &all).and_then(|jacobian| {
        let evidence = Evidence {
            jacobian: &jacobian,
            residuals: &residuals,
            measured: problem.measured_count(),
            scatter: if problem.has_deviations() { Scatter::Common } else { Scatter::ByRow },
            useful: &useful,
            loss: problem.loss,
        };
        Uncertainty::of(&evidence, problem.consent)
    });
    let uncertainty = match known {
        Ok(known) => Some(known),
        Err(obstacle) => {
            stop = if obstacle == Obstacle::Budget { StopReason::Budget } else { StopReason::ModelRefuses };
            None
        }
    };
    let names: Vec<Unknown> = problem.sought.iter().map(|one| one.unknown).collect();
    let gaps = design::gaps(problem.observations, &problem.fitted, &names, &predictions);
    let judged = Judgement { problem, best, others, uncertainty: uncertainty.as_ref(), gaps: &gaps, useful: &useful };
    let estimates = all.iter().map(|&i| judged.estimate(i)).collect();
    if problem.is_spent() {
        stop = StopReason::Budget; // what was not looked at counts as not determined
    }
    let nothing = || vec![vec![None; all.len()]; all.len()];
    Ok(Fit {
        estimates,
        stop,
        iterations: best.iterations,
        evaluations: problem.evaluations(),
        correlation: uncertainty.as_ref().map_or_else(nothing, |known| known.correlation.clone()),
        condition_number: uncertainty.as_ref().map_or(f64::INFINITY, |known| known.condition_number),
        dead_directions: uncertainty.as_ref().map_or_else(Vec::new, |known| {
            known.dead_directions.iter().map(|direction| names.iter().copied().zip(direction.iter().copied()).collect()).collect()
        }),
        gaps,
        degrees_of_freedom: uncertainty.as_ref().map_or(0.0, |known| known.degrees_of_freedom),
        reduced_chi_square: uncertainty.as_ref().and_then(|known| known.reduced_chi_square).filter(|_| problem.has_deviations()),
        columns: problem
            .fitted
            .iter()
            .filter_map(|&quantity| Some(fitted_column(quantity, problem.observations.column(quantity)?, &predictions)))
            .collect(),
        sinkage: predictions.iter().map(|prediction| prediction.sinkage).collect(),
        setup,
    })
}

fn fitted_column(quantity: Quantity, column: &Column, predictions: &[Prediction]) -> FittedColumn {
    let predicted = predictions.iter().map(|prediction| quantity.of(prediction)).collect();
    FittedColumn::new(quantity, column.values.clone(), predicted)
}
