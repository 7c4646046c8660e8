//! Where does the rim leave the soil, by the entry angle? At a share of it: θ2 = c3 θ1, as Ding et al. 2015 (source 4) have it.
//!
//! Units: c3 has none. Validity: c3 ≤ 0 behind the lowest point, where the soil rebounds; measured values are small. Lugs carry
//! soil along, so that it stands higher behind the wheel than ahead of it: −1.2 covers the ratios of sinkage that were published
//! (see [`SinkageRatio`](super::SinkageRatio)). No departures; the paper was not read.

use crate::law::Declared;
use crate::numerics::elementary::Number;
use crate::parameter::{Parameter, Parametrised, Presence, Requirement};
use crate::sources::{Citation, DING_2015};

/// An exit at a share of the entry angle.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct AngleRatio {
    /// c3 in θ2 = c3 θ1 (–), from −1.2 up to 1; negative behind the lowest point.
    pub c3: f64,
}

impl AngleRatio {
    /// c3.
    pub const C3: Parameter = Parameter {
        name: "c3",
        symbol: "c3",
        unit: "1",
        meaning: "Exit angle over the entry angle; negative where the contact reaches behind the lowest point.",
        requirement: Requirement::FromUpTo { min: -1.2, limit: 1.0 },
        least: -1.2,
        most: 0.6,
        presence: Presence::Default(0.0),
    };

    #[inline(always)]
    pub(super) fn exit<F: Number>(&self, entry: F, _depth_ratio: F) -> F {
        entry * self.c3
    }

    pub(super) fn entry_of(&self, angle: f64) -> Option<f64> {
        (self.c3 > 0.0).then(|| angle / self.c3)
    }
}

impl Parametrised for AngleRatio {
    const PARAMETERS: &'static [Parameter] = &[Self::C3];

    fn from_values(values: &[Option<f64>]) -> Option<Self> {
        let &[c3] = values else { return None };
        Some(Self { c3: c3? })
    }

    fn values(&self) -> Vec<Option<f64>> {
        vec![Some(self.c3)]
    }
}

impl Declared for AngleRatio {
    const NAME: &'static str = "angle_ratio";
    const DOC: &'static str = "The exit angle is a share of the entry angle.";
    const FORMULA: &'static str = "θ2 = c3 θ1";
    const SOURCES: &'static [Citation] = &[DING_2015.cited()];
}
