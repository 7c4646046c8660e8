//! Why a rover has no answer, as data.

use std::fmt;

use crate::digits::Digits;
use crate::error::Error;
use crate::fault::Fault;
use crate::pull::Nearest;

/// Why a rover has no answer.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum VehicleError {
    /// A value lies outside its range.
    Invalid(Fault),
    /// The rover has no wheels.
    NoWheels,
    /// All wheels stand at one place, or at unknown ones: they cannot hold the moment of the centre of mass.
    NoBase,
    /// Which wheel follows which is not known, because the wheels stand at unknown places.
    NoOrder,
    /// Wheels in ruts are computed by the quadrature with one zone of braking only.
    RutByOtherMethod,
    /// Wheels in ruts are not computed at equal torques, where each wheel would depend on all others.
    RutAtEqualTorque,
    /// Every wheel turns at a slip or under a torque of its own: nothing is left to meet the pull.
    NothingTogether,
    /// A hitch has a height but the rover no centre of mass, so that its loads are equal whatever the height.
    HitchWithoutStatics,
    /// No slip gives the torque that a wheel has to hold.
    TorqueNotHeld {
        /// Index of its station.
        station: usize,
        /// The torque (N·m).
        torque: f64,
        /// The torque that comes nearest (N·m).
        reached: f64,
        /// The slip that gives it (–).
        slip: f64,
        /// How it lies to the torques of all other slips.
        nearest: Nearest,
    },
    /// A wheel would have to pull the rover down: it lifts off.
    Lifted {
        /// Index of its station.
        station: usize,
        /// The load that statics ask for (N).
        load: f64,
        /// The slope (rad).
        slope: f64,
    },
    /// No slip gives the pull that the slope and the hitch need.
    NotClimbed {
        /// The pull needed (N).
        needed: f64,
        /// The pull that comes nearest (N).
        reached: f64,
        /// The slip that gives it (–).
        slip: f64,
        /// How it lies to the pulls of all other slips.
        nearest: Nearest,
    },
    /// The caller does not want the result any more.
    Stopped,
    /// The model refuses a wheel.
    Wheel {
        /// Index of its station.
        station: usize,
        /// Why.
        error: Error,
    },
}

impl fmt::Display for VehicleError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match *self {
            Self::Invalid(fault) => fault.fmt(f),
            Self::NoWheels => write!(f, "the rover has no wheels"),
            Self::NoBase => {
                write!(
                    f,
                    "a centre of mass needs stations at two places at least, because wheels at one place cannot hold its moment"
                )
            }
            Self::NoOrder => {
                write!(f, "ruts need stations with their places, which tell the wheel that follows from the one before")
            }
            Self::RutByOtherMethod => {
                write!(f, "wheels in ruts are computed by the quadrature with one zone of braking only")
            }
            Self::RutAtEqualTorque => write!(f, "wheels in ruts are not computed at equal torques"),
            Self::NothingTogether => {
                write!(f, "at least one wheel has to be without a slip or torque of its own, so that its slip can meet the pull")
            }
            Self::HitchWithoutStatics => {
                write!(f, "has an effect only beside a centre of mass, without which the loads are equal")
            }
            Self::TorqueNotHeld { station, torque, reached, slip, nearest } => write!(
                f,
                "no slip of the wheel of station {station} gives a torque of {} N·m: {} is {} N·m, at a slip of {}",
                Digits(torque),
                nearest.in_words(),
                Digits(reached),
                Digits(slip)
            ),
            Self::Lifted { station, load, slope } => write!(
                f,
                "the wheel of station {station} lifts off on a slope of {} rad: the others could hold the rover only if the ground \
                 pulled it down with {} N",
                Digits(slope),
                Digits(-load)
            ),
            Self::NotClimbed { needed, reached, slip, nearest } => write!(
                f,
                "no slip gives the {} N that slope and hitch need: {} pull is {} N, at a slip of {}",
                Digits(needed),
                nearest.in_words(),
                Digits(reached),
                Digits(slip)
            ),
            Self::Stopped => write!(f, "the computation was stopped"),
            Self::Wheel { station, error } => write!(f, "wheel of station {station}: {error}"),
        }
    }
}

impl std::error::Error for VehicleError {}
