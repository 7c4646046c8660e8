//! How do grains answer a plate that moves into them? The two factors α of the resistive force method.
//!
//! | equation | here |
//! |---|---|
//! | α_z = A00 + A10 cos 2β + B11 sin(2β + γ) + B01 sin γ + B−11 sin(−2β + γ) (Li, Zhang & Goldman 2013) | [`Response::of`] |
//! | α_x = C11 cos(2β + γ) + C01 cos γ + C−11 cos(−2β + γ) + D10 sin 2β | [`Response::of`] |
//!
//! β (rad) is the plate's inclination and γ the angle of its motion, down from the direction of travel. On a rim β = −θ, so the
//! functions of 2β follow from those of θ without an angle.

use crate::numerics::elementary::Number;

const A00: f64 = 0.206;
const A10: f64 = 0.169;
const B11: f64 = 0.212;
const B01: f64 = 0.358;
const B_11: f64 = 0.055;
const C11: f64 = -0.124;
const C01: f64 = 0.253;
const C_11: f64 = 0.007;
const D10: f64 = 0.088;

/// Largest |α_z| (–) at a plate that is pushed straight down, β = 0 and γ = π/2: the scale of a normal force.
pub(super) const STRAIGHT_DOWN: f64 = A00 + A10 + B11 + B01 + B_11;

/// Stresses over ξ times the depth (–).
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Response<F = f64> {
    /// α_x, along the travel.
    pub(super) along: F,
    /// α_z, upwards.
    pub(super) up: F,
}

/// Sine and cosine of an angle.
#[derive(Debug, Clone, Copy)]
pub(super) struct Direction<F = f64> {
    pub(super) sin: F,
    pub(super) cos: F,
}

impl<F: Number> Response<F> {
    /// At a place `theta` of the rim, whose β is −θ, that moves in the direction γ.
    #[inline(always)]
    pub(super) fn of(theta: Direction<F>, gamma: Direction<F>) -> Self {
        let sin_2 = theta.sin * theta.cos * -2.0; // sin 2β
        let cos_2 = theta.sin * theta.sin * -2.0 + 1.0; // cos 2β
        // The sums of angles written out: sin(±2β + γ) = ±sin 2β cos γ + cos 2β sin γ, cos(±2β + γ) = cos 2β cos γ ∓ sin 2β sin γ.
        let (sine, cosine) = (cos_2 * gamma.sin, cos_2 * gamma.cos);
        let (turned_sine, turned_cosine) = (sin_2 * gamma.sin, sin_2 * gamma.cos);
        Self {
            along: cosine * (C11 + C_11) - turned_sine * (C11 - C_11) + gamma.cos * C01 + sin_2 * D10,
            up: cos_2 * A10 + sine * (B11 + B_11) + turned_cosine * (B11 - B_11) + gamma.sin * B01 + A00,
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_factors_are_the_published_series() {
        for i in 0..40 {
            let theta = 0.04 * f64::from(i);
            for k in -20..=20 {
                let (beta, gamma) = (-theta, 0.15 * f64::from(k));
                let direction = |angle: f64| Direction { sin: angle.sin(), cos: angle.cos() };
                let Response { along, up } = Response::of(direction(theta), direction(gamma));
                let up_series = A00
                    + A10 * (2.0 * beta).cos()
                    + B11 * (2.0 * beta + gamma).sin()
                    + B01 * gamma.sin()
                    + B_11 * (-2.0 * beta + gamma).sin();
                let along_series = C11 * (2.0 * beta + gamma).cos()
                    + C01 * gamma.cos()
                    + C_11 * (-2.0 * beta + gamma).cos()
                    + D10 * (2.0 * beta).sin();
                assert!((up - up_series).abs() < 1e-15 && (along - along_series).abs() < 1e-15, "{theta}, {gamma}");
            }
        }
    }

    #[test]
    fn a_plate_pushed_straight_down_is_pushed_straight_up() {
        let Response { along, up } = Response::of(Direction { sin: 0.0, cos: 1.0 }, Direction { sin: 1.0, cos: 0.0 });
        assert_eq!((along, up), (0.0, STRAIGHT_DOWN));
    }

    /// A place θ of a rim moves along (sin θ, cos θ − κ): α_z stays above 0 at any κ, so that F_z grows with the sinkage.
    #[test]
    fn grains_push_every_place_of_a_leading_edge_up() {
        for i in 1..=900 {
            let (sin, cos) = (std::f64::consts::FRAC_PI_2 * f64::from(i) / 900.0).sin_cos();
            for k in 0..=400 {
                let share = f64::from(k) / 400.0; // rω over rω + v
                let (down, ahead) = (share * sin, share * cos - (1.0 - share));
                let speed = down.hypot(ahead);
                let gamma = Direction { sin: down / speed, cos: ahead / speed };
                assert!(Response::of(Direction { sin, cos }, gamma).up > 0.0, "{i}, {k}");
            }
        }
    }
}
