//! Why valid parts, put together, have no answer, as data: what is wrong, what a solver reached.

use std::fmt;

use crate::digits::Digits;
use crate::fault::Fault;
use crate::parameter::Parameter;
use crate::pull::{Nearest, Pull};

/// Why valid parts, put together, have no answer.
///
/// It is `Copy` so that a sweep can record a point without a solution at no cost.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Error {
    /// A single value lies outside what the model accepts.
    Invalid(Fault),
    /// The wheel moves against its own rotation (sliding back while driving): outside the model.
    OppositeRotation {
        /// Forward velocity of the axle (m/s).
        forward_velocity: f64,
        /// Angular velocity of the wheel (rad/s).
        angular_velocity: f64,
    },
    /// The sinkage is not in 0 < z ≤ r.
    SinkageOutsideWheel {
        /// The sinkage (m).
        sinkage: f64,
        /// The wheel's radius (m).
        radius: f64,
    },
    /// The pressure–sinkage law gives no resistance on this wheel (for Bekker's law: b ≤ −k_c/k_phi).
    ModulusNotPositive {
        /// The sinkage modulus K_s (Pa/m^N).
        modulus: f64,
    },
    /// N = n0 + n1 s is not positive.
    ExponentNotPositive {
        /// The sinkage exponent N.
        exponent: f64,
    },
    /// The rule puts the peak of the stresses outside the contact.
    PeakOutsideContact {
        /// Entry angle θ1 (rad).
        entry: f64,
        /// Angle of maximum stress θm (rad).
        peak: f64,
        /// Exit angle θ2 (rad).
        exit: f64,
    },
    /// The contact has no room for the two zones of a braking wheel: it skids more than its sinkage allows, or less than its
    /// exit does.
    ReversalOutsideContact {
        /// Entry angle θ1 (rad).
        entry: f64,
        /// Angle θ0 at which the zones part (rad).
        reversal: f64,
        /// Exit angle θ2 (rad).
        exit: f64,
    },
    /// The interface of the rim is stronger than the soil, which would then shear in itself.
    InterfaceBeyondSoil {
        /// The value of the interface that is at fault.
        parameter: &'static Parameter,
        /// Its value, in the unit of the parameter.
        value: f64,
        /// What the soil has.
        soil: f64,
    },
    /// A closed form was asked of a contact of two zones, at whose peak no shear stress acts.
    ClosedFormOfTwoZones,
    /// The force across was asked of a contact of two zones, for which no law is known.
    SlipAngleOfTwoZones,
    /// No skid was found at which the wheel carries the load without a torque.
    NotFreeRolling {
        /// The load asked for (N).
        load: f64,
        /// The slip that came nearest (–).
        slip: f64,
        /// The torque there (N·m).
        torque: f64,
    },
    /// No slip gives the pull that was asked for.
    PullOutOfReach {
        /// The pull asked for.
        pull: Pull,
        /// The pull that comes nearest, in the unit of the one asked for.
        reached: f64,
        /// The slip that gives it (–).
        slip: f64,
        /// How it lies to the pulls of all other slips.
        nearest: Nearest,
    },
    /// The soil does not carry the load at any sinkage up to the wheel's radius.
    LoadBeyondCapacity {
        /// The load asked for (N).
        load: f64,
        /// The largest load carried (N).
        largest: f64,
        /// The sinkage at which that is carried (m).
        sinkage: f64,
    },
    /// A braking wheel with two zones digs itself in so far that it carries more than the load.
    LoadTooLight {
        /// The load asked for (N).
        load: f64,
        /// The least load carried (N).
        least: f64,
        /// The sinkage at which that is carried (m).
        sinkage: f64,
    },
    /// The load balance was not met within the budget of iterations.
    LoadNotBalanced {
        /// The load asked for (N).
        load: f64,
        /// Evaluations of the normal force that were spent.
        iterations: u32,
        /// Normal force minus load at the best sinkage (N).
        residual: f64,
        /// The best sinkage (m).
        sinkage: f64,
    },
    /// A load that is known is carried by cohesion alone: no normal stress is left to follow from it.
    LoadBelowCohesion {
        /// The load (N).
        load: f64,
        /// What cohesion carries (N).
        carries: f64,
    },
    /// No normal stress carries a load, because the shear stress that goes with it pulls the wheel down as much as it supports it.
    LoadNotCoupled {
        /// Support that is left of 1 for the normal stress alone (–).
        support: f64,
    },
    /// The soil has no law of a kind that is needed here.
    MissingLaw(SoilLaw),
    /// The numbers are so large or so small that a result overflows.
    NotFinite,
}

/// A kind of law that a soil may have.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum SoilLaw {
    /// A pressure–sinkage law.
    PressureSinkage,
    /// A shear law.
    Shear,
    /// A granular stiffness, or a bulk density and the friction from which one follows.
    GranularStiffness,
}

