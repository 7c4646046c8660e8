//! Why a fit cannot be tried, as data.

use std::fmt;

use crate::quantity::Quantity;
use crate::range;
use crate::unknown::Unknown;

/// What keeps a fit from being tried.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum FitError {
    /// No unknown is asked for.
    NothingToFit,
    /// An unknown is asked for twice.
    Repeated(Unknown),
    /// The model as set up has no such parameter.
    NoSuchParameter(Unknown),
    /// Bounds that are not finite, or whose lower end is not below the upper.
    ImproperBounds(Unknown),
    /// A start outside the bounds.
    StartOutsideBounds(Unknown),
    /// No samples, or more than are taken.
    Samples {
        /// How many there are.
        count: usize,
    },
    /// A column whose length is not that of the slip.
    Length(Quantity),
    /// A value that is not finite, or a load or sinkage that is not positive where it has to be.
    Value {
        /// The column.
        quantity: Quantity,
        /// The row.
        row: usize,
    },
    /// A column whose largest value is too small or too large to be squared and summed. A column of zeros is allowed.
    Size(Quantity),
    /// A standard deviation that is not positive, or too small or too large to be squared and summed.
    Deviation {
        /// The column.
        quantity: Quantity,
        /// The row.
        row: usize,
    },
    /// Some fitted columns come with standard deviations and this one does not.
    DeviationMissing(Quantity),
    /// A column that the setup needs.
    Missing(Quantity),
    /// No column is left that could be compared with a prediction.
    NothingMeasured,
    /// The evaluations or the time were spent before there was anything to report.
    OutOfBudget,
    /// The caller did not want it to go on.
    Stopped,
    /// The model has no answer for the data, neither at the start nor at any other start that was tried.
    Refused {
        /// The row at fault.
        row: usize,
        /// Why it has none.
        error: terramechanics::Error,
    },
}

impl fmt::Display for FitError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::NothingToFit => write!(f, "no unknown is asked for"),
            Self::Repeated(unknown) => write!(f, "{unknown} is asked for twice"),
            Self::NoSuchParameter(unknown) => write!(f, "the model as set up has no parameter {unknown}"),
            Self::ImproperBounds(unknown) => write!(f, "the bounds of {unknown} must be finite, the first below the second"),
            Self::StartOutsideBounds(unknown) => write!(f, "the start of {unknown} lies outside its bounds"),
            Self::Samples { count } => write!(f, "there are {count} samples"),
            Self::Length(quantity) => write!(f, "the column of {quantity} must be as long as that of the slip"),
            Self::Value { quantity, row } => write!(f, "the {quantity} of sample {row} cannot be used"),
            Self::Size(quantity) => write!(f, "the largest size of the {quantity} {}", range::WORDS),
            Self::Deviation { quantity, row } => {
                write!(f, "the standard deviation of the {quantity} of sample {row} {}", range::WORDS)
            }
            Self::DeviationMissing(quantity) => {
                write!(f, "the {quantity} has no standard deviation, and another fitted column has one")
            }
            Self::Missing(quantity) => write!(f, "the {quantity} has to be measured"),
            Self::NothingMeasured => write!(f, "nothing is measured that the model predicts"),
            Self::OutOfBudget => {
                write!(f, "the evaluations or the time were spent before there was anything to report: send fewer samples")
            }
            Self::Stopped => write!(f, "the fit was told to stop"),
            Self::Refused { row, error } => {
                write!(f, "the model has no solution for all samples at any start; sample {row}: {error}")
            }
        }
    }
}

impl std::error::Error for FitError {}
