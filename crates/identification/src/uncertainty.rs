//! How certain are the estimates, and in which directions do the data say nothing?
//!
//! The derivatives J of the weighted residuals at the solution, with columns scaled to length one, are decomposed into singular
//! values. A direction is dead if its singular value is at most 1e-7 of the largest: along it the predictions change only by
//! the rounding of the derivatives.
//!
//! Standard errors are those of the linearised problem, P Σ Pᵀ with P the pseudo-inverse of J. Where standard deviations are
//! given, the residuals determine one common factor for all of them. Where none are given, each residual divided by one minus
//! its leverage stands for its own deviation (White 1980; MacKinnon & White 1985, HC3), because a torque may not be measured as
//! well as a force, nor a large force as well as a small one. The degrees of freedom are the measurements minus the directions
//! that they determine. With a robust loss, ψ(u)/mean ψ' takes the place of the residual (Huber 1981).

use nalgebra::{DMatrix, DVector, Dyn, SVD};

use crate::consent::{Consent, POINTS_PER_QUESTION, Stopped};
use crate::loss::Loss;
use crate::obstacle::Obstacle;
use crate::range::{finite, is_summable};
use crate::student::quantile_95;

/// Share of the largest singular value at which a direction counts as dead; the derivatives keep nine digits or more.
const DEAD: f64 = 1e-7;

/// Least component of an unknown in a dead direction of length one for the unknown to count as part of it.
const PART: f64 = 1e-3;

/// Mean of ψ' below which nearly all residuals are outliers and no error can be stated.
const LEAST_CURVATURE: f64 = 0.05;

/// Errors and dead directions at the solution, on the scaled unknowns.
#[derive(Debug, Clone)]
pub(crate) struct Uncertainty {
    /// Standard error of every scaled unknown; none for part of a dead direction, or without degrees of freedom.
    pub(crate) standard_error: Vec<Option<f64>>,
    /// Half the width of the 95 % interval, on the same scale.
    pub(crate) half_width: Vec<Option<f64>>,
    /// Correlation of the estimates; none with an unknown that has no standard error.
    pub(crate) correlation: Vec<Vec<Option<f64>>>,
    /// Largest over smallest singular value of J with columns of length one; infinite where a direction is dead.
    pub(crate) condition_number: f64,
    /// Dead directions, of length one, on unknowns scaled by their effect on the data.
    pub(crate) dead_directions: Vec<DVector<f64>>,
    /// Unknowns that do not change the data at all.
    pub(crate) without_effect: Vec<bool>,
    /// Measurements minus the directions that they determine.
    pub(crate) degrees_of_freedom: f64,
    /// Sum of squared weighted residuals over the degrees of freedom, if there are any.
    pub(crate) reduced_chi_square: Option<f64>,
    /// (JᵀJ)⁻¹ on the scaled unknowns, without the dead directions.
    inverse: DMatrix<f64>,
    /// Mean of ψ', which is 1 for least squares.
    mean_curvature: f64,
}

/// What is assumed about the errors of the rows.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum Scatter {
    /// Weighted, they have one variance.
    Common,
    /// Each row has a variance of its own.
    ByRow,
    /// Whichever of the two makes an estimate less certain: where only a few rows determine an unknown, their residuals may be
    /// small by chance.
    Either,
}

/// Leverage above which a row has no residual of its own: the fit passes through it whatever its value.
const ALL_LEVERAGE: f64 = 0.99;

/// What the uncertainty is found from.
pub(crate) struct Evidence<'a> {
    /// Derivatives of the weighted residuals by the scaled unknowns.
    pub(crate) jacobian: &'a DMatrix<f64>,
    /// Weighted residuals.
    pub(crate) residuals: &'a DVector<f64>,
    /// Rows that are measurements; the others are zeros.
    pub(crate) measured: usize,
    pub(crate) scatter: Scatter,
    /// Change of every scaled unknown that would matter.
    pub(crate) useful: &'a [f64],
    pub(crate) loss: Loss,
}

/// Change of the weighted residuals (root mean square) that counts as no effect.
const NO_EFFECT: f64 = 1e-9;

/// Steps of the decomposition into singular values; each value takes two or three.
const DECOMPOSITION_STEPS: usize = 500;

