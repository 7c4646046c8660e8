//! Which stresses act on the part of the rim that moves into the grains?
//!
//! The leading edge of a rigid wheel is exactly 0 < θ < θ1: there each piece of the rim moves towards its outside. A place is told
//! by its chord w = 2 sin(θ/2) from the lowest point: cos θ = 1 − w²/2, the depth r (w1² − w²)/2 and the speed of the place follow
//! from it by powers and one root, without cancellation at a small sinkage or near rolling.
//!
//! The place moves with (a sin θ, a cos θ − b) over the faster of rim and axle, where a and b are the speeds of rim and axle over
//! that, so a − b = s on a wheel without lugs, braking or driving. Its size is √(s² + a b w²), which turns from |s| to √(a b) w at
//! the chord |s|/√(a b): within that layer at the lowest point γ swings by up to π/2, and at s = 0, where the layer has no width, γ
//! is π/2 at the lowest point itself.

use super::response::{Direction, Response, STRAIGHT_DOWN};
use crate::circles::{Circles, Kinematics, ShearDisplacementRadius};
use crate::error::{Error, SoilLaw};
use crate::numerics::elementary::Number;
use crate::rolling::{Rolling, WheelOnSoil};
use crate::slip::Slip;
use crate::stress::Stresses;
use crate::wheel::Wheel;

/// Width of a layer over the contact below which it does not count: its share of the forces is about that.
const THINNEST: f64 = 1e-12;

/// Width of a layer over the contact above which the chord itself is as good a variable.
const WIDEST: f64 = 4.0;

/// How the rim moves: speeds over the faster of rim and axle.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct RimMotion {
    /// Of the rim against the axle, a.
    rim: f64,
    /// Of the axle, b.
    axle: f64,
    /// a − b.
    excess: f64,
}

impl RimMotion {
    /// At `slip` as it is counted, from κ = v/(rω), infinite for a locked wheel, and 1 − κ.
    #[inline]
    fn of(wheel: &Wheel, circles: Circles, slip: Slip) -> Self {
        let on_rim = Circles { shear_displacement: ShearDisplacementRadius::Rim, ..circles };
        let Kinematics { ratio, complement, .. } = Kinematics::of(on_rim, wheel, slip);
        if ratio <= 1.0 {
            Self { rim: 1.0, axle: ratio, excess: complement }
        } else if ratio < f64::INFINITY {
            Self { rim: 1.0 / ratio, axle: 1.0, excess: complement / ratio }
        } else {
            Self { rim: 0.0, axle: 1.0, excess: -1.0 }
        }
    }

    /// Direction γ of the place of the rim at a chord w (–), with its sin θ.
    #[inline(always)]
    fn direction<F: Number>(&self, chord: F, sin: F) -> Direction<F> {
        let square = chord * chord;
        let (down, ahead) = (sin * self.rim, square * (-0.5 * self.rim) + self.excess);
        let speed = (square * (self.rim * self.axle) + self.excess * self.excess).sqrt();
        let per_speed = speed.like(1.0) / speed;
        let still = -speed; // not negative at the instant centre of a rolling wheel: there γ is its limit from ahead
        Direction {
            sin: still.if_not_negative(speed.like(1.0), down * per_speed),
            cos: still.if_not_negative(speed.like(0.0), ahead * per_speed),
        }
    }

    /// Chord (–) within which γ swings; infinite where it does not.
    #[inline]
    pub(crate) fn layer(&self) -> f64 {
        self.excess.abs() / (self.rim * self.axle).sqrt()
    }
}

/// The leading edge of a wheel in grains.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct LeadingEdge {
    /// ξ (N/m³).
    pub(crate) stiffness: f64,
    pub(crate) radius: f64,
    pub(crate) width: f64,
    /// w1 = 2 sin(θ1/2) (–).
    pub(crate) reach: f64,
    pub(crate) motion: RimMotion,
}

/// A place of the leading edge.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Place<F = f64> {
    /// sin θ and cos θ.
    pub(crate) sin: F,
    pub(crate) cos: F,
    /// cos(θ/2) = dw/dθ.
    pub(crate) cos_half: F,
    /// Depth d (m).
    pub(crate) depth: F,
    /// σ/(ξ d) and τ/(ξ d) (–).
    pub(crate) normal: F,
    pub(crate) shear: F,
}

