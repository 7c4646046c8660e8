//! How firm is the soil under a small wheel? Meirion-Griffith & Spenko (2011; source 13): p = k z^n D^m.
//!
//! The wheel's diameter D takes the place of the plate's width. Units: k in N/m^(n+m+2). Validity: wheels below about half a
//! metre in diameter.
//!
//! Departures: the exponent may grow with slip, N for n (letter, Eq. 1). The paper was not read; the form follows from the unit
//! in which a public data set gives k.

use super::{Plate, SinkageExponent};
use crate::caution::Caution;
use crate::fittable::Fittable;
use crate::law::Declared;
use crate::parameter::{Parameter, Parametrised, Presence, Requirement};
use crate::sources::{Citation, MEIRION_GRIFFITH_SPENKO};

/// The law with the wheel's diameter: K_s = k (2r)^m.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Diameter {
    /// Coefficient k (N/m^(n+m+2)).
    pub k: f64,
    /// Exponent m of the diameter (–).
    pub m: f64,
    /// Sinkage exponent.
    pub exponent: SinkageExponent,
}

impl Diameter {
    /// k.
    pub const K: Parameter = Parameter {
        name: "k",
        symbol: "k",
        unit: "N/m^(n+m+2)",
        meaning: "Coefficient of Meirion-Griffith & Spenko.",
        requirement: Requirement::Finite,
        least: 1e-6,
        most: 1e15,
        presence: Presence::Required,
    };

    /// m.
    pub const M: Parameter = Parameter {
        name: "m",
        symbol: "m",
        unit: "1",
        meaning: "Exponent of the wheel's diameter.",
        requirement: Requirement::Finite,
        least: -10.0,
        most: 10.0,
        presence: Presence::Required,
    };

    pub(super) fn exponent(&self) -> SinkageExponent {
        self.exponent
    }

    pub(super) fn sinkage_modulus(&self, plate: &Plate, _exponent: f64) -> f64 {
        self.k * plate.diameter.powf(self.m)
    }

    pub(super) fn cautions(&self, _plate: &Plate) -> [Option<Caution>; 2] {
        [None, None]
    }
}

impl Parametrised for Diameter {
    const PARAMETERS: &'static [Parameter] =
        &[Self::K, Self::M, SinkageExponent::BASE, SinkageExponent::SLIP_GAIN, SinkageExponent::SKID_GAIN];

    fn from_values(values: &[Option<f64>]) -> Option<Self> {
        let &[k, m, ref exponent @ ..] = values else { return None };
        Some(Self { k: k?, m: m?, exponent: SinkageExponent::from_values(exponent)? })
    }

    fn values(&self) -> Vec<Option<f64>> {
        [vec![Some(self.k), Some(self.m)], self.exponent.values()].concat()
    }
}

impl Declared for Diameter {
    const NAME: &'static str = "diameter";
    const DOC: &'static str =
        "The law of Meirion-Griffith & Spenko, in which the wheel's diameter corrects Bekker's for small wheels.";
    const FORMULA: &'static str = "K_s = k (2r)^m";
    const SOURCES: &'static [Citation] = &[MEIRION_GRIFFITH_SPENKO.cited()];
    const FITTABLE: &'static [Fittable] = &[SinkageExponent::FITTABLE_BASE, SinkageExponent::FITTABLE_SLIP_GAIN];
}
