//! Where is the stress largest, as measured? The peak moves forward with slip (Wong & Reece 1967, source 22): θm = (c1 + c2 s) θ1.
//!
//! Units: c1 and c2 have none. Validity: driving wheels on the soil for which c1 and c2 were measured; the peak has to lie within
//! the contact. No departures; at s < 0 the rule is applied as written. The paper was not read; the rule was seen in public
//! implementations that agree.

use super::ContactArc;
use crate::fittable::{Fittable, Step, Tolerance};
use crate::law::Declared;
use crate::numerics::elementary::Number;
use crate::parameter::{Parameter, Parametrised, Presence, Requirement};
use crate::sources::{Citation, WONG_REECE};

/// A peak that moves with slip.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct WongReece {
    /// c1 (–).
    pub c1: f64,
    /// c2, the gain with slip (–).
    pub c2: f64,
}

impl WongReece {
    /// c1.
    pub const C1: Parameter = Parameter {
        name: "c1",
        symbol: "c1",
        unit: "1",
        meaning: "Angle of maximum stress over the entry angle, without slip.",
        requirement: Requirement::Finite,
        least: -1.0,
        most: 2.0,
        presence: Presence::Required,
    };

    /// c2.
    pub const C2: Parameter = Parameter {
        name: "c2",
        symbol: "c2",
        unit: "1",
        meaning: "Gain of the angle of maximum stress with slip, over the entry angle.",
        requirement: Requirement::Finite,
        least: -2.0,
        most: 2.0,
        presence: Presence::Required,
    };

    #[inline(always)]
    pub(super) fn peak<F: Number>(&self, arc: &ContactArc<F>) -> F {
        (arc.slip * self.c2 + self.c1) * arc.entry
    }

    #[inline(always)]
    pub(super) fn rate<F: Number>(&self, slip: F) -> F {
        slip * self.c2 + self.c1
    }
}

impl Parametrised for WongReece {
    const PARAMETERS: &'static [Parameter] = &[Self::C1, Self::C2];

    fn from_values(values: &[Option<f64>]) -> Option<Self> {
        let &[c1, c2] = values else { return None };
        Some(Self { c1: c1?, c2: c2? })
    }

    fn values(&self) -> Vec<Option<f64>> {
        vec![Some(self.c1), Some(self.c2)]
    }
}

impl Declared for WongReece {
    const NAME: &'static str = "wong_reece";
    const DOC: &'static str = "The peak moves with slip, as Wong & Reece measured it.";
    const FORMULA: &'static str = "θm = (c1 + c2 s) θ1";
    const SOURCES: &'static [Citation] = &[WONG_REECE.cited()];
    const FITTABLE: &'static [Fittable] = &[
        Fittable {
            parameter: Self::C1,
            bounds: [-0.5, 1.5],
            usual: [0.2, 0.6],
            typical: 0.4,
            tolerance: Tolerance::Fixed(0.2),
            step: Step::ONE,
        },
        Fittable {
            parameter: Self::C2,
            bounds: [-2.0, 2.0],
            usual: [-0.2, 0.4],
            typical: 0.1,
            tolerance: Tolerance::Fixed(0.4),
            step: Step::ONE,
        },
    ];
}
