//! How much deeper does a slipping wheel sink? Lyasko (2010; source 12), after Vasil'ev (1969); letter, Eq. (18):
//! z = z0 (1 + s)/(1 − s/2).
//!
//! z rises from 0 at s = −1 over z0 at s = 0 to 4 z0 at s = 1. Units: z and z0 in m, s has none. Validity: no range is known.
//! Wheels with lugs sank deeper than by this law (Ding et al. 2010, source 5). The law was made for driving wheels; at s < 0 it
//! is applied as written. No departures. The paper was not read; the formula is the letter's.

use crate::caution::{Caution, SLIP_BEYOND_LYASKO, SLIP_SINKAGE_EXTRAPOLATED};
use crate::law::Declared;
use crate::parameter::{Parameter, Parametrised};
use crate::slip::Slip;
use crate::sources::{Citation, LETTER, LYASKO};

/// Lyasko's law: z = z0 (1 + s)/(1 − s/2).
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Lyasko;

impl Lyasko {
    pub(super) fn sinkage(&self, static_sinkage: f64, slip: Slip) -> f64 {
        let s = slip.ratio();
        static_sinkage * (1.0 + s) / (1.0 - 0.5 * s) // Eq. (18)
    }

    /// Warns of a slip beyond the tests and of a braking wheel.
    pub(super) fn cautions(&self, slip: Slip) -> [Option<Caution>; 2] {
        [SLIP_BEYOND_LYASKO.of(slip.ratio()), SLIP_SINKAGE_EXTRAPOLATED.of(slip.ratio())]
    }
}

impl Parametrised for Lyasko {
    const PARAMETERS: &'static [Parameter] = &[];

    fn from_values(values: &[Option<f64>]) -> Option<Self> {
        values.is_empty().then_some(Self)
    }

    fn values(&self) -> Vec<Option<f64>> {
        Vec::new()
    }
}

impl Declared for Lyasko {
    const NAME: &'static str = "lyasko";
    const DOC: &'static str = "Lyasko's law, which has no parameters.";
    const FORMULA: &'static str = "z = z0 (1 + s)/(1 − s/2)";
    const SOURCES: &'static [Citation] = &[LYASKO.cited(), LETTER.at("Eq. 18")];
}
