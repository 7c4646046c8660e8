//! Refusals of the model as faults of the request.

use terramechanics::{Error, Parameter, Sinkage};
use terramechanics_reading::FieldFault;

/// The field of a request to which a refusal of the model belongs.
pub(crate) fn error_pointer(error: &Error, sinkage: &Sinkage) -> &'static str {
    match error {
        Error::SinkageOutsideWheel { .. } => match sinkage {
            Sinkage::Given(_) => "/sinkage_m",
            Sinkage::FromStatic { .. } => "/static_sinkage_m",
            Sinkage::CarryingLoad(_) => "/normal_load_n",
        },
        Error::ModulusNotPositive { .. } => "/soil/pressure_sinkage",
        Error::ExponentNotPositive { .. } => "/soil/pressure_sinkage/n0",
        Error::PeakOutsideContact { .. } => "/contact",
        Error::ReversalOutsideContact { .. } | Error::ClosedFormOfTwoZones | Error::SlipAngleOfTwoZones => "/braking",
        Error::LoadNotCoupled { .. } => "/slip",
        Error::LoadBeyondCapacity { .. }
        | Error::LoadTooLight { .. }
        | Error::LoadNotBalanced { .. }
        | Error::NotFreeRolling { .. } => "/normal_load_n",
        Error::OppositeRotation { .. } => "/angular_velocity_rad_s",
        Error::NotFinite => "",
        Error::Invalid(fault) => match fault.parameter {
            Parameter::Slip => "/slip",
            Parameter::SlipAngle => "/slip_angle_rad",
            Parameter::NormalLoad => "/normal_load_n",
            Parameter::Torque => "/torque_n_m",
            Parameter::LambdaA => "/lambda_a",
            Parameter::LambdaB => "/lambda_b",
            _ => "",
        },
    }
}

/// A refusal of the model as a fault of the request.
pub(crate) fn error_fault(error: &Error, sinkage: &Sinkage) -> FieldFault {
    let fault = FieldFault::new(error_pointer(error, sinkage), error);
    match (error, sinkage) {
        (Error::SinkageOutsideWheel { sinkage: value, radius }, way) => {
            let figures = FieldFault { value: Some(*value), maximum: Some(*radius), unit: Some("m"), ..fault };
            match way {
                // The sinkage that was refused is not the number that was sent.
                Sinkage::FromStatic { .. } => {
                    let detail = format!("by the slip–sinkage law at this slip, {}", figures.detail);
                    FieldFault { detail, ..figures }
                }
                _ => figures,
            }
        }
        _ => fault,
    }
}
