//! The request of `/v1/stress-profile`.

use terramechanics::{Motion, Operation, PeakDepth};

use super::motion::MotionEntries;
use super::operation::{self, OperationEntries, operation_entries};
use super::{ContactDto, Request, SlipSinkageDto, SoilDto, WheelDto};
use crate::wire::{Number, Scope, wire_object};

const POINTS: Number = Number::new(
    "Number of places from exit to entry; the angle of maximum stress is always one of them, so 2 gives 3.",
    2.0,
    10_001.0,
)
.integer()
.or(201.0);

wire_object! {
    /// The stresses along the rim at one operating point, exact and linearised. With `normal_load_n` the quadrature solves the sinkage.
    ProfileDto as "StressProfileRequest" {
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
        normal_stress_radius: String = operation::NORMAL_STRESS_RADIUS,
        peak_sinkage: String = operation::PEAK_SINKAGE,
        braking: String = operation::BRAKING,
        points: f64 = POINTS,
    }
}

/// A profile, checked.
pub(crate) struct ProfileQuery {
    pub(crate) operation: Operation,
    pub(crate) motion: Motion,
    pub(crate) peak_depth: PeakDepth,
    pub(crate) points: usize,
}

impl Request for ProfileDto {
    type Query = ProfileQuery;

    fn check(&self, place: &Scope<'_>) -> Option<ProfileQuery> {
        let checked = operation_entries!(self).check(place);
        let wheel = checked.as_ref().map(|checked| &checked.operation.system.wheel);
        let motion = MotionEntries {
            slip: self.slip(),
            forward_velocity: self.forward_velocity_m_s(),
            angular_velocity: self.angular_velocity_rad_s(),
        }
        .check(place, wheel);
        let points = self.points().or_default(place);
        let checked = checked?;
        Some(ProfileQuery {
            operation: checked.operation,
            motion: motion?,
            peak_depth: checked.peak_depth.unwrap_or(PeakDepth::Geometric),
            points: points? as usize,
        })
    }
}
