//! Refusals of the model as faults of the request.

use terramechanics::{Error, KnownSinkage, Nearest, Pull, Sinkage, SoilLaw, WheelOnSoil};
use terramechanics_reading::{FieldFault, Figures};

use super::laws::number;

/// The field of a request to which a refusal of the model belongs.
pub(crate) fn error_pointer(error: &Error, sinkage: &Sinkage) -> &'static str {
    match error {
        Error::SinkageOutsideWheel { .. } => match sinkage {
            Sinkage::Given(_) | Sinkage::UnderLoad { sinkage: KnownSinkage::Given(_), .. } => "/sinkage_m",
            Sinkage::FromStatic { .. } | Sinkage::UnderLoad { .. } => "/static_sinkage_m",
            Sinkage::CarryingLoad(_) => "/normal_load_n",
        },
        Error::ModulusNotPositive { .. } => "/soil/pressure_sinkage",
        Error::ExponentNotPositive { .. } => "/soil/pressure_sinkage/n0",
        Error::PeakOutsideContact { .. } => "/contact",
        Error::InterfaceBeyondSoil { .. } => "/contact/interface",
        Error::ReversalOutsideContact { .. } | Error::ClosedFormOfTwoZones | Error::SlipAngleOfTwoZones => "/braking",
        Error::LoadNotCoupled { .. } => "/slip",
        Error::PullOutOfReach { pull: Pull::Force(_), .. } => "/longitudinal_force_n",
        Error::PullOutOfReach { pull: Pull::Coefficient(_), .. } => "/drawbar_coefficient",
        Error::LoadBeyondCapacity { .. }
        | Error::LoadTooLight { .. }
        | Error::LoadBelowCohesion { .. }
        | Error::LoadNotBalanced { .. }
        | Error::NotFreeRolling { .. } => "/normal_load_n",
        Error::OppositeRotation { .. } => "/angular_velocity_rad_s",
        Error::NotFinite => "",
        Error::MissingLaw(SoilLaw::PressureSinkage) => "/soil/pressure_sinkage",
        Error::MissingLaw(SoilLaw::Shear) => "/soil/shear",
        Error::MissingLaw(SoilLaw::GranularStiffness) => "/soil",
        Error::Invalid(fault) => match fault.parameter.name {
            "slip" => "/slip",
            "slip_angle_rad" => "/slip_angle_rad",
            "normal_load_n" => "/normal_load_n",
            "torque_n_m" => "/torque_n_m",
            "lambda_a" => "/lambda_a",
            "lambda_b" => "/lambda_b",
            _ => "",
        },
    }
}

/// The numbers of a fault of a sinkage that is beyond the wheel.
pub(crate) fn sinkage_figures(sinkage: f64, radius: f64) -> Figures {
    Figures { maximum: Some(radius), maximum_from: Some("/wheel/radius_m"), ..number(&WheelOnSoil::SINKAGE).figures(sinkage) }
}

/// A refusal of the model as a fault of the request.
pub(crate) fn error_fault(error: &Error, sinkage: &Sinkage) -> FieldFault {
    let fault = FieldFault::new(error_pointer(error, sinkage), error);
    match error {
        Error::SinkageOutsideWheel { sinkage: value, radius } => match sinkage {
            Sinkage::Given(_) | Sinkage::UnderLoad { sinkage: KnownSinkage::Given(_), .. } => {
                fault.with(sinkage_figures(*value, *radius))
            }
            // The sinkage that was refused is not the number that was sent.
            Sinkage::FromStatic { .. } | Sinkage::UnderLoad { .. } => {
                FieldFault { detail: format!("by the slip–sinkage law at this slip, {}", fault.detail), ..fault }
            }
            Sinkage::CarryingLoad(_) => fault,
        },
        Error::PullOutOfReach { pull, reached, nearest, .. } => {
            let bound = |is_bound: bool| is_bound.then_some(*reached);
            let (minimum, maximum) = (bound(*nearest == Nearest::Least), bound(*nearest == Nearest::Largest));
            let unit = Some(pull.parameter().unit.into());
            fault.with(Figures { value: Some(pull.value()), minimum, maximum, unit, ..Figures::default() })
        }
        Error::Invalid(refused) => fault.with(number(refused.parameter).figures(refused.value)),
        _ => fault,
    }
}
