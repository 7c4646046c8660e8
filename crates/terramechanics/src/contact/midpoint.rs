//! Where is the stress largest, if nobody measured it? In the middle of the contact (Shibly et al. 2005, source 16):
//! θm = (θ1 + θ2)/2.
//!
//! Units: angles in rad. Validity: a simplification for the closed forms, which makes both sides of the peak equally long. No
//! departures.

use super::ContactArc;
use crate::law::Declared;
use crate::numerics::elementary::Number;
use crate::parameter::{Parameter, Parametrised};
use crate::sources::{Citation, SHIBLY};

/// The peak at the midpoint of the contact.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Midpoint;

impl Midpoint {
    #[inline(always)]
    pub(super) fn peak<F: Number>(&self, arc: &ContactArc<F>) -> F {
        (arc.entry + arc.exit) * 0.5
    }

    #[inline(always)]
    pub(super) fn rate<F: Number>(&self, exit_rate: F) -> F {
        (exit_rate + 1.0) * 0.5
    }
}

impl Parametrised for Midpoint {
    const PARAMETERS: &'static [Parameter] = &[];

    fn from_values(values: &[Option<f64>]) -> Option<Self> {
        values.is_empty().then_some(Self)
    }

    fn values(&self) -> Vec<Option<f64>> {
        Vec::new()
    }
}

impl Declared for Midpoint {
    const NAME: &'static str = "midpoint";
    const DOC: &'static str = "The peak lies at the midpoint of the contact.";
    const FORMULA: &'static str = "θm = (θ1 + θ2)/2";
    const SOURCES: &'static [Citation] = &[SHIBLY.cited()];
}
