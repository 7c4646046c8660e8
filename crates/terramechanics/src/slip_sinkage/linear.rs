//! How much deeper does a slipping wheel sink, if only a slope was measured? A linear gain (Lines 2021, thesis code, source 11):
//! z = z0 (1 + S s).
//!
//! Units: z and z0 in m, S has none. No departures. Validity: none was published; the gain is the user's own. At s < 0 the law
//! is applied as written.

use crate::caution::{Caution, LINEAR_SLIP_SINKAGE_EXTRAPOLATED, SLIP_BEYOND_LINEAR};
use crate::law::Declared;
use crate::parameter::{Parameter, Parametrised, Presence, Requirement};
use crate::slip::Slip;
use crate::sources::{Citation, LINES};

/// A linear gain of sinkage with slip.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct LinearSlipSinkage {
    /// S in z = z0 (1 + S s) (–), not negative.
    pub gain: f64,
}

impl LinearSlipSinkage {
    /// S.
    pub const GAIN: Parameter = Parameter {
        name: "gain",
        symbol: "S",
        unit: "1",
        meaning: "Gain of the sinkage with slip.",
        requirement: Requirement::NotNegative,
        least: 0.0,
        most: 100.0,
        presence: Presence::Required,
    };

    pub(super) fn sinkage(&self, static_sinkage: f64, slip: Slip) -> f64 {
        static_sinkage * (1.0 + self.gain * slip.ratio())
    }

    /// Warns of a slip beyond the tests and of a braking wheel.
    pub(super) fn cautions(&self, slip: Slip) -> [Option<Caution>; 2] {
        [SLIP_BEYOND_LINEAR.of(slip.ratio()), LINEAR_SLIP_SINKAGE_EXTRAPOLATED.of(slip.ratio())]
    }
}

impl Parametrised for LinearSlipSinkage {
    const PARAMETERS: &'static [Parameter] = &[Self::GAIN];

    fn from_values(values: &[Option<f64>]) -> Option<Self> {
        let &[gain] = values else { return None };
        Some(Self { gain: gain? })
    }

    fn values(&self) -> Vec<Option<f64>> {
        vec![Some(self.gain)]
    }
}

impl Declared for LinearSlipSinkage {
    const NAME: &'static str = "linear";
    const DOC: &'static str = "A sinkage that grows linearly with slip.";
    const FORMULA: &'static str = "z = z0 (1 + S s)";
    const SOURCES: &'static [Citation] = &[LINES.at("thesis code")];
}
