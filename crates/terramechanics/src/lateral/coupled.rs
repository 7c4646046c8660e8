//! What if a place of the rim can shear the soil in one direction only? (Pavlov & Johnson 2024)
//!
//! One shear stress of size (c + σ tan φ)(1 − exp(−√(j_x² + j_y²)/K)) acts against the slip velocity v of the place, with the
//! components v_x/|v| along the rim and v_y/|v| across. From the motion of the place (see `lateral`), v_x : v_y is
//! 1 − κ cos θ : κ tan β, which is also dj_x : dj_y.
//!
//! Departures. The displacements may scale by different moduli, √((j_x/K_x)² + (j_y/K_y)²); with K_x = K_y that is the
//! published law. The component along the rim has the sign of j_x, as the letter's E has, in place of that of v_x. The two
//! are the same on a driving wheel. On a braking one j_x changes sign only when the displacement gathered ahead is undone,
//! and only with its sign does the law become the uncoupled one as β → 0.

use super::{SlipAngle, ishigami};
use crate::patch::ContactPatch;
use crate::rim::RimPoint;

/// Shares of the strength along and across the rim; the root of the sum of their squares is at most that of the shear law.
pub(super) struct Shares {
    /// Along the rim, positive where the soil pushes the wheel forward.
    pub(super) longitudinal: f64,
    /// Across, without sign.
    pub(super) lateral: f64,
}

/// The shares at a place of the rim.
#[inline]
pub(super) fn shares(patch: &ContactPatch<'_>, point: &RimPoint, angle: SlipAngle) -> Shares {
    let rolling = patch.rolling;
    if rolling.slip.is_locked() {
        // κ without end: v_x : v_y is −cos θ : tan β.
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
