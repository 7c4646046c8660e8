//! The request of `/v1/towed`.

use terramechanics::{Braking, ForceModel, Method, Operation, Sinkage, WheelOnSoil};
use terramechanics_reading::{Field, Number, Object, Reader, Word};

use crate::request::circles::CIRCLES;
use crate::request::method::{self, BRAKING_FIELD, BRAKING_LAWS, INTEGRALS, takes_two_zones};
use crate::request::sinkage::LOAD;
use crate::request::system::{self, SYSTEM};
use crate::request::unused::{Reads, Unused};
use crate::request::{Documented, Request};

const NORMAL_LOAD: Field<Number> =
    Field::required(WheelOnSoil::NORMAL_LOAD.name, "Vertical load W (N) that the wheel carries.", LOAD);
const BRAKING: Field<Word<Braking>> = Field::new(
    BRAKING_FIELD.name,
    "Law for the towed wheel. two_zone: Wong & Reece's, whose shear reverses at the peak of the stresses; by quadrature only; one_zone: the displacement of a driving wheel continued.",
    BRAKING_LAWS.or(Braking::TwoZone),
);

/// A towed wheel, checked: the load stands as its way to the sinkage.
pub(crate) struct TowedCase {
    pub(crate) operation: Operation,
    pub(crate) load: f64,
    /// What was sent and is not read.
    pub(crate) unused: Unused,
}

pub(super) type TowedRequest = Documented<TowedCase>;

impl Request for TowedCase {
    const OBJECT: &'static Object = &Object {
        name: "TowedRequest",
        doc: "A wheel that is towed and rolls freely under a load. With two zones only c3 of the contact is used, because the stresses peak where the zones meet.",
        groups: &[SYSTEM, CIRCLES, &[&NORMAL_LOAD], INTEGRALS, &[&BRAKING]],
    };

    fn read(object: &Reader<'_>) -> Option<Self> {
        let system = system::read(object, method::needs(object));
        let method = method::read_integral(object);
        let load = object.required(&NORMAL_LOAD);
        let braking = object.or_default(&BRAKING);
        let (method, braking) = (method?, braking?);
        // The method has no zones; only those that were asked for are refused.
        let braking = if method == Method::ResistiveForce && !object.has(&BRAKING) { Braking::OneZone } else { braking };
        let (system, load) = (system.whole(braking)?, load?);
        if !takes_two_zones(object, method, &system.contact) && method == Method::ResistiveForce {
            return None;
        }
        let model = ForceModel::at_rim(method);
        let unused = Unused::of(object, Reads::by(&method, false), &system);
        Some(Self { operation: Operation { system, model, sinkage: Sinkage::CarryingLoad(load) }, load, unused })
    }
}
