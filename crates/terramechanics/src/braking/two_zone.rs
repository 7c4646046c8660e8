//! Which way is the soil sheared under a towed or braking wheel? Wong & Reece 1967, part II, source 21.
//!
//! The flow of the soil separates at the angle θ0. Ahead of θ0 the soil flows up and forward and the rim moves backward over
//! it, so the shear pushes the wheel forward. Behind θ0 the rim is dragged forward over the soil, so the shear brakes. σ is
//! largest at θ0.
//!
//! | quantity | here |
//! |---|---|
//! | tan(π/4 − φ/2) = (cos θ0 − (1 + s))/sin θ0 | [`TwoZone::reversal`] |
//! | the displacements in both zones | `zones.rs` |
//!
//! The paper's skid is i = v/(rω) − 1, so its 1 + i is κ = 1/(1 + s) here. The condition was not read in the paper: one public
//! implementation quotes it (Madsen 2013). What was derived and checked: with m = tan(π/4 − φ/2) it has the closed form
//! θ0 = arccos((1 + s) cos β) − β, β = π/4 − φ/2, which rises from 0 at s = 0 to π/4 + φ/2 on the locked wheel.
//!
//! On a wheel with lugs the soil is sheared on the circle of the displacement, so 1 + s is that circle's 1/κ (`circles.rs`): a wheel
//! whose rim skids a little and whose shearing circle does not has one zone.
//!
//! Units: angles in rad, s has none. Validity: θ2 < θ0 < θ1. A wheel that brakes harder than its sinkage allows is refused: the
//! peak of σ would be at the entry, and σ vanishes as θ0 nears θ1. θ0 does not depend on the sinkage, so the least sinkage
//! grows with skid: the wheel digs itself in. As s → 0 the largest stress moves to the lowest point and all shear points
//! forward. The rolling wheel of the other law is different, so results jump at s = 0. Madsen uses the law for skids above 5 %.
//!
//! Departure: the exit angle is that of the contact (the paper: θ2 = 0).

use crate::law::Declared;
use crate::parameter::{Parameter, Parametrised};
use crate::sources::{Citation, WONG_REECE_TOWED};

/// Two zones, which part at θ0.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct TwoZone;

impl TwoZone {
    /// θ0 of a wheel that skids.
    #[inline]
    pub(super) fn reversal(&self, skid: f64, tan_friction: f64) -> Option<f64> {
        if skid > 0.0 { Some(reversal(skid, tan_friction)) } else { None }
    }
}

impl Parametrised for TwoZone {
    const PARAMETERS: &'static [Parameter] = &[];

    fn from_values(values: &[Option<f64>]) -> Option<Self> {
        values.is_empty().then_some(Self)
    }

    fn values(&self) -> Vec<Option<f64>> {
        Vec::new()
    }
}

impl Declared for TwoZone {
    const NAME: &'static str = "two_zone";
    const DOC: &'static str = "The towed wheel of Wong & Reece, whose shear reverses at the peak of the stresses.";
    const FORMULA: &'static str = "θ0 = arccos((1 + s) cos β) − β, β = π/4 − φ/2";
    const SOURCES: &'static [Citation] = &[WONG_REECE_TOWED.cited()];
}

/// θ0 (rad) at a skid −s above 0.
///
/// With t = tan(θ0/2) the condition is (2 + s) t² + 2 m t + s = 0, whose positive root has no cancellation.
#[cold]
#[inline(never)]
fn reversal(skid: f64, tan_friction: f64) -> f64 {
    let m = 1.0 / (tan_friction + tan_friction.hypot(1.0)); // tan(π/4 − φ/2)
    2.0 * (skid / (m + (m * m + skid * (2.0 - skid)).sqrt())).atan()
}
