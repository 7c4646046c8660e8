//! How does the strength of a soil without residual fall after its peak? Wong (Theory of Ground Vehicles, ch. 2): organic mats.
//!
//! E = (j/K_w) exp(1 − j/K_w). The formula was quoted, not read in the book. What was checked: dE/dj = 0 and E = 1 at j = K_w,
//! and E → 0 for large j.

/// Wong's law with a peak and no residual strength.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct WongPeak {
    /// Shear displacement K_w at the peak (m), greater than 0.
    pub peak_displacement: f64,
}

impl WongPeak {
    /// E at x = |j|/K_w: in [0, 1].
    #[inline]
    pub(super) fn mobilisation(x: f64) -> f64 {
        x * (1.0 - x).exp()
    }
}
