//! Where does the rim leave the soil, if that stands at a known height behind the wheel? At the ratio η of the rear sinkage to the
//! front one: θ2 = −arccos(1 − η z/r) (Ishigami et al. 2007, source 24).
//!
//! Units: η has none. Validity: 0, where the soil does not rebound, to 1.2; 0.1 to 0.3 were published for smooth wheels, and 0.9 to
//! 1.2 for wheels whose lugs carry soil to the rear. At η = 1 both sides of the lowest point are alike. Unlike a share of the entry angle, the ratio does not
//! change with the sinkage. No departures; the paper was not read.

use crate::contact::angle_at_depth;
use crate::law::Declared;
use crate::numerics::elementary::Number;
use crate::parameter::{Parameter, Parametrised, Presence, Requirement};
use crate::sources::{Citation, ISHIGAMI};

/// An exit at a ratio of the rear sinkage to the front one.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct SinkageRatio {
    /// η (–), from 0 to 1.2.
    pub ratio: f64,
}

impl SinkageRatio {
    /// η.
    pub const RATIO: Parameter = Parameter {
        name: "ratio",
        symbol: "η",
        unit: "1",
        meaning: "Ratio of the sinkage behind the wheel to that ahead of it.",
        requirement: Requirement::Within { min: 0.0, max: 1.2 },
        least: 0.0,
        most: 1.2,
        presence: Presence::Required,
    };

    #[inline(always)]
    pub(super) fn exit<F: Number>(&self, _entry: F, depth_ratio: F) -> F {
        -angle_at_depth(depth_ratio * self.ratio)
    }

    pub(super) fn entry_of(&self, _angle: f64) -> Option<f64> {
        None
    }

    /// By 1 − cos θ2 = η (1 − cos θ1).
    #[inline(always)]
    pub(super) fn rate<F: Number>(&self, depth_ratio: F) -> F {
        // tan(θ2/2)/tan(θ1/2), and tan² of half the angle is (z/r)/(2 − z/r) at a depth z.
        -((-depth_ratio + 2.0) * self.ratio / (-(depth_ratio * self.ratio) + 2.0)).sqrt()
    }
}

impl Parametrised for SinkageRatio {
    const PARAMETERS: &'static [Parameter] = &[Self::RATIO];

    fn from_values(values: &[Option<f64>]) -> Option<Self> {
        let &[ratio] = values else { return None };
        Some(Self { ratio: ratio? })
    }

    fn values(&self) -> Vec<Option<f64>> {
        vec![Some(self.ratio)]
    }
}

impl Declared for SinkageRatio {
    const NAME: &'static str = "sinkage_ratio";
    const DOC: &'static str = "The soil behind the wheel reaches up to a share of the sinkage ahead of it.";
    const FORMULA: &'static str = "θ2 = −arccos(1 − η z/r)";
    const SOURCES: &'static [Citation] = &[ISHIGAMI.cited()];
}
