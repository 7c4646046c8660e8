//! Estimates and how far they may be off.

use crate::design::SCRAMBLINGS;

/// A number found from samples.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Estimate {
    /// The number.
    pub value: f64,
    /// Its standard error.
    pub error: f64,
}

/// Sums of a numerator and a denominator over the samples of each scrambling. Every figure of this crate is such a ratio: a mean is
/// the sum of the values over their number, an index the sum of products over that of squares.
#[derive(Debug, Clone, Default)]
pub(crate) struct Ratio {
    sums: [[f64; 2]; SCRAMBLINGS],
}

impl Ratio {
    /// Of numerator and denominator by sample.
    pub(crate) fn of(pairs: impl Iterator<Item = (usize, [f64; 2])>) -> Self {
        let mut ratio = Self::default();
        for (sample, [numerator, denominator]) in pairs {
            let sums = &mut ratio.sums[sample % SCRAMBLINGS];
            sums[0] += numerator;
            sums[1] += denominator;
        }
        ratio
    }

    /// The mean of values.
    pub(crate) fn mean(values: impl Iterator<Item = (usize, f64)>) -> Self {
        Self::of(values.map(|(sample, value)| (sample, [value, 1.0])))
    }

    /// The ratio of the whole sums. Its error follows from the scatter of numerator − ratio · denominator among the scramblings,
    /// which are independent: the linearised variance of a ratio (Cochran 1977, section 2.11). None for a denominator of 0.
    pub(crate) fn estimate(&self) -> Option<Estimate> {
        let total = |of: usize| self.sums.iter().map(|sums| sums[of]).sum::<f64>();
        let denominator = total(1);
        let value = total(0) / denominator;
        let scatter: f64 = self.sums.iter().map(|[over, under]| (over - value * under).powi(2)).sum();
        let count = SCRAMBLINGS as f64;
        let error = (count / (count - 1.0) * scatter).sqrt() / denominator.abs();
        (value.is_finite() && error.is_finite()).then_some(Estimate { value, error })
    }
}

/// The largest size of values, by which they are divided before they are squared; 1 where all are 0.
pub(crate) fn scale(values: impl Iterator<Item = f64>) -> f64 {
    let largest = values.fold(0.0, |largest: f64, value| largest.max(value.abs()));
    if largest > 0.0 { largest } else { 1.0 }
}

/// The variance, of numbers up to 1 in size, up to which there is only the rounding of a model: a deviation of 1e-10.
pub(crate) const ROUNDING: f64 = 1e-20;

impl Estimate {
    /// What is known without error.
    pub(crate) fn exact(self) -> Self {
        Self { error: 0.0, ..self }
    }

    /// In the unit of values that were divided by a scale.
    pub(crate) fn times(self, scale: f64) -> Self {
        Self { value: self.value * scale, error: self.error * scale }
    }
}