impl Uncertainty {
    /// # Errors
    /// [`Obstacle::Values`] where a derivative or a residual leaves the range of numbers or their decomposition does not end;
    /// [`Obstacle::Budget`] where the caller does not want to go on.
    pub(crate) fn of(evidence: &Evidence<'_>, consent: &Consent<'_>) -> Result<Self, Obstacle> {
        let Evidence { jacobian, residuals, measured, scatter, useful, loss } = *evidence;
        let count = jacobian.ncols();
        if !jacobian.iter().chain(residuals.iter()).all(|&value| is_summable(value)) {
            return Err(Obstacle::Values);
        }
        let norms: Vec<f64> = jacobian.column_iter().map(|column| column.norm()).collect();
        let without_effect: Vec<bool> = norms
            .iter()
            .zip(useful)
            .map(|(&norm, width)| norm == 0.0 || norm * width <= NO_EFFECT * (measured as f64).sqrt())
            .collect();
        let mut normalised = jacobian.clone();
        for (i, mut column) in normalised.column_iter_mut().enumerate() {
            if without_effect[i] { column.fill(0.0) } else { column.unscale_mut(norms[i]) }
        }
        // J = Q R and R = U S Vᵀ: the large factor is decomposed once, the iteration works on the small one.
        let svd = singular_values(triangular_factor(&normalised, consent)?).ok_or(Obstacle::Values)?;
        let right = svd.v_t.unwrap_or_else(|| DMatrix::identity(count, count));
        let largest = svd.singular_values.max();
        let alive = |i: usize| largest > 0.0 && svd.singular_values[i] > DEAD * largest;
        let dead_directions: Vec<DVector<f64>> = (0..count).filter(|&i| !alive(i)).map(|i| right.row(i).transpose()).collect();
        let smallest = svd.singular_values.min();
        let condition_number = if dead_directions.is_empty() { largest / smallest } else { f64::INFINITY };

        // (JᵀJ)⁻¹ = V S⁻² Vᵀ without the dead directions, on unknowns scaled by their effect; P = (JᵀJ)⁻¹ Jᵀ.
        let mut inverse = DMatrix::zeros(count, count);
        for i in (0..count).filter(|&i| alive(i)) {
            let direction = right.row(i).transpose();
            inverse += &direction * direction.transpose() / svd.singular_values[i].powi(2);
        }
        let rank = count - dead_directions.len();
        let freedom = measured as f64 - rank as f64;
        let mean_curvature =
            residuals.iter().take(measured).map(|&residual| loss.curvature(residual)).sum::<f64>() / measured as f64;
        let score = |row: usize| loss.influence(residuals[row]) / mean_curvature;

        let pooled = (0..measured).map(|row| score(row).powi(2)).sum::<f64>() / freedom.max(1.0);
        let covariance_by = |variance_of: &dyn Fn(usize, f64) -> f64| {
            let mut covariance = DMatrix::zeros(count, count);
            for (first, rows) in blocks(&normalised) {
                consent.ask()?;
                let pseudo_inverse = &inverse * rows.transpose();
                for row in 0..rows.nrows().min(measured.saturating_sub(first)) {
                    let column = pseudo_inverse.column(row);
                    let leverage = rows.row(row).transpose().dot(&column);
                    covariance.ger(variance_of(first + row, leverage), &column, &column, 1.0);
                }
            }
            Ok::<_, Stopped>(covariance)
        };
        let common = |_: usize, _: f64| pooled;
        let own = |row: usize, leverage: f64| {
            if leverage < ALL_LEVERAGE { (score(row) / (1.0 - leverage)).powi(2) } else { pooled }
        };
        let covariance = match scatter {
            Scatter::Common => covariance_by(&common)?,
            Scatter::ByRow => covariance_by(&own)?,
            Scatter::Either => {
                let (alike, by_row) = (covariance_by(&common)?, covariance_by(&own)?);
                let larger: Vec<f64> = (0..count).map(|i| (by_row[(i, i)] / alike[(i, i)]).max(1.0).sqrt()).collect();
                DMatrix::from_fn(count, count, |i, k| alike[(i, k)] * larger[i] * larger[k])
            }
        };

        let stated = |i: usize| {
            let dead = without_effect[i] || dead_directions.iter().any(|direction| direction[i].abs() > PART);
            !dead && freedom >= 1.0 && mean_curvature > LEAST_CURVATURE
        };
        let effect = |i: usize| if norms[i] > 0.0 { norms[i] } else { 1.0 };
        // A variance that overflowed or underflowed is not a variance of 0.
        let error = |i: usize| finite(covariance[(i, i)]).and_then(|variance| finite(variance.max(0.0).sqrt() / effect(i)));
        let standard_error: Vec<Option<f64>> = (0..count).map(|i| error(i).filter(|_| stated(i))).collect();
        let factor = quantile_95(freedom);
        let half_width = standard_error.iter().map(|error| error.and_then(|error| finite(factor * error))).collect();
        let correlation = (0..count)
            .map(|i| (0..count).map(|k| correlation(&covariance, i, k).filter(|_| stated(i) && stated(k))).collect())
            .collect();
        let squares: f64 = residuals.iter().take(measured).map(|residual| residual * residual).sum();
        let reduced_chi_square = (freedom >= 1.0).then(|| squares / freedom);
        Ok(Self {
            standard_error,
            half_width,
            correlation,
            condition_number,
            dead_directions,
            without_effect,
            degrees_of_freedom: freedom,
            reduced_chi_square,
            inverse: DMatrix::from_fn(count, count, |i, k| inverse[(i, k)] / (effect(i) * effect(k))),
            mean_curvature,
        })
    }

