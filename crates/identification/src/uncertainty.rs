//! How certain are the estimates, and in which directions do the data say nothing?
//!
//! The derivatives J of the weighted residuals at the solution, with columns scaled to length one, are decomposed into
//! singular values. A direction whose singular value is 1e-7 of the largest or less is dead: along it the data do not change
//! but for the rounding of the derivatives. Standard errors are those of the linearised problem, P Σ Pᵀ with P the
//! pseudo-inverse of J: where standard deviations are given, one factor common to all residuals is estimated from them;
//! where none are given, the variance of each column of measurements is estimated by itself, since nothing says that a torque
//! is measured as well as a force (Huber 1967, White 1980). Degrees of freedom follow from the trace of the projection, and for
//! a sum of several variances from Welch (1947) and Satterthwaite (1946). Under a robust loss ψ(u)/mean ψ' stands for the
//! residual (Huber 1981).

use nalgebra::{DMatrix, DVector};

use crate::loss::Loss;
use crate::student::quantile_95;

/// Share of the largest singular value at which a direction counts as dead; the derivatives keep nine digits or more.
const DEAD: f64 = 1e-7;

/// Component of a dead direction, of length one, from which on an unknown counts as part of it.
const PART: f64 = 1e-3;

/// Mean of ψ' below which nearly all residuals are outliers and no error can be stated.
const LEAST_CURVATURE: f64 = 0.05;

/// What the derivatives at the solution tell, on the scaled unknowns.
#[derive(Debug, Clone)]
pub(crate) struct Uncertainty {
    /// Standard error of every scaled unknown; none where it is part of a dead direction, or no freedom is left.
    pub(crate) standard_error: Vec<Option<f64>>,
    /// Half of the interval of 95 %, on the same scale.
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
    pub(crate) freedom: f64,
    /// Sum of squared weighted residuals over the degrees of freedom, if there are any.
    pub(crate) reduced_chi_square: Option<f64>,
}

/// What the uncertainty is found from.
pub(crate) struct Evidence<'a> {
    /// Derivatives of the weighted residuals by the scaled unknowns.
    pub(crate) jacobian: &'a DMatrix<f64>,
    /// Weighted residuals.
    pub(crate) residuals: &'a DVector<f64>,
    /// Rows that are measurements; the others are zeros.
    pub(crate) measured: usize,
    /// Rows of one group, which share a variance.
    pub(crate) group: usize,
    /// Change of every scaled unknown that would matter.
    pub(crate) useful: &'a [f64],
    pub(crate) loss: Loss,
}

/// Change of the weighted residuals, as a root mean square, that counts as none.
const NO_EFFECT: f64 = 1e-9;

