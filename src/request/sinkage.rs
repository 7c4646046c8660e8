//! The sinkage of a request: as it is, from a static one, or under a load.

use terramechanics::{Sinkage, SlipSinkage, Wheel, WheelOnSoil};
use terramechanics_reading::{Field, Group, Number, Reader, Tagged, in_millimetres};

use super::laws::{self, field, number};
use super::refusal::sinkage_figures;

/// A load on a wheel.
pub(crate) const LOAD: Number = number(&WheelOnSoil::NORMAL_LOAD);

pub(crate) const SINKAGE_M: Field<Number> = field(&WheelOnSoil::SINKAGE, "Sinkage z (m), at most the wheel's radius.");
pub(crate) const STATIC_SINKAGE: Field<Number> =
    field(&WheelOnSoil::STATIC_SINKAGE, "Static sinkage z0 (m); the sinkage follows from the slip by `slip_sinkage`.");
pub(crate) const SLIP_SINKAGE: Field<&Tagged> =
    Field::new("slip_sinkage", "Slip–sinkage law beside static_sinkage_m; lyasko unless given.", &laws::SLIP_SINKAGE);
pub(crate) const NORMAL_LOAD: Field<Number> =
    field(&WheelOnSoil::NORMAL_LOAD, "Vertical load W (N); the sinkage is solved so that F_z = W.");

pub(crate) const SINKAGE: Group = &[&SINKAGE_M, &STATIC_SINKAGE, &SLIP_SINKAGE, &NORMAL_LOAD];

/// The slip–sinkage law; Lyasko's where none was sent.
pub(crate) fn law(object: &Reader<'_>) -> Option<SlipSinkage> {
    match object.optional(&SLIP_SINKAGE)? {
        Some(chosen) => laws::slip_sinkage(&chosen),
        None => Some(SlipSinkage::Lyasko),
    }
}

/// The slip–sinkage law, which has a meaning only beside a static sinkage.
pub(crate) fn law_beside_static(object: &Reader<'_>) -> Option<SlipSinkage> {
    if object.has(&SLIP_SINKAGE) && !object.has(&STATIC_SINKAGE) {
        object.place_of(&SLIP_SINKAGE).fault(format_args!("needs `{}` beside it", STATIC_SINKAGE.name));
    }
    law(object)
}

/// The sinkage, given in exactly one of three ways.
pub(crate) fn read(object: &Reader<'_>, wheel: Option<&Wheel>) -> Option<Sinkage> {
    let law = law_beside_static(object);
    let ways = [&SINKAGE_M, &STATIC_SINKAGE, &NORMAL_LOAD];
    let values = ways.map(|field| object.optional(field).flatten());
    let given = ways.iter().filter(|field| object.has(field)).count();
    if given != 1 {
        let [sinkage, static_sinkage, load] = ways.map(|field| field.name);
        if given == 0 {
            object.place_of(&SINKAGE_M).fault(format_args!("is required, or `{static_sinkage}` or `{load}`"));
        }
        for field in ways.iter().filter(|field| object.has(field)) {
            let place = object.place_of(field);
            place.fault(format_args!("only one of `{sinkage}`, `{static_sinkage}` and `{load}` may be given"));
        }
        return None;
    }
    match values {
        [Some(sinkage), None, None] => within_wheel(object, sinkage, wheel).map(Sinkage::Given),
        [None, Some(static_sinkage), None] => Some(Sinkage::FromStatic { static_sinkage, law: law? }),
        [None, None, Some(load)] => Some(Sinkage::CarryingLoad(load)),
        _ => None,
    }
}

/// The sinkage, if it does not exceed the radius of the wheel, where that is known; else the fault is reported.
pub(crate) fn within_wheel(object: &Reader<'_>, sinkage: f64, wheel: Option<&Wheel>) -> Option<f64> {
    match wheel.map(Wheel::radius) {
        Some(radius) if sinkage > radius => {
            let meant = if sinkage >= 1.0 && sinkage / 1000.0 <= radius { in_millimetres(sinkage) } else { String::new() };
            let error = terramechanics::Error::SinkageOutsideWheel { sinkage, radius };
            object.place_of(&SINKAGE_M).report(sinkage_figures(sinkage, radius), format_args!("{error}{meant}"));
            None
        }
        _ => Some(sinkage),
    }
}
