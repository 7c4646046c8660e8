//! How is the soil sheared under a braking wheel, if in the same way as under a driving one? By the letter's displacement (Eq.
//! 6), continued to negative slip: j = r [(θ1 − θ) − κ (sin θ1 − sin θ)].
//!
//! Units: j and r in m, angles in rad, κ has none. Validity: −1 ≤ s < 0; the letter gives no range. Departure: κ = 1/(1 + s)
//! where Eq. (6) prints 1 − s, and E has the sign of j (erratum 11).

use crate::law::Declared;
use crate::parameter::{Parameter, Parametrised};
use crate::sources::{Citation, LETTER};

/// One zone, as under a driving wheel.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct OneZone;

impl OneZone {
    #[inline]
    pub(super) fn reversal(&self, _skid: f64, _tan_friction: f64) -> Option<f64> {
        None
    }
}

impl Parametrised for OneZone {
    const PARAMETERS: &'static [Parameter] = &[];

    fn from_values(values: &[Option<f64>]) -> Option<Self> {
        values.is_empty().then_some(Self)
    }

    fn values(&self) -> Vec<Option<f64>> {
        Vec::new()
    }
}

impl Declared for OneZone {
    const NAME: &'static str = "one_zone";
    const DOC: &'static str = "The displacement of a driving wheel, continued to negative slip.";
    const FORMULA: &'static str = "j = r [(θ1 − θ) − κ (sin θ1 − sin θ)], κ = 1/(1 + s)";
    const SOURCES: &'static [Citation] = &[LETTER.at("Eq. 6")];
}
