//! How do the shear stresses along and across the rim combine, if they share the strength of the soil? (Pavlov & Johnson 2024)
//!
//! At each rim point one shear stress of size (c + σ tan φ)(1 − exp(−√(j_x² + j_y²)/K)) opposes the slip velocity v there. Its
//! components are the shares v_x/|v| along the rim and v_y/|v| across. With the motion of a rim point (see `lateral`),
//! v_x : v_y = 1 − κ cos θ : κ tan β, which is also dj_x : dj_y.
//!
//! Departures: the displacements may scale by different moduli, √((j_x/K_x)² + (j_y/K_y)²); with K_x = K_y this is the
//! published law. The component along the rim takes the sign of j_x, as the letter's E does, not that of v_x. On a driving
//! wheel both signs agree. On a braking wheel j_x changes sign later, once the displacement gathered ahead of the turning point
//! is undone; only with the sign of j_x does the law tend to the uncoupled one as β → 0.

use super::{SlipAngle, ishigami};
use crate::patch::ContactPatch;
use crate::rim::RimPoint;

/// Mobilised shares of the strength along and across the rim. Their root sum of squares is at most the E of the shear law.
pub(super) struct Shares {
    /// Along the rim, positive where the soil pushes the wheel forward.
    pub(super) longitudinal: f64,
    /// Across the rim, without sign.
    pub(super) lateral: f64,
}

/// The shares at a rim point.
#[inline]
pub(super) fn shares(patch: &ContactPatch<'_>, point: &RimPoint, angle: SlipAngle) -> Shares {
    let rolling = patch.rolling;
    if rolling.slip.is_locked() {
        // κ → ∞: v_x : v_y = −cos θ : tan β.
        let speed = point.cos.hypot(angle.steepness());
        let residual = rolling.shear().residual();
        return Shares { longitudinal: -residual * point.cos / speed, lateral: residual * angle.steepness() / speed };
    }
    let along = patch.displacement(point) * rolling.strength.per_shear_scale;
    let across = ishigami::displacement(patch, point, angle) * rolling.per_lateral_modulus();
    let share = rolling.shear().mobilisation(along.hypot(across));
    let (slip, drift) = (patch.slip_velocity(point).abs(), rolling.kinematics.ratio * angle.steepness());
    let speed = slip.hypot(drift);
    if speed > 0.0 {
        Shares { longitudinal: share.copysign(along) * slip / speed, lateral: share * drift / speed }
    } else {
        Shares { longitudinal: share.copysign(along), lateral: 0.0 }
    }
}
