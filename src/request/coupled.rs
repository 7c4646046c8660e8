//! The request of `/v1/coupled`.

use terramechanics::{Coupled, Motion, WheelOnSoil};

use super::motion::MotionEntries;
use super::operation::{self, checked_contact, normal_stress_radius_of, within_wheel};
use super::soil::Needs;
use super::{ContactDto, Request, SoilDto, WheelDto};
use crate::wire::{Number, Scope, wire_object};

const NORMAL_LOAD: Number =
    Number::within(&WheelOnSoil::NORMAL_LOAD, "Vertical load W on the wheel (N), as measured.").required();
const TORQUE: Number = Number::within(
    &WheelOnSoil::TORQUE,
    "Torque T about the axle (N·m), where it was measured, in the direction of the angular velocity; else it follows from the load.",
);

/// The pressure–sinkage law cancels.
const NEEDS: Needs = Needs { pressure_sinkage: false, ..Needs::BOTH_LAWS };

wire_object! {
    /// A wheel whose slip (`slip`, or both velocities), sinkage and load are measured, and maybe its torque. The soil's pressure–sinkage law cancels: it has no influence and may be left out.
    CoupledDto as "CoupledRequest" {
        wheel: WheelDto = operation::WHEEL,
        soil: SoilDto = operation::SOIL,
        contact: ContactDto = operation::CONTACT,
        slip: f64 = operation::SLIP,
        forward_velocity_m_s: f64 = operation::FORWARD_VELOCITY,
        angular_velocity_rad_s: f64 = operation::ANGULAR_VELOCITY,
        sinkage_m: f64 = operation::SINKAGE.required(),
        normal_load_n: f64 = NORMAL_LOAD,
        torque_n_m: f64 = TORQUE,
        normal_stress_radius: String = operation::NORMAL_STRESS_RADIUS,
    }
}

/// What is measured, checked.
pub(crate) struct CoupledQuery {
    pub(crate) system: WheelOnSoil,
    pub(crate) motion: Motion,
    pub(crate) sinkage: f64,
    /// The load and the torque of the wheel moving forward, or of its mirror image.
    pub(crate) known: Coupled,
}

impl Request for CoupledDto {
    type Query = CoupledQuery;

    fn check(&self, place: &Scope<'_>) -> Option<CoupledQuery> {
        let wheel = self.wheel().required(place).and_then(|dto| dto.check(&place.field(self.wheel().name)));
        let soil = self.soil().required(place).and_then(|dto| dto.check(&place.field(self.soil().name), NEEDS));
        let contact = checked_contact(&self.contact(), place, soil.and_then(|(_, measured)| measured));
        let motion = MotionEntries {
            slip: self.slip(),
            forward_velocity: self.forward_velocity_m_s(),
            angular_velocity: self.angular_velocity_rad_s(),
        }
        .check(place, wheel.as_ref());
        let sinkage = self.sinkage_m().required_number(place);
        let sinkage = sinkage.and_then(|z| within_wheel(z, wheel.as_ref(), &place.field(self.sinkage_m().name)));
        let normal_load = self.normal_load_n().required_number(place);
        let torque = self.torque_n_m().checked(place);
        let normal_stress_radius = normal_stress_radius_of(&self.normal_stress_radius(), place);
        let motion = motion?;
        Some(CoupledQuery {
            system: WheelOnSoil { wheel: wheel?, soil: soil?.0, contact: contact? },
            motion,
            sinkage: sinkage?,
            known: Coupled {
                normal_load: normal_load?,
                torque: torque.map(|torque| motion.heading.as_forward(torque)),
                normal_stress_radius: normal_stress_radius?,
            },
        })
    }
}
