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
        has_size(&matrix, matrix.len())?;
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

/// Whether a matrix has a row and a column for each of so many inputs.
///
/// # Errors
/// [`CorrelationError::Size`] where it has not.
pub fn has_size(matrix: &[Vec<f64>], inputs: usize) -> Result<(), CorrelationError> {
    if matrix.len() != inputs {
        return Err(CorrelationError::Size { expected: inputs, found: matrix.len(), row: None });
    }
    match matrix.iter().position(|row| row.len() != inputs) {
        Some(row) => Err(CorrelationError::Size { expected: inputs, found: matrix[row].len(), row: Some(row) }),
        None => Ok(()),
    }
}

/// Why a matrix is not positive definite of which that row is the first that contradicts those above it: the fewest coefficients that
/// do.
fn contradiction(matrix: &[Vec<f64>], row: usize) -> CorrelationError {
    let of = &matrix[row];
    if let Some(column) = of[..row].iter().position(|coefficient| 1.0 - coefficient * coefficient <= LEAST_PIVOT) {
        return CorrelationError::One { row, column };
    }
    // Of three inputs the third coefficient is the product of the others, but for the product of what these leave open.
    for third in 0..row {
        for column in (0..row).filter(|column| *column != third) {
            let (one, other) = (of[third], matrix[column][third]);
            let (middle, width) = (one * other, ((1.0 - one * one) * (1.0 - other * other)).sqrt());
            if (of[column] - middle).abs() >= width {
                return CorrelationError::Contradiction { row, column, third, range: [middle - width, middle + width] };
            }
        }
    }
    CorrelationError::NotPositiveDefinite { row }
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
                return Err(contradiction(matrix, row));
            };
        }
    }
    Ok(factor)
}
