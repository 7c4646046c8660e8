//! What all requests have: a wheel, a soil, and where they touch.

use terramechanics::{Braking, Circles, Contact, ContactParams, PressureSinkage, Wheel, WheelOnSoil};
use terramechanics_reading::{Field, Group, Object, Reader, Tagged};

use super::assume::ASSUME;
use super::laws;
use super::soil::{self, FoundSoil, Needs};
use super::{Described, Documented, Shape, wheel};
use super::{circles, contact};

pub(crate) const WHEEL: Field<&Object> = Field::required("wheel", "The wheel.", &wheel::WHEEL);
pub(crate) const SOIL: Field<&Object> = Field::required("soil", "The soil.", &soil::SOIL);
pub(crate) const CONTACT: Field<&Tagged> = Field::new(
    "contact",
    "The contact; else what the catalogue measured with the soil, else midpoint with c3 = 0. Without `rule` its values replace those of that contact.",
    &contact::FORMS,
);

pub(crate) const SYSTEM: Group = &[&WHEEL, &SOIL, &CONTACT, &ASSUME];

pub(crate) type PressureSinkageObject = Documented<PressureSinkage>;
pub(crate) type ContactObject = Documented<Contact>;

impl Described for PressureSinkage {
    const SHAPE: Shape = Shape::Tagged(&laws::PRESSURE_SINKAGE);
}

impl Described for Contact {
    const SHAPE: Shape = Shape::Tagged(&contact::FORMS);
}

/// The parts of a system as far as they could be read.
pub(crate) struct System {
    pub(crate) wheel: Option<Wheel>,
    pub(crate) soil: Option<FoundSoil>,
    pub(crate) contact: Option<Contact>,
    pub(crate) circles: Option<Circles>,
}

impl System {
    /// The system, if all its parts are there.
    pub(crate) fn whole(&self, braking: Braking) -> Option<WheelOnSoil> {
        let contact = self.contact?.with_braking(braking);
        Some(WheelOnSoil { wheel: self.wheel?, soil: self.soil?.soil, contact })
    }
}

/// The system.
pub(crate) fn read(object: &Reader<'_>, needs: Needs<'_>) -> System {
    read_varied(object, None, needs)
}

/// The system with the laws that `variant` has in place of the soil's own.
pub(crate) fn read_varied(object: &Reader<'_>, variant: Option<&Reader<'_>>, needs: Needs<'_>) -> System {
    let wheel = read_wheel(object);
    let soil = object.required(&SOIL).and_then(|own| match variant {
        Some(variant) => soil::read(&own.overlaid(variant), needs),
        None => soil::read(&own, needs),
    });
    with(object, wheel, soil, needs)
}

/// The system on a soil that no request has.
pub(crate) fn read_on(object: &Reader<'_>, soil: Option<FoundSoil>, needs: Needs<'_>) -> System {
    with(object, read_wheel(object), soil, needs)
}

/// The system of this wheel and soil.
fn with(object: &Reader<'_>, wheel: Option<Wheel>, soil: Option<FoundSoil>, needs: Needs<'_>) -> System {
    let circles = circles::read(object);
    let contact = read_contact(object, soil.as_ref(), circles, needs);
    System { wheel, soil, contact, circles }
}

/// The wheel.
pub(crate) fn read_wheel(object: &Reader<'_>) -> Option<Wheel> {
    object.required(&WHEEL).and_then(|wheel| wheel::read(&wheel))
}

/// The contact sent, else the one measured with the soil, else the midpoint; with its circles.
pub(crate) fn read_contact(
    object: &Reader<'_>,
    soil: Option<&FoundSoil>,
    circles: Option<Circles>,
    needs: Needs<'_>,
) -> Option<Contact> {
    let measured = soil.and_then(|soil| soil.contact.as_ref());
    let Some(params) = contact::read(object, &CONTACT, measured, needs)? else {
        return Some(soil.and_then(|soil| soil.contact).unwrap_or(Contact::MIDPOINT).with_circles(circles?));
    };
    contact::checked(object, &CONTACT, ContactParams { circles: circles?, ..params })
}
