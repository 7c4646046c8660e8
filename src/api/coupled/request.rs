//! The request of `/v1/coupled`.

use terramechanics::{Braking, Coupled, Motion, Soil, SoilParams, WheelOnSoil};
use terramechanics_reading::{Field, Number, Object, Reader};

use crate::request::assume::ASSUME;
use crate::request::circles::CIRCLES;
use crate::request::laws::field;
use crate::request::method::NORMAL_STRESS_RADIUS;
use crate::request::motion::{self, MOTION, SLIP};
use crate::request::sinkage::{LOAD, SINKAGE_M, within_wheel};
use crate::request::soil::{FoundSoil, Needs};
use crate::request::system::{self, CONTACT, SOIL, WHEEL};
use crate::request::unused::{Reads, Unused};
use crate::request::{Documented, Request};

const SINKAGE: Field<Number> = Field { required: true, ..SINKAGE_M };
const NORMAL_LOAD: Field<Number> =
    Field::required(WheelOnSoil::NORMAL_LOAD.name, "Vertical load W on the wheel (N), as measured.", LOAD);
const TORQUE: Field<Number> = field(
    &WheelOnSoil::TORQUE,
    "Torque T about the axle (N·m), where it was measured, in the direction of the angular velocity; else it follows from the load.",
);

const OPTIONAL_SOIL: Field<&Object> =
    Field { meaning: "The soil; not needed where the torque is given.", required: false, ..SOIL };

/// What is measured, checked.
pub(crate) struct CoupledCase {
    pub(crate) system: WheelOnSoil,
    /// None where the torque was measured and no slip.
    pub(crate) motion: Option<Motion>,
    pub(crate) sinkage: f64,
    /// The load and the torque of the wheel moving forward, or of its mirror image.
    pub(crate) known: Coupled,
    pub(crate) unused: Unused,
}

pub(super) type CoupledRequest = Documented<CoupledCase>;

impl Request for CoupledCase {
    const OBJECT: &'static Object = &Object {
        name: "CoupledRequest",
        doc: "A wheel whose slip (`slip`, or both velocities), sinkage and load are measured, and maybe its torque. The soil's pressure–sinkage law cancels: it has no influence and may be left out. With the torque, no soil is needed at all, and what is sent of one has no influence on the numbers; nor is a slip needed, save by a contact whose peak moves with it (`wong_reece` with `c2`). A slip that is sent all the same tells whether the torque goes with it.",
        groups: &[
            &[&WHEEL, &OPTIONAL_SOIL, &CONTACT, &ASSUME],
            CIRCLES,
            MOTION,
            &[&SINKAGE, &NORMAL_LOAD, &TORQUE, &NORMAL_STRESS_RADIUS],
        ],
    };

    fn read(object: &Reader<'_>) -> Option<Self> {
        let needs = Needs { pressure_sinkage: false, ..Needs::ALL };
        // Of a measured torque and load the pull follows without a soil.
        let is_bare = object.has(&TORQUE) && !object.has(&OPTIONAL_SOIL);
        let bare = || Soil::new(SoilParams::BARE).ok().map(FoundSoil::bare);
        let system = if is_bare { system::read_on(object, bare(), needs) } else { system::read(object, needs) };
        let moves = system.contact.is_some_and(|contact| contact.peak_moves_with_slip());
        let motion = match motion::is_given(object) || !object.has(&TORQUE) {
            true => motion::read(object, system.wheel.as_ref(), system.circles).map(Some),
            false if moves => {
                object.place_of(&SLIP).fault("is required, or both velocities: the peak of this contact moves with slip");
                None
            }
            false => Some(None),
        };
        let sinkage = object.required(&SINKAGE).and_then(|z| within_wheel(object, z, system.wheel.as_ref()));
        let normal_load = object.required(&NORMAL_LOAD);
        let torque = object.optional(&TORQUE);
        let normal_stress_radius = object.or_default(&NORMAL_STRESS_RADIUS);
        let motion = motion?;
        let system = system.whole(Braking::OneZone)?;
        let known = Coupled {
            normal_load: normal_load?,
            torque: torque?.map(|torque| motion.map_or(torque, |motion| motion.heading.as_forward(torque))),
            normal_stress_radius: normal_stress_radius?,
        };
        let sinkage = sinkage?;
        // Last, for it reads again what was found to be right.
        let reads = if object.has(&TORQUE) { Reads::FROM_TORQUE } else { Reads::STRESSES };
        let unused = Unused::of(object, reads, &system);
        Some(Self { system, motion, sinkage, known, unused })
    }
}
