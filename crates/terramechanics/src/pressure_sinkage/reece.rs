//! How firm is the soil, in dimensionless moduli? Reece (1965; source 15): p = (c k_c' + γ b k_φ') (z/b)^n.
//!
//! Units: k_c' and k_φ' have none, γ is a weight per volume (N/m³), not a density. Validity: as Bekker's law for large plates;
//! the form in z/b carries moduli from one width to another. At n = 1 both laws are one, with k_c = c k_c' and k_φ = γ k_φ'.
//!
//! Departures: the exponent may grow with slip, N for n (letter, Eq. 1), also in b^N. The paper was not read; the formula was
//! seen in two public implementations that agree.

use super::{Bekker, Plate, SinkageExponent};
use crate::caution::Caution;
use crate::fittable::Fittable;
use crate::law::Declared;
use crate::parameter::{Parameter, Parametrised, Presence, Requirement};
use crate::sources::{Citation, REECE};

/// Reece's law: K_s = (c k_c' + γ b k_φ')/b^N.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Reece {
    /// Cohesive modulus k_c' (–).
    pub k_c: f64,
    /// Frictional modulus k_φ' (–).
    pub k_phi: f64,
    /// Unit weight γ (N/m³), not negative.
    pub unit_weight: f64,
    /// Sinkage exponent.
    pub exponent: SinkageExponent,
}

impl Reece {
    /// k_c'.
    pub const K_C: Parameter = Parameter {
        name: "k_c",
        symbol: "k_c'",
        unit: "1",
        meaning: "Cohesive modulus.",
        requirement: Requirement::Finite,
        least: -1e9,
        most: 1e9,
        presence: Presence::Required,
    };

    /// k_φ'.
    pub const K_PHI: Parameter = Parameter {
        name: "k_phi",
        symbol: "k_φ'",
        unit: "1",
        meaning: "Frictional modulus.",
        requirement: Requirement::Finite,
        least: -1e9,
        most: 1e12,
        presence: Presence::Required,
    };

    /// γ.
    pub const UNIT_WEIGHT: Parameter = Parameter {
        name: "unit_weight_n_m3",
        symbol: "γ",
        unit: "N/m3",
        meaning: "Unit weight of the soil; in a request, where it is not given here, that of the soil itself or its density times gravity.",
        requirement: Requirement::NotNegative,
        least: 0.0,
        most: 1e6,
        presence: Presence::Required,
    };

    pub(super) fn exponent(&self) -> SinkageExponent {
        self.exponent
    }

    pub(super) fn sinkage_modulus(&self, plate: &Plate, exponent: f64) -> f64 {
        let Plate { width, cohesion, .. } = *plate;
        (cohesion * self.k_c + self.unit_weight * width * self.k_phi) / width.powf(exponent)
    }

    pub(super) fn cautions(&self, _plate: &Plate) -> [Option<Caution>; 2] {
        [None, None]
    }
}

impl Parametrised for Reece {
    const PARAMETERS: &'static [Parameter] = &[
        Self::K_C,
        Self::K_PHI,
        Self::UNIT_WEIGHT,
        SinkageExponent::BASE,
        SinkageExponent::SLIP_GAIN,
        SinkageExponent::SKID_GAIN,
    ];

    fn from_values(values: &[Option<f64>]) -> Option<Self> {
        let &[k_c, k_phi, unit_weight, ref exponent @ ..] = values else { return None };
        let exponent = SinkageExponent::from_values(exponent)?;
        Some(Self { k_c: k_c?, k_phi: k_phi?, unit_weight: unit_weight?, exponent })
    }

    fn values(&self) -> Vec<Option<f64>> {
        [vec![Some(self.k_c), Some(self.k_phi), Some(self.unit_weight)], self.exponent.values()].concat()
    }
}

impl Declared for Reece {
    const NAME: &'static str = "reece";
    const DOC: &'static str = "Reece's law: Bekker's in moduli without dimension.";
    const FORMULA: &'static str = "K_s = (c k_c' + γ b k_phi')/b^N";
    const SOURCES: &'static [Citation] = &[REECE.cited()];
    const FITTABLE: &'static [Fittable] = &[
        Fittable { parameter: Self::K_C, ..Bekker::FITTABLE_K_C },
        Fittable { parameter: Self::K_PHI, ..Bekker::FITTABLE_K_PHI },
        SinkageExponent::FITTABLE_BASE,
        SinkageExponent::FITTABLE_SLIP_GAIN,
    ];
}
