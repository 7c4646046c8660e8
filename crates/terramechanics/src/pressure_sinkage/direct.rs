//! How firm is the soil under this very wheel? A sinkage modulus K_s measured as it is (letter, Eq. 1): p = K_s z^N.
//!
//! Units: K_s in Pa/m^N. Validity: the width of the plate or wheel under which K_s was measured. No departures.

use super::{Plate, SinkageExponent};
use crate::caution::Caution;
use crate::fittable::{Fittable, Step, Tolerance};
use crate::law::Declared;
use crate::parameter::{Parameter, Parametrised, Presence, Requirement};
use crate::sources::{Citation, LETTER};

/// A sinkage modulus given directly.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Direct {
    /// Sinkage modulus K_s (Pa/m^N).
    pub k_s: f64,
    /// Sinkage exponent.
    pub exponent: SinkageExponent,
}

impl Direct {
    /// K_s.
    pub const K_S: Parameter = Parameter {
        name: "k_s",
        symbol: "K_s",
        unit: "Pa/m^N",
        meaning: "Sinkage modulus.",
        requirement: Requirement::Finite,
        least: 1e-6,
        most: 1e15,
        presence: Presence::Required,
    };

    pub(super) fn exponent(&self) -> SinkageExponent {
        self.exponent
    }

    pub(super) fn sinkage_modulus(&self, _plate: &Plate, _exponent: f64) -> f64 {
        self.k_s
    }

    pub(super) fn cautions(&self, _plate: &Plate) -> [Option<Caution>; 2] {
        [None, None]
    }
}

impl Parametrised for Direct {
    const PARAMETERS: &'static [Parameter] =
        &[Self::K_S, SinkageExponent::BASE, SinkageExponent::SLIP_GAIN, SinkageExponent::SKID_GAIN];

    fn from_values(values: &[Option<f64>]) -> Option<Self> {
        let &[k_s, ref exponent @ ..] = values else { return None };
        Some(Self { k_s: k_s?, exponent: SinkageExponent::from_values(exponent)? })
    }

    fn values(&self) -> Vec<Option<f64>> {
        [vec![Some(self.k_s)], self.exponent.values()].concat()
    }
}

impl Declared for Direct {
    const NAME: &'static str = "direct";
    const DOC: &'static str = "A sinkage modulus as it was measured.";
    const FORMULA: &'static str = "K_s = k_s";
    const SOURCES: &'static [Citation] = &[LETTER.at("Eq. 1")];
    const FITTABLE: &'static [Fittable] = &[
        Fittable {
            parameter: Self::K_S,
            bounds: [1.0, 1e13],
            usual: [3e4, 3e7],
            typical: 1e6,
            tolerance: Tolerance::Size,
            step: Step::Logarithmic(&Step::OfStart(1.0)),
        },
        SinkageExponent::FITTABLE_BASE,
        SinkageExponent::FITTABLE_SLIP_GAIN,
    ];
}
