//! Samples of several inputs at once, such as the posterior of a fit.

use crate::error::InputError;

/// The most values of a column of joint samples, or of known quantiles.
pub const MOST_VALUES: usize = 10_000;

/// The most columns of joint samples.
pub const MOST_COLUMNS: usize = 16;

/// Joint samples. A row is drawn as a whole, each as likely as another, so that whatever holds between its columns is kept.
#[derive(Debug, Clone, PartialEq)]
pub struct Joint {
    columns: Vec<Vec<f64>>,
    rows: usize,
}

impl Joint {
    /// Samples by column.
    ///
    /// # Errors
    /// No column or too many; no value or too many; columns of different length; a value that is not finite.
    pub fn new(columns: Vec<Vec<f64>>) -> Result<Self, InputError> {
        if !(1..=MOST_COLUMNS).contains(&columns.len()) {
            return Err(InputError::Count { count: columns.len() });
        }
        let rows = columns.first().map_or(0, Vec::len);
        if !(1..=MOST_VALUES).contains(&rows) {
            return Err(InputError::Count { count: rows });
        }
        if let Some(column) = columns.iter().position(|column| column.len() != rows) {
            return Err(InputError::Lengths { column });
        }
        if columns.iter().flatten().any(|value| !value.is_finite()) {
            return Err(InputError::NotFinite);
        }
        Ok(Self { columns, rows })
    }

    /// How many numbers a row has.
    pub(crate) fn width(&self) -> usize {
        self.columns.len()
    }

    /// A column; none beyond the last.
    pub fn column(&self, column: usize) -> Option<&[f64]> {
        self.columns.get(column).map(Vec::as_slice)
    }

    /// The mean of a column.
    pub fn mean(&self, column: usize) -> f64 {
        self.over_rows(column, |value| value)
    }

    /// The standard deviation of a column.
    pub fn deviation(&self, column: usize) -> f64 {
        let mean = self.mean(column);
        self.over_rows(column, |value| (value - mean) * (value - mean)).sqrt()
    }

    fn over_rows(&self, column: usize, of: impl Fn(f64) -> f64) -> f64 {
        // Each share by itself, because the sum of large numbers may overflow.
        let share = 1.0 / self.rows as f64;
        self.column(column).unwrap_or_default().iter().map(|value| of(*value) * share).sum()
    }

    /// The row for p in (0, 1).
    pub(crate) fn row(&self, p: f64) -> impl Iterator<Item = f64> + '_ {
        let row = ((p * self.rows as f64) as usize).min(self.rows - 1);
        self.columns.iter().map(move |column| column[row])
    }
}
