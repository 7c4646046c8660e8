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
use crate::numerics::brent::Sample;
use crate::rolling::{Rolling, WheelOnSoil};
use crate::slip::Slip;
use crate::stress::Stresses;
use crate::wheel::Wheel;

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
    fn direction(&self, chord: f64, sin: f64) -> Direction {
        let (down, ahead) = (self.rim * sin, self.excess - 0.5 * self.rim * chord * chord);
        let speed = (self.excess * self.excess + self.rim * self.axle * chord * chord).sqrt();
        if speed > 0.0 {
            let per_speed = 1.0 / speed;
            Direction { sin: down * per_speed, cos: ahead * per_speed }
        } else {
            Direction { sin: 1.0, cos: 0.0 } // the instant centre of a rolling wheel: the limit from ahead
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
    stiffness: f64,
    pub(crate) radius: f64,
    pub(crate) width: f64,
    /// w1 = 2 sin(θ1/2) (–).
    pub(crate) reach: f64,
    pub(crate) motion: RimMotion,
}

/// A place of the leading edge.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Place {
    /// sin θ and cos θ.
    pub(crate) sin: f64,
    pub(crate) cos: f64,
    /// cos(θ/2) = dw/dθ.
    pub(crate) cos_half: f64,
    /// Depth d (m).
    pub(crate) depth: f64,
    /// σ and τ (Pa).
    pub(crate) stresses: Stresses,
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
    pub(crate) fn at(&self, chord: f64) -> Place {
        let half_square = 0.5 * chord * chord;
        let cos_half = (1.0 - 0.5 * half_square).sqrt();
        let (sin, cos) = (chord * cos_half, 1.0 - half_square);
        let depth = 0.5 * self.radius * (self.reach - chord) * (self.reach + chord);
        let Response { along, up } = Response::of(Direction { sin, cos }, self.motion.direction(chord, sin));
        let pressure = self.stiffness * depth;
        let stresses = Stresses { normal: pressure * (up * cos - along * sin), shear: pressure * (along * cos + up * sin) };
        Place { sin, cos, cos_half, depth, stresses }
    }

    /// The place at `theta` (rad); none outside the edge.
    pub(crate) fn at_angle(&self, theta: f64) -> Option<Place> {
        let chord = 2.0 * (0.5 * theta).sin();
        (theta >= 0.0 && chord <= self.reach).then(|| self.at(chord))
    }

    /// Angle θ (rad) of the largest normal stress: sampled along the edge, closely where γ swings, closed in on by golden section and
    /// at last by a parabola. The stress is flat there, so it has all of its digits where the place has six or so.
    pub(crate) fn peak(&self) -> f64 {
        const SAMPLES: u32 = 16;
        const STEPS: u32 = 11;
        const GOLDEN: f64 = 0.618_033_988_749_894_8;
        let scale = self.motion.layer().clamp(1e-12 * self.reach, 4.0 * self.reach);
        let whole = (self.reach / scale).asinh();
        let chord = |place: f64| (scale * place.sinh()).min(self.reach);
        let sample = |x: f64| Sample { x, y: self.at(chord(x)).stresses.normal };
        let higher = |one: Sample, other: Sample| if other.y > one.y { other } else { one };
        let stride = whole / f64::from(SAMPLES);
        let highest = (1..SAMPLES).map(|i| sample(stride * f64::from(i))).fold(sample(0.0), higher);
        let (mut left, mut right) = ((highest.x - stride).max(0.0), (highest.x + stride).min(whole));
        let (mut low, mut high) = (sample(right - GOLDEN * (right - left)), sample(left + GOLDEN * (right - left)));
        for _ in 0..STEPS {
            if low.y > high.y {
                (right, high) = (high.x, low);
                low = sample(right - GOLDEN * (right - left));
            } else {
                (left, low) = (low.x, high);
                high = sample(left + GOLDEN * (right - left));
            }
        }
        let closest = higher(higher(highest, low), high);
        let vertex = if low.y > high.y { vertex(sample(left), low, high) } else { vertex(low, high, sample(right)) };
        let highest = vertex.map_or(closest, |place| higher(closest, sample(place.clamp(left, right))));
        2.0 * (0.5 * chord(highest.x)).asin()
    }
}

/// Place of the vertex of the parabola through three samples; none through three on a line.
fn vertex(a: Sample, b: Sample, c: Sample) -> Option<f64> {
    let (before, after) = ((b.x - a.x) * (b.y - c.y), (b.x - c.x) * (b.y - a.y));
    let place = b.x - 0.5 * ((b.x - a.x) * before - (b.x - c.x) * after) / (before - after);
    place.is_finite().then_some(place)
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
