//! The request of `/v1/resistances`.

use terramechanics::{Contact, Slip, WheelOnSoil};

use super::operation;
use super::soil::Needs;
use super::{Request, SoilDto, WheelDto};
use crate::wire::{Number, Scope, wire_object};

const NORMAL_LOAD: Number = Number::within(&WheelOnSoil::NORMAL_LOAD, "Vertical load W on the wheel (N).").required();
const SLIP: Number = Number::within(&Slip::RATIO, "Slip ratio s (–), for the thrust alone, which needs one greater than 0.");

wire_object! {
    /// A wheel on a soil under a load, for Bekker's estimates.
    ResistancesDto as "ResistancesRequest" {
        wheel: WheelDto = operation::WHEEL,
        soil: SoilDto = operation::SOIL,
        normal_load_n: f64 = NORMAL_LOAD,
        slip: f64 = SLIP,
    }
}

/// A wheel under a load, checked.
pub(crate) struct ResistancesQuery {
    pub(crate) system: WheelOnSoil,
    pub(crate) normal_load: f64,
    pub(crate) slip: Option<Slip>,
}

impl Request for ResistancesDto {
    type Query = ResistancesQuery;

    fn check(&self, place: &Scope<'_>) -> Option<ResistancesQuery> {
        let wheel = self.wheel().required(place).and_then(|dto| dto.check(&place.field(self.wheel().name)));
        // Nothing but the thrust, which needs a slip, depends on the shear.
        let soil = self.soil().required(place).and_then(|dto| {
            let needs = Needs { shear: self.slip().is_present(), ..Needs::BOTH_LAWS };
            dto.check(&place.field(self.soil().name), needs)
        });
        let normal_load = self.normal_load_n().required_number(place);
        let slip = self.slip().checked(place).and_then(|ratio| Slip::new(ratio).ok());
        // The estimates know no contact rule: any will do.
        let system = WheelOnSoil { wheel: wheel?, soil: soil?.0, contact: Contact::MIDPOINT };
        Some(ResistancesQuery { system, normal_load: normal_load?, slip })
    }
}
