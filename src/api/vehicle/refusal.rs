//! Why a rover has no answer, as faults of the request and as warnings of rows.

use terramechanics::{Sinkage, VehicleError};
use terramechanics_reading::{FieldFault, Figures};

use crate::request::error_pointer;
use crate::warning::{Finding, Reason};

/// The field of a rover's request to which a refusal belongs, of stations without soils of their own.
fn pointer(error: &VehicleError) -> &'static str {
    match error {
        VehicleError::Wheel { error, .. } => match error_pointer(error, &Sinkage::CarryingLoad(0.0)) {
            // What is a load, a slip or a sinkage there follows from the rover here.
            "/normal_load_n" => "/mass_kg",
            own if own.starts_with("/soil") || own.starts_with("/contact") || own.starts_with("/lambda") => own,
            _ => "",
        },
        VehicleError::Lifted { .. } | VehicleError::NoBase => "/centre_of_mass",
        VehicleError::NotClimbed { .. } => "/slope_rad",
        VehicleError::NoOrder => "/rut",
        VehicleError::RutByOtherMethod => "/method",
        VehicleError::NoWheels | VehicleError::NothingTogether => "/stations",
        VehicleError::RutAtEqualTorque => "/drive",
        VehicleError::HitchWithoutStatics => "/hitch_height_m",
        VehicleError::TorqueNotHeld { .. } | VehicleError::Stopped => "",
        VehicleError::Invalid(_) => "",
    }
}

/// A refusal as a fault of the request.
pub(super) fn fault(error: &VehicleError, have_own_soil: &[bool]) -> FieldFault {
    let own = pointer(error);
    let place = match error {
        VehicleError::Wheel { station, .. } if have_own_soil.get(*station) == Some(&true) && own.starts_with("/soil") => {
            format!("/stations/{station}{own}")
        }
        VehicleError::TorqueNotHeld { station, .. } => format!("/stations/{station}/torque_n_m"),
        _ => own.to_owned(),
    };
    let fault = FieldFault::new(place, error);
    match error {
        VehicleError::Lifted { load, .. } => {
            fault.with(Figures { value: Some(*load), minimum: Some(0.0), unit: Some("N".into()), ..Figures::default() })
        }
        _ => fault,
    }
}

/// A refusal as what is to be said of rows, or of the largest slope.
pub(super) fn finding(error: &VehicleError) -> Finding {
    match *error {
        VehicleError::NotClimbed { needed, reached, slip, nearest } => Finding::NotClimbed { needed, reached, slip, nearest },
        VehicleError::Lifted { station, load, slope } => Finding::WheelLifts { station, load, slope },
        _ => Finding::NoSolution { reason: Reason::Request(error.to_string()), pointer: pointer(error) },
    }
}
