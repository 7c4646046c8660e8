//! The request of `/v1/resistances`.

use terramechanics::{Contact, Slip, WheelOnSoil};
use terramechanics_reading::{Field, Number, Object, Reader};

use crate::request::assume::ASSUME;
use crate::request::motion::RATIO;
use crate::request::sinkage::LOAD;
use crate::request::soil::{self, Needs};
use crate::request::system::{self, SOIL, WHEEL};
use crate::request::{Documented, Request};

const NORMAL_LOAD: Field<Number> = Field::required(WheelOnSoil::NORMAL_LOAD.name, "Vertical load W on the wheel (N).", LOAD);
const SLIP: Field<Number> = Field::new("slip", "Slip ratio s (–), for the thrust alone, which needs one greater than 0.", RATIO);

/// A wheel under a load, checked.
pub(crate) struct ResistancesCase {
    pub(crate) system: WheelOnSoil,
    pub(crate) normal_load: f64,
    pub(crate) slip: Option<Slip>,
}

pub(super) type ResistancesRequest = Documented<ResistancesCase>;

impl Request for ResistancesCase {
    const OBJECT: &'static Object = &Object {
        name: "ResistancesRequest",
        doc: "A wheel on a soil under a load, for Bekker's estimates.",
        groups: &[&[&WHEEL, &SOIL, &ASSUME, &NORMAL_LOAD, &SLIP]],
    };

    fn read(object: &Reader<'_>) -> Option<Self> {
        let wheel = system::read_wheel(object);
        // Nothing but the thrust, which needs a slip, depends on the shear.
        let needs = Needs { shear: object.has(&SLIP), ..Needs::ALL };
        let soil = object.required(&SOIL).and_then(|soil| soil::read(&soil, needs));
        let normal_load = object.required(&NORMAL_LOAD);
        let slip = object.optional(&SLIP).map(|slip| slip.and_then(|ratio| Slip::new(ratio).ok()));
        // The estimates know no contact rule: any will do.
        let system = WheelOnSoil { wheel: wheel?, soil: soil?.soil, contact: Contact::MIDPOINT };
        Some(Self { system, normal_load: normal_load?, slip: slip? })
    }
}
