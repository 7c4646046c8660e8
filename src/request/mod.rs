//! Requests as they stand on the wire, and what they become: the only place where input is checked and converted.

mod axis;
mod catalogue;
mod compare;
mod contact;
mod coupled;
mod curves;
mod forces;
mod identify;
mod method;
mod motion;
mod operation;
mod pressure_sinkage;
mod refusal;
mod resistances;
mod series;
mod shear;
mod side_slip;
mod slip_sinkage;
mod slip_sweep;
mod soil;
mod stress_profile;
mod towed;
mod track;
mod variants;
mod wheel;

pub(crate) use catalogue::{SoilsDto, WheelsDto};
pub(crate) use compare::{Case, CompareDto, CompareQuery};
pub(crate) use contact::{ContactDto, RULES};
pub(crate) use coupled::{CoupledDto, CoupledQuery};
pub(crate) use curves::{PlatesDto, PlatesQuery, ShearTestsDto, ShearTestsQuery, plates_fault, shear_fault};
pub(crate) use forces::{ForcesDto, ForcesQuery};
pub(crate) use identify::{FitQuery, IdentifyDto, IdentifyQuery, LinearQuery, column_name, fit_fault, name_of, refusal_pointer};
pub(crate) use pressure_sinkage::{LAWS, PressureSinkageDto};
pub(crate) use refusal::{error_fault, error_pointer};
pub(crate) use resistances::{ResistancesDto, ResistancesQuery};
use series::ColumnsDto;
pub(crate) use series::Samples;
pub(crate) use shear::SHEAR_LAWS;
pub(crate) use slip_sinkage::SlipSinkageDto;
pub(crate) use slip_sweep::{SweepDto, SweepQuery};
pub(crate) use soil::SoilDto;
pub(crate) use stress_profile::{ProfileDto, ProfileQuery};
pub(crate) use towed::{TowedDto, TowedQuery};
pub(crate) use track::{TrackDto, TrackPlan, TrackQuery, TrackSettings, checked_settings};
pub(crate) use wheel::WheelDto;

use std::cell::RefCell;

use crate::wire::{Field, FieldFault, Object, Scope, Wire};

/// A request body and the query it stands for.
pub(crate) trait Request: Wire + Object {
    /// The query: valid domain values in SI units.
    type Query: Send + 'static;

    /// Checks everything and reports every fault to `place`; none only where something was reported.
    fn check(&self, place: &Scope<'_>) -> Option<Self::Query>;
}

/// The query of a request body, or all its faults.
pub(crate) fn checked<R: Request>(body: &Field<R>) -> Result<R::Query, Vec<FieldFault>> {
    collected(|root| match body {
        Field::Given(request) => {
            request.report_oddities(root);
            request.check(root)
        }
        Field::Wrong(found) => {
            root.fault(format_args!("the body must be a JSON object, not {found}"));
            None
        }
        Field::Absent => None,
    })
}

/// What `check` makes of a request, or all the faults that it reports.
pub(crate) fn collected<T>(check: impl FnOnce(&Scope<'_>) -> Option<T>) -> Result<T, Vec<FieldFault>> {
    let faults = RefCell::default();
    let checked = check(&Scope::root(&faults));
    let faults = faults.into_inner();
    match checked {
        Some(checked) if faults.is_empty() => Ok(checked),
        _ => Err(faults),
    }
}
