#![doc = include_str!("../README.md")]
//!
//! ## The way through
//!
//! Angles are measured at the wheel's centre from straight down, positive towards the front. Slip is −1 (locked) … 0 (rolling) …
//! 1 (spinning on the spot). Numbers of equations are the letter's.
//!
//! A [`Wheel`], a [`Soil`] and a [`Contact`] make a [`WheelOnSoil`]; at a [`Slip`] it is [`Rolling`]; at a sinkage it has a
//! [`ContactPatch`], along which a [`StressField`] lies and on which a [`ForceModel`] finds [`Forces`]. [`Operation`] goes this way
//! in one call for a sinkage that is given, follows from the slip or carries a load, and [`SlipSweep`] goes it for many slips. A
//! wheel that moves at an angle to its plane has a [`SideSlip`] in its [`Method`], and a [`SideForce`] in its forces.
//!
//! A load that is known beside the sinkage takes the place of the sinkage modulus: [`Sinkage::UnderLoad`] and
//! [`ForceModel::forces_under`]. A wheel with lugs has three circles, and [`Circles`] say on which of them displacement and slip are
//! counted.
//!
//! Beside that way: [`Operation::solve_slip`] finds the slip that gives a pull, [`Vehicle`] a rover on a slope, [`WheelOnSoil::solve_towed`] finds the slip and the sinkage of a wheel that is towed and rolls freely,
//! [`Coupled`] finds torque and pull from a load that is measured, [`pull_from_torque()`] the pull from load and torque without a soil,
//! [`Resistances`] are the classical estimates for a load, and a [`Tracker`] follows a wheel over time, one [`Sample`] after another.
//!
//! A soil may lack a law: what needs it says so by [`Error::MissingLaw`].

/// Version of the model.
pub const VERSION: &str = env!("CARGO_PKG_VERSION");

mod abreast;
mod approach;
mod braking;
mod caution;
mod circles;
mod contact;
mod coupled;
mod digits;
mod displacement;
mod errata;
mod error;
mod events;
mod fault;
mod fittable;
mod forces;
mod gravity;
mod known_load;
mod lateral;
mod law;
#[cfg(test)]
mod levels;
mod load;
mod motion;
mod numerics;
mod one_contact;
mod operating_point;
mod operation;
mod outcome;
mod parameter;
mod patch;
mod pressure_sinkage;
mod profile;
mod pull;
mod pull_from_torque;
mod resistances;
mod resistive_force;
mod reversals;
mod rim;
mod rolling;
mod shear;
mod slip;
mod slip_search;
mod slip_sinkage;
mod soil;
mod soil_parameters;
mod solved_slip;
mod sources;
mod strength;
mod stress;
mod sweep;
mod towed;
mod track;
mod vehicle;
mod wheel;
mod zones;

pub use braking::*;
pub use caution::{Caution, CautionKind, TestedRange};
pub use circles::{Circles, ShearDisplacementRadius, SlipRadius};
pub use contact::{
    AngleRatio, Angles, Contact, ContactParams, ExitRule, HalfSinkage, Interface, Midpoint, PeakRule, SinkageRatio, WongReece,
};
pub use coupled::Coupled;
pub use errata::{ERRATA, Erratum};
pub use error::{Error, SoilLaw};
pub use events::{Event, EventKind, Thresholds};
pub use fault::{Fault, InvalidInput, MissingParameters};
pub use fittable::{Fittable, Step, Tolerance};
pub use forces::{Components, ForceModel, Forces, Lambda, Method, NormalStressRadius, PeakDepth, ShapeIntegrals};
pub use gravity::STANDARD_GRAVITY;
pub use known_load::LoadedForces;
pub use lateral::{Bulldozing, ShearCoupling, SideForce, SideSlip, SlipAngle};
pub use law::{Declared, Law};
pub use load::CarriedLoad;
pub use motion::{Heading, Motion, Velocities};
pub use operating_point::{KnownSinkage, NormalStressFrom, OperatingPoint, Sinkage};
pub use operation::Operation;
pub use outcome::{Outcome, cautions, interface_caution, system_cautions};
pub use parameter::{Parameter, Parametrised, Presence, Requirement};
pub use patch::ContactPatch;
pub use pressure_sinkage::*;
pub use profile::StressProfile;
pub use pull::{Nearest, Pull};
pub use pull_from_torque::{CoupledForces, pull_from_torque, torque_against_slip};
pub use resistances::{Lacking, Resistances};
pub use rolling::{Rolling, WheelOnSoil};
pub use shear::*;
pub use slip::Slip;
pub use slip_sinkage::*;
pub use soil::{Soil, SoilParams};
pub use solved_slip::SolvedSlip;
pub use sources::{Citation, LETTER, SOURCES, Source};
pub use stress::{StressField, Stresses};
pub use sweep::{SlipSweep, SweepRow};
pub use towed::Towed;
pub use track::{CautionTally, Channel, CulpritTally, Measured, Sample, SampleMotion, Status, Tally, TrackRow, Tracker};
pub use vehicle::{
    CentreOfMass, Drive, Driven, LargestSlope, OnSlope, SlopeLimit, Station, Turning, UnlikeRut, Unloading, Vehicle,
    VehicleError, VehicleParams, VehicleWheel,
};
pub use wheel::{Wheel, WheelParams};
