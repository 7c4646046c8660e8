//! How much deeper does a slipping wheel sink, where only a slope was measured? A linear gain (Lines 2021, thesis code, source 11):
//! z = z0 (1 + S s), and z0 (1 − S_b s) at s < 0 where a gain with skid is given.
//!
//! Units: S and S_b have none. Validity: none was published; the gains are the user's own. Without S_b the law is applied at s < 0 as
//! written, where it lets the wheel rise. Measured wheels sink: the two of Pavlov & Johnson 2024 (source 25) went on the mean to 1.6 times
//! the static sinkage at a slip of −0.5 and to 3.3 times when locked, which S_b = 1.2 and 2.3 give.

use crate::caution::{Caution, LINEAR_SLIP_SINKAGE_EXTRAPOLATED, SLIP_BEYOND_LINEAR};
use crate::law::Declared;
use crate::parameter::{Parameter, Parametrised, Presence, Requirement};
use crate::slip::Slip;
use crate::sources::{Citation, LINES, PAVLOV_JOHNSON};

/// A linear gain of sinkage with slip.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct LinearSlipSinkage {
    /// S in z = z0 (1 + S s) (–), not negative.
    pub gain: f64,
    /// S_b in z = z0 (1 − S_b s) at s < 0 (–), not negative; where none is given, S holds there too.
    pub skid_gain: Option<f64>,
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

    /// S_b.
    pub const SKID_GAIN: Parameter = Parameter {
        name: "skid_gain",
        symbol: "S_b",
        meaning: "Gain of the sinkage with skid: z = z0 (1 − S_b s) at s < 0; the gain S holds there too unless given.",
        presence: Presence::Optional,
        ..Self::GAIN
    };

    pub(super) fn sinkage(&self, static_sinkage: f64, slip: Slip) -> f64 {
        match self.skid_gain {
            Some(skid_gain) if !slip.is_driving() => static_sinkage * (1.0 - skid_gain * slip.ratio()),
            _ => static_sinkage * (1.0 + self.gain * slip.ratio()),
        }
    }

    /// Warns of a slip beyond the tests and of a braking wheel without a gain of its own.
    pub(super) fn cautions(&self, slip: Slip) -> [Option<Caution>; 2] {
        let extrapolated = if self.skid_gain.is_none() { LINEAR_SLIP_SINKAGE_EXTRAPOLATED.of(slip.ratio()) } else { None };
        [SLIP_BEYOND_LINEAR.of(slip.ratio()), extrapolated]
    }
}

impl Parametrised for LinearSlipSinkage {
    const PARAMETERS: &'static [Parameter] = &[Self::GAIN, Self::SKID_GAIN];

    fn from_values(values: &[Option<f64>]) -> Option<Self> {
        let &[gain, skid_gain] = values else { return None };
        Some(Self { gain: gain?, skid_gain })
    }

    fn values(&self) -> Vec<Option<f64>> {
        vec![Some(self.gain), self.skid_gain]
    }
}

impl Declared for LinearSlipSinkage {
    const NAME: &'static str = "linear";
    const DOC: &'static str = "A sinkage that grows linearly with slip.";
    const FORMULA: &'static str = "z = z0 (1 + S s); z0 (1 − S_b s) at s < 0 where S_b is given";
    const SOURCES: &'static [Citation] = &[LINES.at("thesis code"), PAVLOV_JOHNSON.cited()];
}
