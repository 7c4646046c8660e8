//! Where is the stress largest, if half of the sinkage lies above that place? θm = arccos(1 − z/(2r)), which makes the letter's
//! Eq. (8), z(θm) ≈ z/2, exact.
//!
//! Units: z and r in m, θm in rad. Validity: that of Eq. (8), which the letter gives without a range. Departure: the letter uses
//! Eq. (8) as an approximation wherever the peak lies; here the peak is placed so that the equation holds.

use super::{ContactArc, angle_at_depth};
use crate::law::Declared;
use crate::numerics::elementary::Number;
use crate::parameter::{Parameter, Parametrised};
use crate::sources::{Citation, LETTER};

/// The peak where half of the sinkage lies above it.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct HalfSinkage;

impl HalfSinkage {
    #[inline(always)]
    pub(super) fn peak<F: Number>(&self, arc: &ContactArc<F>) -> F {
        angle_at_depth(arc.depth_ratio * 0.5) // Eq. (8)
    }

    /// By 1 − cos θm = (1 − cos θ1)/2.
    #[inline(always)]
    pub(super) fn rate<F: Number>(&self, depth_ratio: F) -> F {
        // (sin θ1)/(2 sin θm), and sin² = (z/r)(2 − z/r) at a depth z.
        ((-depth_ratio + 2.0) / (-depth_ratio + 4.0)).sqrt()
    }
}

impl Parametrised for HalfSinkage {
    const PARAMETERS: &'static [Parameter] = &[];

    fn from_values(values: &[Option<f64>]) -> Option<Self> {
        values.is_empty().then_some(Self)
    }

    fn values(&self) -> Vec<Option<f64>> {
        Vec::new()
    }
}

impl Declared for HalfSinkage {
    const NAME: &'static str = "half_sinkage";
    const DOC: &'static str = "The peak lies where half of the sinkage is above it.";
    const FORMULA: &'static str = "θm = arccos(1 − z/(2r))";
    const SOURCES: &'static [Citation] = &[LETTER.at("Eq. 8")];
}