    /// Rise of the cost at `distance` of the scaled unknown `i`, with the others refitted, if the cost were a parabola.
    pub(crate) fn presumed_rise(&self, i: usize, distance: f64) -> f64 {
        self.mean_curvature * distance * distance / self.inverse[(i, i)]
    }

    /// How the scaled unknown `k` follows `i` along the bottom of that parabola.
    pub(crate) fn along_the_valley(&self, i: usize, k: usize) -> f64 {
        if i == k { 1.0 } else { self.inverse[(i, k)] / self.inverse[(i, i)] }
    }

    /// The other unknowns that a dead direction moves together with `i`.
    pub(crate) fn moved_with(&self, i: usize) -> Vec<usize> {
        let directions = self.dead_directions.iter().filter(|direction| direction[i].abs() > PART);
        let mut others: Vec<usize> =
            directions.flat_map(|direction| (0..direction.len()).filter(move |&k| k != i && direction[k].abs() > 0.05)).collect();
        others.sort_unstable();
        others.dedup();
        others
    }

    /// Whether a dead direction moves `i`.
    pub(crate) fn is_dead(&self, i: usize) -> bool {
        self.dead_directions.iter().any(|direction| direction[i].abs() > PART)
    }
}

/// The rows of a matrix in blocks, each with the number of its first row.
fn blocks(matrix: &DMatrix<f64>) -> impl Iterator<Item = (usize, nalgebra::DMatrixView<'_, f64>)> {
    let rows = matrix.nrows();
    let block = move |first: usize| (first, matrix.rows(first, POINTS_PER_QUESTION.min(rows - first)));
    (0..rows).step_by(POINTS_PER_QUESTION).map(block)
}

/// R of J = Q R, block by block: R of the rows so far takes up the next ones.
fn triangular_factor(matrix: &DMatrix<f64>, consent: &Consent<'_>) -> Result<DMatrix<f64>, Stopped> {
    let count = matrix.ncols();
    let mut factor = DMatrix::zeros(0, count);
    for (_, rows) in blocks(matrix) {
        consent.ask()?;
        let above = factor.nrows();
        let mut stacked = factor.insert_rows(above, rows.nrows(), 0.0);
        stacked.rows_mut(above, rows.nrows()).copy_from(&rows);
        factor = stacked.qr().r();
    }
    Ok(factor)
}

/// S and V of a matrix of finite numbers, in falling order; none where the iteration does not end within the steps.
fn singular_values(matrix: DMatrix<f64>) -> Option<SVD<f64, Dyn, Dyn>> {
    // The tolerance of nalgebra's own `svd`, which does not limit its steps.
    let mut svd = SVD::try_new_unordered(matrix, false, true, 5.0 * f64::EPSILON, DECOMPOSITION_STEPS)?;
    if !svd.singular_values.iter().all(|value| value.is_finite()) {
        return None;
    }
    svd.sort_by_singular_values();
    Some(svd)
}

/// Correlation of two estimates. Where both are certain to the last digit it is defined only for an unknown with itself.
fn correlation(covariance: &DMatrix<f64>, i: usize, k: usize) -> Option<f64> {
    if i == k {
        return Some(1.0);
    }
    let ratio = covariance[(i, k)] / (covariance[(i, i)].sqrt() * covariance[(k, k)].sqrt());
    // Rounding may push it beyond one in the last digit.
    ratio.is_finite().then(|| ratio.clamp(-1.0, 1.0))
}
