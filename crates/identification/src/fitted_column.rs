//! How well does the model reproduce a measured column?

use crate::quantity::Quantity;

/// One fitted column.
#[derive(Debug, Clone, PartialEq)]
pub struct FittedColumn {
    /// What was measured.
    pub quantity: Quantity,
    /// As measured.
    pub measured: Vec<f64>,
    /// As the model predicts with the estimates.
    pub predicted: Vec<f64>,
    /// Root of the mean squared difference.
    pub rmse: f64,
}

/// Residuals above this share of a column's size are large. The model describes the wheels of Ding et al. (2011) within 3 to 8
/// % of the load (`tests/measurements.rs`).
const SHARE_OF_SIZE: f64 = 0.1;

/// Residuals above this share of a column's spread about its mean are large: their variance is then more than a ninth of the
/// column's.
const SHARE_OF_SPREAD: f64 = 1.0 / 3.0;

impl FittedColumn {
    /// Two columns of one length and how far they are apart.
    #[must_use]
    pub fn new(quantity: Quantity, measured: Vec<f64>, predicted: Vec<f64>) -> Self {
        let rmse = root_mean_square(predicted.iter().zip(&measured).map(|(predicted, measured)| predicted - measured));
        Self { quantity, measured, predicted, rmse }
    }

    /// Root of the mean square of what was measured.
    #[must_use]
    pub fn size(&self) -> f64 {
        root_mean_square(self.measured.iter().copied())
    }

    /// Standard deviation of what was measured about its mean.
    #[must_use]
    pub fn spread(&self) -> f64 {
        let mean = self.measured.iter().map(|value| value / self.measured.len().max(1) as f64).sum::<f64>();
        root_mean_square(self.measured.iter().map(|value| value - mean))
    }

    /// Whether the residuals are large both against the column's size and against its spread. Noise of some percent is not
    /// large, nor is a small miss of a load that was held constant.
    #[must_use]
    pub fn is_missed(&self) -> bool {
        self.rmse > SHARE_OF_SIZE * self.size() && self.rmse > SHARE_OF_SPREAD * self.spread()
    }
}

fn root_mean_square(values: impl Iterator<Item = f64> + Clone) -> f64 {
    // Scaled by the largest, so that the squares neither overflow nor vanish.
    let largest = values.clone().fold(f64::MIN_POSITIVE, |largest, value| largest.max(value.abs()));
    let (squares, count) = values.fold((0.0, 0.0), |(sum, count), value| (sum + (value / largest).powi(2), count + 1.0));
    largest * (squares / f64::max(count, 1.0)).sqrt()
}