impl LeadingEdge {
    /// The edge of a wheel at `sinkage` z (m).
    ///
    /// # Errors
    /// [`Error::SinkageOutsideWheel`] unless 0 < z ≤ r; [`Error::MissingLaw`] where the soil has no granular stiffness.
    #[inline]
    pub(crate) fn of(rolling: &Rolling<'_>, sinkage: f64) -> Result<Self, Error> {
        Ok(Self { stiffness: stiffness(rolling.system)?, ..Self::of_unit_stiffness(rolling, sinkage)? })
    }

    /// The same in a soil of ξ = 1 N/m³.
    ///
    /// # Errors
    /// [`Error::SinkageOutsideWheel`] unless 0 < z ≤ r.
    #[inline]
    pub(crate) fn of_unit_stiffness(rolling: &Rolling<'_>, sinkage: f64) -> Result<Self, Error> {
        let wheel = &rolling.system.wheel;
        let (radius, width) = (wheel.radius(), wheel.width());
        if !(sinkage > 0.0 && sinkage <= radius) {
            return Err(Error::SinkageOutsideWheel { sinkage, radius });
        }
        let motion = RimMotion::of(wheel, rolling.system.contact.circles(), rolling.slip);
        Ok(Self { stiffness: 1.0, radius, width, reach: (2.0 * sinkage / radius).sqrt(), motion })
    }

    /// The place at a chord w (–) from the lowest point.
    #[inline(always)]
    pub(crate) fn at<F: Number>(&self, chord: F) -> Place<F> {
        let half_square = chord * chord * 0.5;
        let cos_half = (-(half_square * 0.5) + 1.0).sqrt();
        let (sin, cos) = (chord * cos_half, -half_square + 1.0);
        let depth = (-chord + self.reach) * (chord + self.reach) * (0.5 * self.radius);
        let Response { along, up } = Response::of(Direction { sin, cos }, self.motion.direction(chord, sin));
        Place { sin, cos, cos_half, depth, normal: up * cos - along * sin, shear: along * cos + up * sin }
    }

    /// Width e (–) of the layer that points crowd in by w = e sinh u, kept between the widths that count, and the range of u.
    #[inline]
    pub(crate) fn crowding(&self) -> (f64, f64) {
        let scale = self.motion.layer().clamp(THINNEST * self.reach, WIDEST * self.reach);
        let end = self.reach / scale; // at least a quarter, so that the sum keeps the digits of its logarithm
        (scale, (end + (end * end + 1.0).sqrt()).ln())
    }

    /// The place at `theta` (rad); none outside the edge.
    pub(crate) fn at_angle(&self, theta: f64) -> Option<Place> {
        let chord = 2.0 * (0.5 * theta).sin();
        (theta >= 0.0 && chord <= self.reach).then(|| self.at(chord))
    }

    /// The stresses (Pa) at a place.
    pub(crate) fn stresses(&self, place: &Place) -> Stresses {
        let pressure = self.stiffness * place.depth;
        Stresses { normal: pressure * place.normal, shear: pressure * place.shear }
    }
}

/// ξ (N/m³) of the soil.
///
/// # Errors
/// [`Error::MissingLaw`] where it has none, or none above 0: without friction there are no grains that hold.
#[inline]
fn stiffness(system: &WheelOnSoil) -> Result<f64, Error> {
    let known = system.soil.granular_stiffness().filter(|stiffness| *stiffness > 0.0);
    known.ok_or(Error::MissingLaw(SoilLaw::GranularStiffness))
}

/// Pressure per depth (N/m³) under a flat plate: the modulus of a Bekker soil that carries about as much.
///
/// # Errors
/// As [`LeadingEdge::of`].
pub(crate) fn equivalent_modulus(system: &WheelOnSoil) -> Result<f64, Error> {
    // On the way from the entry to the lowest point the response falls off from that of straight down.
    const MEAN: f64 = 0.5;
    Ok(MEAN * STRAIGHT_DOWN * stiffness(system)?)
}
