//! How does the strength of a soil fall to a residual after a hump? Wong (Theory of Ground Vehicles, ch. 2, source 19):
//! E = K_r {1 + [1/(K_r (1 − 1/e)) − 1] exp(1 − j/K_w)} {1 − exp(−j/K_w)}.
//!
//! Units: K_r has none, K_w in m. Validity: firm soils whose strength passes over a hump; snow. No departures. The formula was
//! quoted, not read in the book. What was checked: E = 1 at j = K_w for any K_r, and E → K_r for large j. E = 1 is the largest
//! value only at [`WongResidual::HUMP_AT_SCALE`], where dE/dj = 0 at K_w. With another ratio the hump lies a little beside K_w
//! and E rises a little above 1, which is the formula's and not clipped.

use crate::law::Declared;
use crate::numerics::elementary::Number;
use crate::parameter::{Parameter, Parametrised, Presence, Requirement};
use crate::sources::{Citation, WONG_BOOK};

/// 1 − 1/e: what the rising factor has reached at j = K_w.
const AT_HUMP: f64 = 1.0 - 1.0 / std::f64::consts::E;

/// Wong's law with a hump and a residual strength.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct WongResidual {
    /// Residual over largest strength K_r (–), greater than 0, at most 1.
    pub residual_ratio: f64,
    /// Shear displacement K_w at the hump (m), greater than 0.
    pub peak_displacement: f64,
}

impl WongResidual {
    /// K_r.
    pub const RESIDUAL_RATIO: Parameter = Parameter {
        name: "residual_ratio",
        symbol: "K_r",
        unit: "1",
        meaning: "Residual over largest strength.",
        requirement: Requirement::Within { min: f64::MIN_POSITIVE, max: 1.0 },
        least: 1e-3,
        most: 1.0,
        presence: Presence::Required,
    };

    /// K_w.
    pub const PEAK_DISPLACEMENT: Parameter = Parameter {
        name: "peak_displacement_m",
        symbol: "K_w",
        unit: "m",
        meaning: "Shear displacement at the largest strength.",
        requirement: Requirement::Positive,
        least: 1e-6,
        most: 10.0,
        presence: Presence::Required,
    };

    /// The ratio K_r (–) at which the hump lies at K_w, near that of polar snow (Lines 2021, source 11): dE/dj = 0 at j = K_w gives
    /// K_r = (1 − 2/e)/(1 − 1/e)².
    pub const HUMP_AT_SCALE: f64 = (1.0 - 2.0 / std::f64::consts::E) / (AT_HUMP * AT_HUMP);

    pub(super) fn scale(&self) -> f64 {
        self.peak_displacement
    }

    pub(super) fn residual(&self) -> f64 {
        self.residual_ratio
    }

    /// E at x = |j|/K_w.
    #[inline(always)]
    pub(super) fn rise<F: Number>(&self, x: F) -> F {
        let hump = 1.0 / (self.residual_ratio * AT_HUMP) - 1.0;
        ((-x + 1.0).exp() * hump + 1.0) * self.residual_ratio * x.saturation()
    }

    /// dE/dx.
    #[inline(always)]
    pub(super) fn steepness<F: Number>(&self, x: F) -> F {
        let hump = (-x + 1.0).exp() * (1.0 / (self.residual_ratio * AT_HUMP) - 1.0);
        ((hump + 1.0) * (-x).exp() - hump * x.saturation()) * self.residual_ratio
    }
}

impl Parametrised for WongResidual {
    const PARAMETERS: &'static [Parameter] = &[Self::RESIDUAL_RATIO, Self::PEAK_DISPLACEMENT];

    fn from_values(values: &[Option<f64>]) -> Option<Self> {
        let &[residual_ratio, peak_displacement] = values else { return None };
        Some(Self { residual_ratio: residual_ratio?, peak_displacement: peak_displacement? })
    }

    fn values(&self) -> Vec<Option<f64>> {
        vec![Some(self.residual_ratio), Some(self.peak_displacement)]
    }
}

impl Declared for WongResidual {
    const NAME: &'static str = "wong_residual";
    const DOC: &'static str = "Wong's law with a residual: strength builds up over a hump and falls to a residual.";
    const FORMULA: &'static str = "E = K_r {1 + [1/(K_r (1 − 1/e)) − 1] exp(1 − j/K_w)} {1 − exp(−j/K_w)}";
    const SOURCES: &'static [Citation] = &[WONG_BOOK.at("ch. 2")];
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_hump_lies_at_its_displacement_for_one_ratio_only() {
        let largest = |residual_ratio: f64| {
            let law = WongResidual { residual_ratio, peak_displacement: 0.022 };
            (0..=4000).map(|i| law.rise(f64::from(i) / 1000.0)).fold(0.0, f64::max)
        };
        assert!((largest(WongResidual::HUMP_AT_SCALE) - 1.0).abs() < 1e-15);
        // Polar snow has 0.66 (Lines 2021); a brittle soil is further off.
        assert!(largest(0.66) < 1.0 + 1e-5);
        assert!(largest(0.3) > 1.001 && largest(0.9) > 1.001);
    }
}
