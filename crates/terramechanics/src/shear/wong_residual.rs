//! How does the strength of a soil fall to a residual after a hump? Wong (Theory of Ground Vehicles, ch. 2).
//!
//! E = K_r {1 + [1/(K_r (1 − 1/e)) − 1] exp(1 − j/K_w)} {1 − exp(−j/K_w)}.
//!
//! The formula was quoted, not read in the book. What was checked: E = 1 at j = K_w for any K_r, and E → K_r for large j. That
//! E = 1 is also its largest value holds at K_r = 0.661 only (dE/dj = 0 at K_w); with another ratio the hump lies a little
//! beside K_w and E a little above 1, which is the formula's and not clipped.

use super::saturation;

/// Wong's law with a hump and a residual strength.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct WongResidual {
    /// Residual over largest strength K_r (–), greater than 0, at most 1.
    pub residual_ratio: f64,
    /// Shear displacement K_w at the hump (m), greater than 0.
    pub peak_displacement: f64,
}

impl WongResidual {
    /// E at x = |j|/K_w.
    #[inline]
    pub(super) fn mobilisation(&self, x: f64) -> f64 {
        const AT_PEAK: f64 = 1.0 - 1.0 / std::f64::consts::E;
        let hump = 1.0 / (self.residual_ratio * AT_PEAK) - 1.0;
        self.residual_ratio * (1.0 + hump * (1.0 - x).exp()) * saturation(x)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// With polar snow's K_r = 0.66 (Lines 2021) the hump is at K_w to within a few parts in a thousand.
    #[test]
    fn the_hump_is_the_largest_value_near_the_ratio_of_snow() {
        let law = WongResidual { residual_ratio: 0.661, peak_displacement: 0.022 };
        for x in [0.5, 0.9, 1.1, 2.0, 10.0] {
            assert!(law.mobilisation(x) <= 1.0 + 1e-5, "{x}");
        }
    }
}
