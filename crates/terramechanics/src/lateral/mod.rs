//! What does the soil do to a wheel that moves at an angle to its own plane?
//!
//! Axes: x ahead in the plane of the wheel, y to its left, z up, origin at the axle. Forces and moments are those of the
//! soil on the wheel; a moment is positive by the right-hand rule about its axis.
//!
//! Signs. The slip angle β is measured from the velocity to the heading, counterclockwise seen from above: at β > 0 the wheel
//! moves to its right, v_y = −|v_x| tan β. The lateral force opposes the sideways motion, so F_y has the sign of β, as Ishigami
//! prints it.
//!
//! What a place of the rim does to the soil. With κ = v_x/(rω), it moves against the soil at rω (1 − κ cos θ) backwards
//! along the rim and at rω κ tan β sideways. It came in at θ1 a time (θ1 − θ)/ω ago, so it has gone sideways by
//! j_y = r κ (θ1 − θ) tan β. A driving wheel has κ = 1 − s, which is the printed formula; a braking one 1/(1 + s), as its
//! displacement along the rim has. With lugs r and θ1 are those of the circle on which j is counted; v_x/ω = r κ is the same.
//!
//! | part | here |
//! |---|---|
//! | lateral shear stress and side wall (Ishigami et al. 2005, 2007) | `ishigami` |
//! | one shear stress along the slip velocity (Pavlov & Johnson 2024) | `coupled` |

mod coupled;
mod ishigami;

pub(crate) use ishigami::SideWall;

use crate::error::Error;
use crate::parameter::{Parameter, Presence, Requirement};
use crate::patch::ContactPatch;
use crate::rim::RimPoint;

/// Angle β (rad) from the velocity of the wheel to its heading, positive where the wheel moves to its right.
#[derive(Debug, Clone, Copy, PartialEq, PartialOrd)]
pub struct SlipAngle {
    angle: f64,
    tan: f64,
}

impl SlipAngle {
    /// A wheel that goes straight ahead.
    pub const STRAIGHT: Self = Self { angle: 0.0, tan: 0.0 };

    /// Largest size (rad). At π/2 the wheel does not move in its own plane, and neither slip nor tan β says how fast it moves.
    /// The bound stays 4° away from that.
    pub const LARGEST: f64 = 1.5;

    /// β.
    pub const ANGLE: Parameter = Parameter {
        name: "slip_angle_rad",
        symbol: "β",
        unit: "rad",
        meaning: "Slip angle, from the velocity of the wheel to its heading; positive where it moves to its right.",
        requirement: Requirement::Within { min: -Self::LARGEST, max: Self::LARGEST },
        least: -Self::LARGEST,
        most: Self::LARGEST,
        presence: Presence::Optional,
    };

    /// Checks the angle (rad).
    ///
    /// # Errors
    /// [`Error::Invalid`] unless it is within ±[`SlipAngle::LARGEST`].
    pub fn new(angle: f64) -> Result<Self, Error> {
        let angle = Self::ANGLE.check(angle).map_err(Error::Invalid)?;
        Ok(Self { angle, tan: angle.tan() })
    }

    /// The angle β (rad).
    #[must_use]
    pub fn angle(self) -> f64 {
        self.angle
    }

    /// |tan β|.
    pub(crate) fn steepness(self) -> f64 {
        self.tan.abs()
    }

    /// 1, −1, or 0 for a wheel that goes straight ahead: the sign of F_y.
    pub(crate) fn sign(self) -> f64 {
        if self.angle == 0.0 { 0.0 } else { self.angle.signum() }
    }
}

/// How the shear stresses along and across the wheel share the strength of the soil.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum ShearCoupling {
    /// Each follows its own displacement, as if the other were absent: Ishigami et al. 2007. Together they may exceed the
    /// strength by a factor of up to √2.
    Independent,
    /// One stress along the slip velocity: Pavlov & Johnson 2024. It never exceeds the strength.
    Coupled,
}

/// How much of the pressure on the side wall acts.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Bulldozing {
    /// All of it, however little the wall has moved: Ishigami et al. 2007. The lateral force then does not vanish with the slip
    /// angle, nor when the wheel spins on the spot.
    Full,
    /// The share that the shear law mobilises at the sideways displacement j_y. This departure from the paper vanishes without
    /// sideways motion and tends to the full pressure with it.
    Mobilised,
}

/// Motion at an angle to the plane of the wheel, and the laws for the forces that follow.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct SideSlip {
    /// The slip angle.
    pub angle: SlipAngle,
    /// How the shear stresses are coupled.
    pub coupling: ShearCoupling,
    /// How much of the pressure on the side wall acts.
    pub bulldozing: Bulldozing,
}

impl SideSlip {
    /// Ishigami's model at `angle`.
    #[must_use]
    pub fn independent(angle: SlipAngle) -> Self {
        Self { angle, coupling: ShearCoupling::Independent, bulldozing: Bulldozing::Full }
    }

    /// E_y (–): the share of the strength that is mobilised across the wheel, without sign.
    #[inline]
    pub(crate) fn lateral_share(&self, patch: &ContactPatch<'_>, point: &RimPoint) -> f64 {
        match self.coupling {
            ShearCoupling::Independent => ishigami::lateral_share(patch, point, self.angle),
            ShearCoupling::Coupled => coupled::shares(patch, point, self.angle).lateral,
        }
    }

    /// E_x (–) of the coupled stress, with its sign.
    #[inline]
    pub(crate) fn coupled_longitudinal_share(&self, patch: &ContactPatch<'_>, point: &RimPoint) -> f64 {
        coupled::shares(patch, point, self.angle).longitudinal
    }

    /// Share of the side-wall pressure that is mobilised at a rim point (–).
    #[inline]
    pub(crate) fn bulldozing_share(&self, patch: &ContactPatch<'_>, point: &RimPoint) -> f64 {
        ishigami::lateral_share(patch, point, self.angle)
    }

    /// Arc (rad) behind the entry over which the shares build up.
    pub(crate) fn layer(&self, patch: &ContactPatch<'_>) -> f64 {
        let lateral = ishigami::layer(patch, self.angle);
        match self.coupling {
            ShearCoupling::Independent => lateral,
            ShearCoupling::Coupled => 1.0 / (1.0 / lateral).hypot(1.0 / patch.shear_layer()),
        }
    }
}

/// Force across the wheel and its moments about the axle.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct SideForce {
    /// Lateral force F_y (N), to the left.
    pub lateral: f64,
    /// Overturning moment M_x (N·m) about the forward axis: r F_y as published, with the force at the lowest point of the rim.
    pub overturning_moment: f64,
    /// Aligning moment M_z (N·m) about the vertical axis: the integral of the lateral stress times its lever arm.
    pub aligning_moment: f64,
    /// Part of F_y from the shear stress (N).
    pub shear: f64,
    /// Part of F_y from the pressure on the side wall (N); none where the soil's unit weight is not known.
    pub bulldozing: Option<f64>,
    /// Share of the full side-wall pressure that the sideways displacement mobilises (–); 1 where there is no such pressure.
    pub mobilised_share: f64,
}

impl SideForce {
    /// The force on the mirror image of the wheel, which moves backward: the lever arms along x change sign.
    #[must_use]
    pub(crate) fn mirrored(self) -> Self {
        Self { aligning_moment: -self.aligning_moment, ..self }
    }

    pub(crate) fn is_finite(&self) -> bool {
        [self.lateral, self.overturning_moment, self.aligning_moment].iter().all(|value| value.is_finite())
    }
}
