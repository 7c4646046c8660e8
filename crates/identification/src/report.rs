//! The report on a fit after its search: errors, intervals and what the data leave open.

use terramechanics::Error;

use crate::design;
use crate::error::FitError;
use crate::finding::Judgement;
use crate::fit::Fit;
use crate::fitted_column::FittedColumn;
use crate::observations::{Column, Quantity};
use crate::problem::{Obstacle, Problem};
use crate::search::{Found, StopReason};
use crate::setup::Prediction;
use crate::uncertainty::{Evidence, Scatter, Uncertainty};
use crate::unknown::Unknown;

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
