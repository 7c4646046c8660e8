//! The request of `/v1/towed`.

use terramechanics::{Braking, ForceModel, Method, Operation, Sinkage, WheelOnSoil};

use super::method::braking_law;
use super::operation;
use super::soil::Needs;
use super::{ContactDto, Request, SoilDto, WheelDto};
use crate::wire::{Choice, Number, Scope, wire_object};

const NORMAL_LOAD: Number = Number::within(&WheelOnSoil::NORMAL_LOAD, "Vertical load W (N) that the wheel carries.").required();
const BRAKING: Choice = Choice {
    doc: "Law for the towed wheel. two_zone: Wong & Reece's, whose shear reverses at the peak of the stresses; one_zone: the displacement of a driving wheel continued.",
    default: Some("two_zone"),
    ..operation::BRAKING
};

wire_object! {
    /// A wheel that is towed and rolls freely under a load. Of the contact, two zones use c3 alone: their peak is where they part.
    TowedDto as "TowedRequest" {
        wheel: WheelDto = operation::WHEEL,
        soil: SoilDto = operation::SOIL,
        contact: ContactDto = operation::CONTACT,
        normal_load_n: f64 = NORMAL_LOAD,
        braking: String = BRAKING,
    }
}

/// A towed wheel, checked: the load stands as its way to the sinkage.
pub(crate) struct TowedQuery {
    pub(crate) operation: Operation,
    pub(crate) load: f64,
}

impl Request for TowedDto {
    type Query = TowedQuery;

    fn check(&self, place: &Scope<'_>) -> Option<TowedQuery> {
        let wheel = self.wheel().required(place).and_then(|dto| dto.check(&place.field(self.wheel().name)));
        let soil = self.soil().required(place).and_then(|dto| dto.check(&place.field(self.soil().name), Needs::BOTH_LAWS));
        let contact = operation::checked_contact(&self.contact(), place, soil.and_then(|(_, measured)| measured));
        let load = self.normal_load_n().required_number(place);
        let braking = braking_law(&self.braking(), place, Braking::TwoZone);
        let load = load?;
        let system = WheelOnSoil { wheel: wheel?, soil: soil?.0, contact: contact?.with_braking(braking?) };
        let model = ForceModel::at_rim(Method::Quadrature);
        Some(TowedQuery { operation: Operation { system, model, sinkage: Sinkage::CarryingLoad(load) }, load })
    }
}
