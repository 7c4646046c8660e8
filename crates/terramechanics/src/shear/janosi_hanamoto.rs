//! How does shear strength build up where it does not fall again? Janosi & Hanamoto (1961; source 9); letter, Eq. (6):
//! E = 1 − exp(−j/K).
//!
//! Units: K in m. Validity: soils that shear without a hump; the letter takes it for all. Departure: Eq. (6) as printed divides r
//! by an undefined V and, braking, would grow without bound; here r/K and an odd E (errata 2 and 11). The paper was not read.

use crate::fittable::{Fittable, Step, Tolerance};
use crate::law::Declared;
use crate::numerics::elementary::Number;
use crate::parameter::{Parameter, Parametrised, Presence, Requirement};
use crate::sources::{Citation, JANOSI_HANAMOTO, LETTER};

/// Janosi–Hanamoto's law: E = 1 − exp(−j/K).
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct JanosiHanamoto {
    /// Shear deformation modulus K (m), greater than 0.
    pub modulus: f64,
}

impl JanosiHanamoto {
    /// K.
    pub const MODULUS: Parameter = Parameter {
        name: "shear_modulus_m",
        symbol: "K",
        unit: "m",
        meaning: "Shear deformation modulus; Wong's laws do not need it.",
        requirement: Requirement::Positive,
        least: 1e-6,
        most: 10.0,
        presence: Presence::Required,
    };

    pub(super) fn scale(&self) -> f64 {
        self.modulus
    }

    pub(super) fn residual(&self) -> f64 {
        1.0
    }

    /// E at x = |j|/K: in [0, 1]. Eq. (6).
    #[inline(always)]
    pub(super) fn rise<F: Number>(&self, x: F) -> F {
        x.saturation()
    }

    /// dE/dx where E is `share`.
    #[inline(always)]
    pub(super) fn steepness<F: Number>(&self, share: F) -> F {
        -share + 1.0
    }
}

impl Parametrised for JanosiHanamoto {
    const PARAMETERS: &'static [Parameter] = &[Self::MODULUS];

    fn from_values(values: &[Option<f64>]) -> Option<Self> {
        let &[modulus] = values else { return None };
        Some(Self { modulus: modulus? })
    }

    fn values(&self) -> Vec<Option<f64>> {
        vec![Some(self.modulus)]
    }
}

impl Declared for JanosiHanamoto {
    const NAME: &'static str = "janosi_hanamoto";
    const DOC: &'static str = "Janosi–Hanamoto's law: strength builds up to its full value and stays there.";
    const FORMULA: &'static str = "E = 1 − exp(−j/K)";
    const SOURCES: &'static [Citation] = &[JANOSI_HANAMOTO.cited(), LETTER.at("Eq. 6")];
    const FITTABLE: &'static [Fittable] = &[Fittable {
        parameter: Self::MODULUS,
        bounds: [1e-5, 1.0],
        usual: [3e-3, 0.05],
        typical: 0.015,
        tolerance: Tolerance::Size,
        step: Step::Logarithmic(&Step::Linear(0.01)),
    }];
}
