//! Steady forces of one rigid wheel, with or without lugs, rolling on deformable soil.
//!
//! The model is that of the letter "Improving engineering models of terramechanics for planetary exploration"; equation
//! numbers in these docs are the letter's. Where its printed equations contain errors, each module says what is computed
//! instead and why.
//!
//! SI units and radians throughout. Angles are measured at the wheel's centre from straight down, positive towards the
//! front. Slip is −1 (locked) … 0 (rolling) … 1 (spinning on the spot).
//!
//! The way through: a [`Wheel`], a [`Soil`] and a [`Contact`] make a [`WheelOnSoil`]; at a [`Slip`] it is [`Rolling`]; at a
//! sinkage it has a [`ContactPatch`], on which a [`ForceModel`] finds [`Forces`]. [`Operation`] goes this way in one call
//! for a sinkage that is given, follows from the slip or carries a load, and [`SlipSweep`] goes it for many slips. A wheel that
//! moves at an angle to its plane has a [`SideSlip`] in its [`Method`], and a [`SideForce`] in its forces.
//!
//! Beside that way: [`WheelOnSoil::solve_towed`] finds the slip and the sinkage of a wheel that is towed and rolls freely,
//! [`Coupled`] finds torque and pull from a load that is measured, [`Resistances`] are the classical estimates for a load, and a
//! [`Tracker`] follows a wheel over time, one [`Sample`] after another.

/// Version of the model.
pub const VERSION: &str = env!("CARGO_PKG_VERSION");

mod braking;
mod caution;
mod contact;
mod coupled;
mod error;
mod events;
mod forces;
mod lateral;
mod load;
mod numerics;
mod operation;
mod pressure_sinkage;
mod profile;
mod resistances;
mod reversals;
mod rolling;
mod shear;
mod slip;
mod slip_sinkage;
mod soil;
mod stress;
mod sweep;
mod towed;
mod track;
mod wheel;

pub use braking::Braking;
pub use caution::{Caution, CautionKind, Outcome, TestedRange, cautions, system_cautions};
pub use contact::{Angles, Contact, ContactParams, PeakRule};
pub use coupled::{Coupled, CoupledForces};
pub use error::{Error, Fault, InvalidInput, Parameter, Requirement};
pub use events::{Event, EventKind, Thresholds};
pub use forces::{Components, ForceModel, Forces, Lambda, Method, NormalStressRadius, PeakDepth, ShapeIntegrals};
pub use lateral::{Bulldozing, ShearCoupling, SideForce, SideSlip, SlipAngle};
pub use load::CarriedLoad;
pub use operation::{OperatingPoint, Operation, Sinkage};
pub use pressure_sinkage::{Bekker, Diameter, Direct, PressureSinkage, Reece, SinkageExponent};
pub use profile::StressProfile;
pub use resistances::{Lacking, Resistances};
pub use rolling::{Rolling, WheelOnSoil};
pub use shear::{JanosiHanamoto, ShearLaw, WongPeak, WongResidual};
pub use slip::{Heading, Motion, Slip, Velocities};
pub use slip_sinkage::{LinearSlipSinkage, SlipSinkage};
pub use soil::{Soil, SoilParams};
pub use stress::{ContactPatch, Stresses};
pub use sweep::{SlipSweep, SweepRow};
pub use towed::Towed;
pub use track::{CautionTally, Channel, CulpritTally, Measured, Sample, SampleMotion, Status, Tally, TrackRow, Tracker};
pub use wheel::{Wheel, WheelParams};
