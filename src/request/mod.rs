//! Requests as a client writes them, and what they become: the only place where input is checked and converted.
//!
//! A part of a request (the wheel, the motion, the sinkage) is declared, read and turned into its domain value in one file. A request
//! names its groups of fields and calls their readers.

mod axis;
mod catalogue;
mod compare;
mod coupled;
mod curves;
mod documented;
mod forces;
mod identify;
mod laws;
mod method;
mod motion;
mod operation;
mod preset;
mod refusal;
mod resistances;
mod series;
mod side_slip;
mod sinkage;
mod slip_sweep;
mod soil;
mod stress_profile;
mod system;
mod towed;
mod track;
mod wheel;

pub(crate) use catalogue::{SoilsCase, WheelsCase};
pub(crate) use compare::{CompareCase, Variation};
pub(crate) use coupled::CoupledCase;
pub(crate) use curves::{PlatesCase, ShearTestsCase, plates_fault, shear_fault};
pub(crate) use documented::*;
pub(crate) use forces::ForcesCase;
pub(crate) use identify::{FitCase, IdentifyCase, LinearCase, column_name, fit_fault, refusal_pointer};
pub(crate) use refusal::{error_fault, error_pointer};
pub(crate) use resistances::ResistancesCase;
pub(crate) use series::Samples;
pub(crate) use slip_sweep::SweepCase;
pub(crate) use stress_profile::ProfileCase;
pub(crate) use towed::TowedCase;
pub(crate) use track::{TrackCase, TrackPlan, TrackSettings, checked_settings};

use terramechanics_reading::{FieldFault, Node, Object, Reader, read};

use crate::words::HINTS;

/// A checked request: valid domain values in SI units.
pub(crate) trait Request: Sized + Send + 'static {
    /// What a client may write.
    const OBJECT: &'static Object;

    /// Checks everything and reports every fault; none only where something was reported.
    fn read(object: &Reader<'_>) -> Option<Self>;
}

/// The request in a body or a query, or all its faults.
pub(crate) fn checked<R: Request>(node: &Node<'_>) -> Result<R, Vec<FieldFault>> {
    read(node, R::OBJECT, &HINTS, R::read)
}
