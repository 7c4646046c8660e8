//! How does the wheel move? Slip and direction from the velocities of axle and wheel (letter, Eq. 2).

use crate::circles::SlipRadius;
use crate::error::Error;
use crate::parameter::{Parameter, Presence, Requirement};
use crate::slip::Slip;
use crate::wheel::Wheel;

/// Which way the wheel moves along x.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Heading {
    /// Along +x.
    Forward,
    /// Along −x: the mirror image, with the same slip.
    Backward,
}

impl Heading {
    /// A force along x or a torque, measured with this heading, of the wheel that moves forward.
    #[must_use]
    pub fn as_forward(self, value: f64) -> f64 {
        match self {
            Self::Forward => value,
            Self::Backward => -value,
        }
    }
}

/// Velocities of the axle and of the wheel.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Velocities {
    /// Forward velocity v of the axle (m/s).
    pub forward: f64,
    /// Angular velocity ω of the wheel (rad/s), positive when it rolls forward.
    pub angular: f64,
}

impl Velocities {
    /// v.
    pub const FORWARD: Parameter = Parameter {
        name: "forward_velocity_m_s",
        symbol: "v",
        unit: "m/s",
        meaning: "Forward velocity of the axle.",
        requirement: Requirement::Finite,
        least: -1e3,
        most: 1e3,
        presence: Presence::Required,
    };

    /// ω.
    pub const ANGULAR: Parameter = Parameter {
        name: "angular_velocity_rad_s",
        symbol: "ω",
        unit: "rad/s",
        meaning: "Angular velocity of the wheel, positive when it rolls forward.",
        requirement: Requirement::Finite,
        least: -1e4,
        most: 1e4,
        presence: Presence::Required,
    };

    /// What they are made of.
    pub const PARAMETERS: &'static [Parameter] = &[Self::FORWARD, Self::ANGULAR];

    /// The direction in which the wheel moves, if neither has the other's opposite sign.
    #[must_use]
    pub fn heading(&self) -> Heading {
        if self.forward < 0.0 || self.angular < 0.0 { Heading::Backward } else { Heading::Forward }
    }
}

/// Slip and the direction in which the wheel moves.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Motion {
    /// The slip ratio.
    pub slip: Slip,
    /// The direction.
    pub heading: Heading,
    /// Whether the wheel is known to be at rest, v = ω = 0, where a ratio of powers is undefined.
    pub at_rest: bool,
}

impl Motion {
    /// A wheel that moves forward with a slip; its velocities are not known.
    #[must_use]
    pub fn forward(slip: Slip) -> Self {
        Self { slip, heading: Heading::Forward, at_rest: false }
    }

    /// Slip and heading of `wheel` at `velocities`, the slip counted on `circle`. Eq. (2), which has the rim.
    ///
    /// At rest (v = ω = 0) the slip is 0.
    ///
    /// # Errors
    /// [`Error::Invalid`] for a velocity that is not finite, [`Error::OppositeRotation`] where v and ω have opposite signs.
    ///
    /// ```
    /// # use terramechanics::{Heading, Motion, SlipRadius, Velocities, Wheel, WheelParams};
    /// let wheel = Wheel::new(WheelParams { radius: 0.2, width: 0.1, lug_height: 0.05, lug_coefficient: 0.5 })?;
    /// let velocities = Velocities { forward: 0.15, angular: 1.0 };
    /// let motion = Motion::of(&wheel, SlipRadius::Rim, velocities)?;
    /// assert!((motion.slip.ratio() - 0.25).abs() < 1e-15); // 1 − 0.15/(0.2·1)
    /// assert_eq!(motion.heading, Heading::Forward);
    /// let motion = Motion::of(&wheel, SlipRadius::LugTip, velocities)?;
    /// assert!((motion.slip.ratio() - 0.4).abs() < 1e-15); // 1 − 0.15/(0.25·1)
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    pub fn of(wheel: &Wheel, circle: SlipRadius, velocities: Velocities) -> Result<Self, Error> {
        let Velocities { forward, angular } = velocities;
        Velocities::FORWARD.check(forward).map_err(Error::Invalid)?;
        Velocities::ANGULAR.check(angular).map_err(Error::Invalid)?;
        if forward * angular < 0.0 || (forward != 0.0 && angular != 0.0 && forward.signum() != angular.signum()) {
            return Err(Error::OppositeRotation { forward_velocity: forward, angular_velocity: angular });
        }
        let heading = velocities.heading();
        let (axle, rim) = (forward.abs(), (circle.of(wheel) * angular).abs());
        let slip = if axle == rim {
            0.0
        } else if rim > axle {
            (rim - axle) / rim // Eq. (2), driving
        } else {
            (rim - axle) / axle // Eq. (2), braking
        };
        Ok(Self { slip: Slip::new(slip)?, heading, at_rest: axle == 0.0 && angular == 0.0 })
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::wheel::WheelParams;

    fn motion(forward: f64, angular: f64) -> Result<Motion, Error> {
        let wheel = Wheel::new(WheelParams { radius: 0.2, width: 0.1, lug_height: 0.0, lug_coefficient: 0.5 }).expect("a wheel");
        Motion::of(&wheel, SlipRadius::Rim, Velocities { forward, angular })
    }

    #[test]
    fn limits_of_the_definition_are_exact() {
        for (forward, angular, slip) in [(0.0, 0.0, 0.0), (0.0, 3.0, 1.0), (3.0, 0.0, -1.0), (0.5, 2.5, 0.0)] {
            assert_eq!(motion(forward, angular).expect("inside the model").slip.ratio(), slip);
        }
    }

    #[test]
    fn a_wheel_that_turns_backwards_is_the_mirror_image() {
        for (forward, angular) in [(0.1, 1.0), (0.3, 1.0), (0.0, 1.0), (0.1, 0.0)] {
            let ahead = motion(forward, angular).expect("inside the model");
            let back = motion(-forward, -angular).expect("inside the model");
            assert_eq!(ahead.slip, back.slip);
            assert_eq!((ahead.heading, back.heading), (Heading::Forward, Heading::Backward));
        }
    }

    #[test]
    fn opposite_signs_are_refused() {
        assert!(matches!(motion(0.1, -1.0), Err(Error::OppositeRotation { .. })));
        assert!(matches!(motion(-1e-300, 1e-300), Err(Error::OppositeRotation { .. })));
    }

    #[test]
    fn numbers_that_are_not_finite_are_refused() {
        let at_fault = |forward, angular| match motion(forward, angular) {
            Err(Error::Invalid(fault)) => fault.parameter.name,
            other => panic!("{other:?}"),
        };
        assert_eq!(at_fault(f64::NAN, 1.0), "forward_velocity_m_s");
        assert_eq!(at_fault(1.0, f64::INFINITY), "angular_velocity_rad_s");
        assert!(Slip::new(f64::NAN).is_err() && Slip::new(1.0 + 1e-15).is_err() && Slip::new(-1.1).is_err());
    }
}
