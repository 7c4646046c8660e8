//! The request of `/v1/forces`.

use terramechanics::{Motion, Operation};

use super::method::MethodEntries;
use super::motion::MotionEntries;
use super::operation::{self, OperationEntries, operation_entries};
use super::side_slip::{self, SideSlipEntries};
use super::{ContactDto, Request, SlipSinkageDto, SoilDto, WheelDto};
use crate::wire::{Lambda, Scope, wire_object};

wire_object! {
    /// One operating point: a wheel on a soil at one slip (`slip`, or both velocities) and one sinkage (exactly one of `sinkage_m`, `static_sinkage_m`, `normal_load_n`).
    ForcesDto as "ForcesRequest" {
        wheel: WheelDto = operation::WHEEL,
        soil: SoilDto = operation::SOIL,
        contact: ContactDto = operation::CONTACT,
        slip: f64 = operation::SLIP,
        forward_velocity_m_s: f64 = operation::FORWARD_VELOCITY,
        angular_velocity_rad_s: f64 = operation::ANGULAR_VELOCITY,
        sinkage_m: f64 = operation::SINKAGE,
        static_sinkage_m: f64 = operation::STATIC_SINKAGE,
        slip_sinkage: SlipSinkageDto = operation::SLIP_SINKAGE,
        normal_load_n: f64 = operation::NORMAL_LOAD,
        method: String = operation::METHOD,
        normal_stress_radius: String = operation::NORMAL_STRESS_RADIUS,
        peak_sinkage: String = operation::PEAK_SINKAGE,
        braking: String = operation::BRAKING,
        lambda_a: Lambda = operation::LAMBDA_A,
        lambda_b: Lambda = operation::LAMBDA_B,
        slip_angle_rad: f64 = side_slip::SLIP_ANGLE,
        shear_coupling: String = side_slip::SHEAR_COUPLING,
        bulldozing: String = side_slip::BULLDOZING,
    }
}

/// One operating point, checked.
pub(crate) struct ForcesQuery {
    pub(crate) operation: Operation,
    pub(crate) motion: Motion,
}

impl Request for ForcesDto {
    type Query = ForcesQuery;

    fn check(&self, place: &Scope<'_>) -> Option<ForcesQuery> {
        let checked = OperationEntries {
            method: Some(MethodEntries { method: self.method(), lambda_a: self.lambda_a(), lambda_b: self.lambda_b() }),
            side_slip: Some(SideSlipEntries {
                slip_angle: self.slip_angle_rad(),
                shear_coupling: self.shear_coupling(),
                bulldozing: self.bulldozing(),
            }),
            ..operation_entries!(self)
        }
        .check(place);
        let wheel = checked.as_ref().map(|checked| &checked.operation.system.wheel);
        let motion = MotionEntries {
            slip: self.slip(),
            forward_velocity: self.forward_velocity_m_s(),
            angular_velocity: self.angular_velocity_rad_s(),
        }
        .check(place, wheel);
        Some(ForcesQuery { operation: checked?.operation, motion: motion? })
    }
}
