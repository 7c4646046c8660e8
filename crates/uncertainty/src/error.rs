//! Why inputs, correlation or design are refused, as data.

use std::fmt;

use crate::bounds::Bounds;

/// What is wrong with the distribution of an input.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum InputError {
    /// A parameter that is not finite.
    NotFinite,
    /// A deviation that is not positive.
    Deviation {
        /// What it is.
        deviation: f64,
    },
    /// The mean of a lognormal distribution that is not positive.
    Mean {
        /// What it is.
        mean: f64,
    },
    /// A lower end that is not below the upper one.
    Ends {
        /// Lower end.
        low: f64,
        /// Upper end.
        high: f64,
    },
    /// A mode outside the ends.
    Mode {
        /// What it is.
        mode: f64,
    },
    /// Quantiles that do not ascend.
    Order {
        /// The first that is below the one before.
        row: usize,
    },
    /// Too few or too many values.
    Count {
        /// How many there are.
        count: usize,
    },
    /// A distribution so wide that its values are not finite.
    TooWide,
    /// Ends beyond the bounds of the input.
    Outside {
        /// Lower end.
        low: f64,
        /// Upper end.
        high: f64,
        /// What the input may be.
        bounds: Bounds,
    },
    /// More of the distribution is outside the bounds of the input than can be cut off.
    MostlyOutside {
        /// Share outside.
        share: f64,
        /// What the input may be.
        bounds: Bounds,
    },
    /// Columns of joint values of different length.
    Lengths {
        /// The first column of another length than the first.
        column: usize,
    },
}

/// What is wrong with a correlation matrix.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum CorrelationError {
    /// Not a row and a column for every input.
    Size {
        /// How many it should have.
        expected: usize,
        /// How many rows it has, or how many coefficients that row has.
        found: usize,
        /// The first row of another length, where there are as many rows as inputs.
        row: Option<usize>,
    },
    /// A coefficient that is not between −1 and 1.
    Coefficient {
        /// Its row.
        row: usize,
        /// Its column.
        column: usize,
    },
    /// A coefficient of an input with itself that is not 1.
    Diagonal {
        /// Its row and column.
        row: usize,
    },
    /// Two coefficients of the same two inputs that differ.
    Asymmetric {
        /// Row of the one and column of the other.
        row: usize,
        /// Column of the one and row of the other.
        column: usize,
    },
    /// Two inputs with a coefficient of 1 or −1, which are one.
    One {
        /// The later of the two.
        row: usize,
        /// The other.
        column: usize,
    },
    /// A coefficient that no numbers can have beside those of its two inputs with a third one.
    Contradiction {
        /// Its row.
        row: usize,
        /// Its column.
        column: usize,
        /// The third input.
        third: usize,
        /// The least and the largest that it may be.
        range: [f64; 2],
    },
    /// No numbers can have these coefficients, though any three inputs could: the matrix is not positive definite.
    NotPositiveDefinite {
        /// The first row that contradicts those above it.
        row: usize,
    },
    /// A coefficient with joint values, which have their own correlation.
    OfJoint {
        /// Their row.
        row: usize,
    },
}

/// What keeps a design from being made.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum DesignError {
    /// No input, or more than are taken.
    Sources {
        /// How many there are.
        count: usize,
    },
    /// Fewer samples than tell an error, or more than the sequence has.
    Samples {
        /// How many there are.
        count: usize,
    },
    /// A seed that is too large.
    Seed {
        /// What it is.
        seed: u32,
    },
}

impl fmt::Display for InputError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::NotFinite => write!(f, "must have finite parameters"),
            Self::Deviation { deviation } => write!(f, "must have a deviation above 0, not {deviation}"),
            Self::Mean { mean } => write!(f, "must have a mean above 0, not {mean}: a lognormal quantity is positive"),
            Self::Ends { low, high } => write!(f, "must have its low end {low} below its high end {high}"),
            Self::Mode { mode } => write!(f, "must have its mode {mode} between its ends"),
            Self::Order { row } => write!(f, "must have quantiles that ascend; the one at {row} is below the one before"),
            Self::Count { count } => write!(f, "cannot have {count} values"),
            Self::TooWide => write!(f, "is so wide that its values are not finite"),
            Self::Outside { low, high, bounds } => {
                write!(f, "reaches from {low} to {high}, and the field may be {bounds}")
            }
            Self::MostlyOutside { share, bounds } => {
                write!(
                    f,
                    "lies outside what the field may be ({bounds}) with a share of {share:.3}, which is too much to cut off"
                )
            }
            Self::Lengths { column } => write!(f, "must have columns of one length; that at {column} has another"),
        }
    }
}

impl fmt::Display for CorrelationError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Size { expected, found, row } => {
                write!(f, "must have {expected} rows of {expected} coefficients, one for each input")?;
                match row {
                    None => write!(f, "; the number of rows is {found}"),
                    Some(row) => write!(f, "; row {row} has {found}"),
                }
            }
            Self::Coefficient { row, column } => write!(f, "must lie between -1 and 1, and that at [{row}][{column}] does not"),
            Self::Diagonal { row } => write!(f, "must have 1 on its diagonal, and has not at [{row}][{row}]"),
            Self::Asymmetric { row, column } => write!(f, "must be symmetric; [{row}][{column}] is not [{column}][{row}]"),
            Self::One { row, column } => write!(
                f,
                "is not positive definite: [{row}][{column}] makes inputs {column} and {row} the same one; it must be above -1 and below 1"
            ),
            Self::Contradiction { row, column, third, range: [least, most] } => write!(
                f,
                "is not positive definite: beside [{row}][{third}] and [{column}][{third}], [{row}][{column}] must lie between {least:.4} \
                 and {most:.4}"
            ),
            Self::NotPositiveDefinite { row } => {
                write!(
                    f,
                    "is not positive definite: the coefficients of row {row} together contradict those of the rows above it"
                )
            }
            Self::OfJoint { row } => {
                write!(f, "must have 0 in row {row} off its diagonal: joint samples have their own correlation")
            }
        }
    }
}

impl fmt::Display for DesignError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Sources { count } => write!(f, "there are {count} inputs"),
            Self::Samples { count } => write!(f, "there are {count} samples"),
            Self::Seed { seed } => write!(f, "the seed {seed} is too large"),
        }
    }
}

impl std::error::Error for InputError {}
impl std::error::Error for CorrelationError {}
impl std::error::Error for DesignError {}