impl SoilLaw {
    /// A name for programs.
    #[must_use]
    pub fn name(self) -> &'static str {
        match self {
            Self::PressureSinkage => "pressure_sinkage",
            Self::Shear => "shear",
            Self::GranularStiffness => "granular_stiffness_n_m3",
        }
    }
}

impl fmt::Display for Error {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match *self {
            Self::Invalid(fault) => fault.fmt(f),
            Self::OppositeRotation { forward_velocity, angular_velocity } => write!(
                f,
                "forward velocity {} m/s and angular velocity {} rad/s have opposite signs: a wheel that slides against its \
                 rotation lies outside the model",
                Digits(forward_velocity),
                Digits(angular_velocity)
            ),
            Self::SinkageOutsideWheel { sinkage, radius } => {
                let (sinkage, radius) = (Digits(sinkage), Digits(radius));
                write!(f, "the sinkage {sinkage} m must be greater than 0 and at most the wheel's radius {radius} m")
            }
            Self::ModulusNotPositive { modulus } => {
                write!(f, "the sinkage modulus is {} Pa/m^N on this wheel and must be greater than 0", Digits(modulus))
            }
            Self::ExponentNotPositive { exponent } => {
                write!(f, "the sinkage exponent n0 + n1 s is {} and must be greater than 0", Digits(exponent))
            }
            Self::PeakOutsideContact { entry, peak, exit } => write!(
                f,
                "the angle of maximum stress {} rad must lie strictly between the exit angle {} rad and the entry angle {} rad",
                Digits(peak),
                Digits(exit),
                Digits(entry)
            ),
            Self::ReversalOutsideContact { entry, reversal, exit } => write!(
                f,
                "the two zones of a braking wheel part at {} rad, which must lie strictly between the exit angle {} rad and the \
                 entry angle {} rad; choose another skid or another sinkage",
                Digits(reversal),
                Digits(exit),
                Digits(entry)
            ),
            Self::InterfaceBeyondSoil { parameter, value, soil } => {
                let (name, value, soil) = (parameter.name, Digits(value), Digits(soil));
                write!(f, "the {name} of the interface is {value}; it must be at most that of the soil, {soil}")
            }
            Self::ClosedFormOfTwoZones => {
                write!(
                    f,
                    "a braking wheel with two zones has no closed form, because no shear stress acts at its peak; use the quadrature"
                )
            }
            Self::SlipAngleOfTwoZones => {
                write!(
                    f,
                    "no law is known for the lateral force of a braking wheel with two zones; use one zone with a slip angle"
                )
            }
            Self::NotFreeRolling { load, slip, torque } => write!(
                f,
                "no skid was found at which the wheel carries {} N without a torque: at a slip of {} it still takes {} N·m",
                Digits(load),
                Digits(slip),
                Digits(torque)
            ),
            Self::PullOutOfReach { pull, reached, slip, nearest } => {
                let (asked, unit) = match pull {
                    Pull::Force(force) => (force, " N"),
                    Pull::Coefficient(coefficient) => (coefficient, " of the normal force"),
                };
                let (asked, reached, slip) = (Digits(asked), Digits(reached), Digits(slip));
                write!(f, "no slip gives a pull of {asked}{unit}: {} is {reached}{unit}, at a slip of {slip}", nearest.in_words())
            }
            Self::LoadBeyondCapacity { load, largest, sinkage } => write!(
                f,
                "the soil does not carry {} N: the largest load it carries is {} N, at a sinkage of {} m",
                Digits(load),
                Digits(largest),
                Digits(sinkage)
            ),
            Self::LoadTooLight { load, least, sinkage } => write!(
                f,
                "a wheel that brakes like this with two zones digs in by at least {} m, where the soil carries {} N, more than the load {} N",
                Digits(sinkage),
                Digits(least),
                Digits(load)
            ),
            Self::LoadNotBalanced { load, iterations, residual, sinkage } => write!(
                f,
                "no sinkage was found that carries {} N: after {iterations} evaluations the best is {} m, off by {} N",
                Digits(load),
                Digits(sinkage),
                Digits(residual)
            ),
            Self::LoadBelowCohesion { load, carries } => {
                let (load, carries) = (Digits(load), Digits(carries));
                write!(f, "the load {load} N must be greater than the {carries} N that cohesion carries at this slip and sinkage")
            }
            Self::LoadNotCoupled { support } => write!(
                f,
                "no normal stress carries a load here: with the shear stress of this braking wheel only {} is left of each newton \
                 that the normal stress supports",
                Digits(support)
            ),
            Self::MissingLaw(SoilLaw::PressureSinkage) => write!(f, "the soil has no pressure–sinkage law"),
            Self::MissingLaw(SoilLaw::Shear) => write!(f, "the soil has no shear law"),
            Self::MissingLaw(SoilLaw::GranularStiffness) => {
                write!(f, "the soil has no granular stiffness, nor a bulk density and a friction angle above 0 that give one")
            }
            Self::NotFinite => write!(f, "the result overflows: the inputs are too large or too small together"),
        }
    }
}

impl std::error::Error for Error {}
