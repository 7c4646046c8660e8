//! The request of `/v1/slip-sweep`.

use terramechanics::{Operation, Slip};

use super::axis::{SlipAxis, SlipAxisSpec};
use super::method::MethodEntries;
use super::operation::{self, OperationEntries, operation_entries};
use super::side_slip::{self, SideSlipEntries};
use super::{ContactDto, Request, SlipSinkageDto, SoilDto, WheelDto};
use crate::wire::{Lambda, Scope, wire_object};

wire_object! {
    /// The forces over a range or a list of slips, at a sinkage given in exactly one of three ways (`sinkage_m`, `static_sinkage_m`, `normal_load_n`).
    SweepDto as "SlipSweepRequest" {
        wheel: WheelDto = operation::WHEEL,
        soil: SoilDto = operation::SOIL,
        contact: ContactDto = operation::CONTACT,
        slip: SlipAxis = SlipAxisSpec,
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

/// A sweep, checked.
pub(crate) struct SweepQuery {
    pub(crate) operation: Operation,
    pub(crate) slips: Vec<Slip>,
}

impl Request for SweepDto {
    type Query = SweepQuery;

    fn check(&self, place: &Scope<'_>) -> Option<SweepQuery> {
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
        let slips = self.slip().slips(place);
        Some(SweepQuery { operation: checked?.operation, slips: slips? })
    }
}
