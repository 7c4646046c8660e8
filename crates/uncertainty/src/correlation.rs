//! Correlation of inputs by a Gaussian copula.

use crate::error::CorrelationError;

/// A pivot of the factorisation below which a matrix counts as singular.
const LEAST_PIVOT: f64 = 1e-12;

/// Correlation of inputs.
///
/// The coefficients are those of normal scores. Each input x has the score z = Φ⁻¹(F(x)), where F is its own distribution; the scores
/// of all inputs are normal together, with these coefficients. Every input keeps its distribution whatever the coefficients are.
///
/// For two normal inputs a coefficient is the usual one of the numbers themselves. For others it is not: lognormal, uniform or
/// triangular numbers have a smaller one in size, because a straight line no longer joins them. The rank correlation is
/// (6/π) asin(ρ/2) for all. A distribution cut off at a bound takes its scores within what is left.
#[derive(Debug, Clone, PartialEq)]
pub struct Correlation {
    matrix: Vec<Vec<f64>>,
    /// L, lower triangular, with L Lᵀ = the matrix.
    factor: Vec<Vec<f64>>,
}

impl Correlation {
    /// By the matrix of the coefficients.
    ///
    /// # Errors
    /// A matrix that is not square, symmetric, with 1 on the diagonal, and positive definite.
    pub fn new(matrix: Vec<Vec<f64>>) -> Result<Self, CorrelationError> {
        let count = matrix.len();
        if matrix.iter().any(|row| row.len() != count) {
            return Err(CorrelationError::Size { expected: count });
        }
        for (row, coefficients) in matrix.iter().enumerate() {
            for (column, coefficient) in coefficients.iter().enumerate() {
                if !(-1.0..=1.0).contains(coefficient) {
                    return Err(CorrelationError::Coefficient { row, column });
                }
                if row == column && *coefficient != 1.0 {
                    return Err(CorrelationError::Diagonal { row });
                }
                if *coefficient != matrix[column][row] {
                    return Err(CorrelationError::Asymmetric { row, column });
                }
            }
        }
        let factor = cholesky(&matrix)?;
        Ok(Self { matrix, factor })
    }

    /// How many inputs it is of.
    pub(crate) fn len(&self) -> usize {
        self.matrix.len()
    }

    /// Whether two different inputs are correlated.
    pub(crate) fn joins(&self, one: usize, other: usize) -> bool {
        one != other && self.matrix[one][other] != 0.0
    }

    /// Whether an input is correlated with any other.
    pub(crate) fn is_of(&self, input: usize) -> bool {
        (0..self.len()).any(|other| self.joins(input, other))
    }

    /// The score of an input from the independent scores of all.
    pub(crate) fn score(&self, input: usize, independent: &[f64]) -> f64 {
        self.factor[input].iter().zip(independent).map(|(weight, score)| weight * score).sum()
    }
}

/// The Cholesky factor. Where two groups of inputs are not joined in the matrix they are not in the factor either.
fn cholesky(matrix: &[Vec<f64>]) -> Result<Vec<Vec<f64>>, CorrelationError> {
    let count = matrix.len();
    let mut factor = vec![vec![0.0; count]; count];
    for row in 0..count {
        for column in 0..=row {
            let known: f64 = (0..column).map(|i| factor[row][i] * factor[column][i]).sum();
            let rest = matrix[row][column] - known;
            factor[row][column] = if row != column {
                rest / factor[column][column]
            } else if rest > LEAST_PIVOT {
                rest.sqrt()
            } else {
                return Err(CorrelationError::NotPositiveDefinite { row });
            };
        }
    }
    Ok(factor)
}
