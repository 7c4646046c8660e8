//! The wheels of a rover: so many alike, or stations with their places.

use terramechanics::{Braking, CentreOfMass, Contact, Station, Turning, Vehicle, WheelOnSoil};
use terramechanics_reading::{Field, Number, Object, Objects, Reader};

use super::drive::{TURNING, turning};
use crate::request::laws::{number, number_or_default};
use crate::request::soil::{self, FoundSoil};
use crate::request::system::{CONTACT, WHEEL, read_contact, read_wheel};
use crate::request::unused::{Reads, Unused};
use crate::request::{circles, method};

/// Most wheels of a rover.
const MOST_WHEELS: usize = 64;

const COUNT: Field<Number> = Field::required("count", "Number of wheels.", Number::new("1", 1.0, MOST_WHEELS as f64).whole());

const ALIKE: Object =
    Object { name: "VehicleWheels", doc: "Wheels that are alike and carry the same load.", groups: &[&[&COUNT, &WHEEL]] };

pub(super) const WHEELS: Field<&Object> =
    Field::new("wheels", "Wheels that are alike, under equal loads; or `stations` in their place.", &ALIKE);

const X: Field<Number> =
    Field::required(Vehicle::POSITION.name, "Place x (m) along the rover, positive to the front.", number(&Vehicle::POSITION));
const OWN_SOIL: Field<&Object> = Field::new("soil", "The soil under this wheel, in place of that of the rover.", &soil::SOIL);

const STATION: Object = Object { name: "Station", doc: "One wheel at its place.", groups: &[&[&X, &WHEEL, &OWN_SOIL], TURNING] };

pub(super) const STATIONS: Field<Objects> = Field::new(
    "stations",
    "One wheel each; two of the same place stand side by side. With `centre_of_mass` their loads follow from statics, else they are equal.",
    Objects { object: &STATION, fewest: 1, most: MOST_WHEELS },
);

pub(super) const SOIL: Field<&Object> =
    Field::new("soil", "The soil; may be left out where every station has its own.", &soil::SOIL);

const HEIGHT: Field<Number> =
    Field::new(Vehicle::HEIGHT.name, "Height (m) above the ground; 0 unless given.", number_or_default(&Vehicle::HEIGHT));

const CENTRE: Object = Object {
    name: "CentreOfMass",
    doc: "The centre of mass, which decides the loads of the stations.",
    groups: &[&[&X, &HEIGHT]],
};

pub(super) const CENTRE_OF_MASS: Field<&Object> = Field::new(
    "centre_of_mass",
    "The centre of mass. The body is rigid and its wheels equally stiff, so that the loads are linear in x.",
    &CENTRE,
);

/// The centre of mass, if one was sent.
pub(super) fn centre_of_mass(object: &Reader<'_>) -> Option<Option<CentreOfMass>> {
    let Some(centre) = object.optional(&CENTRE_OF_MASS)? else { return Some(None) };
    let (position, height) = (centre.required(&X), centre.or_default(&HEIGHT));
    Some(Some(CentreOfMass { position: position?, height: height? }))
}

/// The stations, with whether each has a soil of its own.
pub(super) struct FoundStations {
    pub(super) stations: Vec<Station>,
    pub(super) have_own_soil: Vec<bool>,
    /// What was sent and is not read.
    pub(super) unused: Unused,
}

/// The ground that wheels share.
struct Ground {
    soil: Option<FoundSoil>,
    contact: Contact,
    /// Whether the request has the contact, which then holds on every soil.
    is_chosen: bool,
}

/// The wheels, in one of two ways.
pub(super) fn read(object: &Reader<'_>) -> Option<FoundStations> {
    let (circles, needs) = (circles::read(object), method::needs(object));
    let soil = match object.optional(&SOIL) {
        Some(Some(own)) => soil::read(&own, needs).map(Some),
        Some(None) => Some(None),
        None => None,
    };
    let contact = read_contact(object, soil.as_ref().and_then(Option::as_ref), circles, needs);
    let ground = || Some(Ground { soil: soil?, contact: contact?, is_chosen: object.has(&CONTACT) });
    match (object.has(&WHEELS), object.has(&STATIONS)) {
        (true, true) => {
            for place in [object.place_of(&WHEELS), object.place_of(&STATIONS)] {
                place.fault("only one of `wheels` and `stations` may be given");
            }
            None
        }
        (false, false) => {
            object.place_of(&WHEELS).fault("is required, or `stations`");
            None
        }
        (true, false) => {
            let wheels = object.optional(&WHEELS)??;
            let (count, wheel) = (wheels.required(&COUNT), read_wheel(&wheels));
            if matches!(soil, Some(None)) {
                object.place_of(&SOIL).fault("is required");
            }
            let Ground { soil, contact, .. } = ground()?;
            let system = WheelOnSoil { wheel: wheel?, soil: soil?.soil, contact: contact.with_braking(Braking::OneZone) };
            let station = Station { position: None, count: count? as u32, system, turning: Turning::Together };
            let unused = Unused::of(object, reads(object)?, &system);
            Some(FoundStations { stations: vec![station], have_own_soil: vec![false], unused })
        }
        (false, true) => stations(object, ground),
    }
}

/// What the method of the rover reads, if it is one.
fn reads(object: &Reader<'_>) -> Option<Reads> {
    method::peeked(object).map(|method| Reads::by(&method, false))
}

fn stations(object: &Reader<'_>, ground: impl Fn() -> Option<Ground>) -> Option<FoundStations> {
    let needs = method::needs(object);
    let items = object.optional(&STATIONS)??;
    let ground = ground();
    let mut lacks_soil = false;
    let reads = reads(object);
    let mut unused = Unused::default();
    let read = items.each(|station, _| {
        let (position, wheel, turning) = (station.required(&X), read_wheel(station), turning(station));
        let own = station.optional(&OWN_SOIL)?.map(|own| soil::read(&own, needs));
        let has_own_soil = own.is_some();
        let (soil, contact) = match (own, ground.as_ref()?) {
            (Some(own), ground) => {
                let own = own?;
                if let (Some(sent), Some(reads)) = (station.within(&OWN_SOIL), reads) {
                    unused.add_soil(&sent, reads, &own.soil);
                }
                let contact = if ground.is_chosen {
                    ground.contact
                } else {
                    read_contact(object, Some(&own), Some(ground.contact.circles()), needs)?
                };
                (own.soil, contact)
            }
            (None, Ground { soil: Some(shared), contact, .. }) => (shared.soil, *contact),
            (None, Ground { soil: None, .. }) => {
                lacks_soil = true;
                return None;
            }
        };
        let system = WheelOnSoil { wheel: wheel?, soil, contact: contact.with_braking(Braking::OneZone) };
        Some((Station { position: Some(position?), count: 1, system, turning: turning? }, has_own_soil))
    });
    if lacks_soil {
        object.place_of(&SOIL).fault("is required, or a `soil` in every station");
    }
    let (stations, have_own_soil): (Vec<Station>, Vec<bool>) = read?.into_iter().unzip();
    let first = stations.first().map(|station| station.system)?;
    unused.extend(Unused::beside_soil(object, reads?, &first.contact));
    match (ground?.soil, object.within(&SOIL), have_own_soil.iter().all(|has| *has)) {
        (Some(shared), Some(sent), false) => unused.add_soil(&sent, reads?, &shared.soil),
        // Every wheel has a soil of its own.
        _ => unused.add(object, &SOIL, false),
    }
    Some(FoundStations { stations, have_own_soil, unused })
}
