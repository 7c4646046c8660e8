//! How does the strength of a soil without residual fall after its peak? Wong (Theory of Ground Vehicles, ch. 2, source 19):
//! E = (j/K_w) exp(1 − j/K_w).
//!
//! Units: K_w in m. Validity: organic mats. No departures. The formula was quoted, not read in the book. What was checked:
//! dE/dj = 0 and E = 1 at j = K_w, and E → 0 for large j.

use crate::law::Declared;
use crate::numerics::elementary::Number;
use crate::parameter::{Parameter, Parametrised, Presence, Requirement};
use crate::sources::{Citation, WONG_BOOK};

/// Wong's law with a peak and no residual strength.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct WongPeak {
    /// Shear displacement K_w at the peak (m), greater than 0.
    pub peak_displacement: f64,
}

impl WongPeak {
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

    pub(super) fn scale(&self) -> f64 {
        self.peak_displacement
    }

    pub(super) fn residual(&self) -> f64 {
        0.0
    }

    /// E at x = |j|/K_w: in [0, 1].
    #[inline(always)]
    pub(super) fn rise<F: Number>(&self, x: F) -> F {
        x * (-x + 1.0).exp()
    }

    /// dE/dx.
    #[inline(always)]
    pub(super) fn steepness<F: Number>(&self, x: F) -> F {
        (-x + 1.0) * (-x + 1.0).exp()
    }
}

impl Parametrised for WongPeak {
    const PARAMETERS: &'static [Parameter] = &[Self::PEAK_DISPLACEMENT];

    fn from_values(values: &[Option<f64>]) -> Option<Self> {
        let &[peak_displacement] = values else { return None };
        Some(Self { peak_displacement: peak_displacement? })
    }

    fn values(&self) -> Vec<Option<f64>> {
        vec![Some(self.peak_displacement)]
    }
}

impl Declared for WongPeak {
    const NAME: &'static str = "wong_peak";
    const DOC: &'static str = "Wong's law with a peak: strength builds up over a peak and decays to nothing.";
    const FORMULA: &'static str = "E = (j/K_w) exp(1 − j/K_w)";
    const SOURCES: &'static [Citation] = &[WONG_BOOK.at("ch. 2")];
}