impl Uncertainty {
    pub(crate) fn of(evidence: &Evidence<'_>) -> Self {
        let Evidence { jacobian, residuals, measured, group, useful, loss } = *evidence;
        let count = jacobian.ncols();
        let norms: Vec<f64> = jacobian.column_iter().map(|column| column.norm()).collect();
        let without_effect: Vec<bool> =
            norms.iter().zip(useful).map(|(norm, width)| norm * width <= NO_EFFECT * (measured as f64).sqrt()).collect();
        let mut normalised = jacobian.clone();
        for (i, mut column) in normalised.column_iter_mut().enumerate() {
            if without_effect[i] { column.fill(0.0) } else { column.unscale_mut(norms[i]) }
        }
        // J = Q R and R = U S Vᵀ: the large factor is decomposed once, the iteration works on the small one.
        let qr = normalised.clone().qr();
        let svd = qr.r().svd(false, true);
        let right = svd.v_t.unwrap_or_else(|| DMatrix::identity(count, count));
        let largest = svd.singular_values.max();
        let alive = |i: usize| largest > 0.0 && svd.singular_values[i] > DEAD * largest;
        let dead_directions: Vec<DVector<f64>> = (0..count).filter(|&i| !alive(i)).map(|i| right.row(i).transpose()).collect();
        let smallest = svd.singular_values.min();
        let condition_number = if dead_directions.is_empty() { largest / smallest } else { f64::INFINITY };

        // P = V S⁻² Vᵀ Jᵀ over the directions alive, on unknowns scaled by their effect.
        let mut inverse = DMatrix::zeros(count, count);
        for i in (0..count).filter(|&i| alive(i)) {
            let direction = right.row(i).transpose();
            inverse += &direction * direction.transpose() / svd.singular_values[i].powi(2);
        }
        let pseudo_inverse = &inverse * normalised.transpose();
        let rank = count - dead_directions.len();
        let freedom = measured as f64 - rank as f64;
        let mean_curvature =
            residuals.iter().take(measured).map(|&residual| loss.curvature(residual)).sum::<f64>() / measured as f64;
        let score = |row: usize| loss.influence(residuals[row]) / mean_curvature;

        // The covariance, group by group of residuals with one variance.
        let groups: Vec<std::ops::Range<usize>> =
            (0..measured).step_by(group.max(1)).map(|from| from..(from + group).min(measured)).collect();
        let pooled = (0..measured).map(|row| score(row).powi(2)).sum::<f64>() / freedom.max(1.0);
        let mut parts: Vec<(DMatrix<f64>, f64)> = Vec::with_capacity(groups.len());
        for rows in groups {
            let block = pseudo_inverse.columns_range(rows.clone());
            let leverage: f64 = rows.clone().map(|row| normalised.row(row).transpose().dot(&pseudo_inverse.column(row))).sum();
            let own_freedom = rows.len() as f64 - leverage;
            let squares: f64 = rows.map(|row| score(row).powi(2)).sum();
            // A group with less than one degree of freedom left has no variance of its own to show.
            let (variance, own_freedom) =
                if own_freedom >= 1.0 { (squares / own_freedom, own_freedom) } else { (pooled, freedom.max(1.0)) };
            parts.push((block * block.transpose() * variance, own_freedom));
        }
        let mut covariance = DMatrix::zeros(count, count);
        parts.iter().for_each(|(part, _)| covariance += part);

        let stated = |i: usize| {
            let dead = without_effect[i] || dead_directions.iter().any(|direction| direction[i].abs() > PART);
            !dead && freedom >= 1.0 && mean_curvature > LEAST_CURVATURE
        };
        let effect = |i: usize| if norms[i] > 0.0 { norms[i] } else { 1.0 };
        let standard_error: Vec<Option<f64>> =
            (0..count).map(|i| stated(i).then(|| covariance[(i, i)].max(0.0).sqrt() / effect(i))).collect();
        let half_width = (0..count)
            .map(|i| {
                let squares: f64 = parts.iter().map(|(part, freedom)| part[(i, i)].powi(2) / freedom).sum();
                let own = if squares > 0.0 { covariance[(i, i)].powi(2) / squares } else { freedom };
                standard_error[i].map(|error| error * quantile_95(own.min(freedom)))
            })
            .collect();
        let correlation = (0..count)
            .map(|i| (0..count).map(|k| correlation(&covariance, i, k).filter(|_| stated(i) && stated(k))).collect())
            .collect();
        let squares: f64 = residuals.iter().take(measured).map(|residual| residual * residual).sum();
        let reduced_chi_square = (freedom >= 1.0).then(|| squares / freedom);
        Self {
            standard_error,
            half_width,
            correlation,
            condition_number,
            dead_directions,
            without_effect,
            freedom,
            reduced_chi_square,
        }
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

/// Correlation of two estimates; where both are certain to the last digit it has no meaning but for an unknown with itself.
fn correlation(covariance: &DMatrix<f64>, i: usize, k: usize) -> Option<f64> {
    if i == k {
        return Some(1.0);
    }
    let ratio = covariance[(i, k)] / (covariance[(i, i)].sqrt() * covariance[(k, k)].sqrt());
    // Rounding may carry it beyond one by its last digit.
    ratio.is_finite().then(|| ratio.clamp(-1.0, 1.0))
}
