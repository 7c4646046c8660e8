//! The sinkage of a request: as it is, from a static one, or under a load; and a load that is known beside a sinkage.

use terramechanics::{KnownSinkage, Sinkage, SlipSinkage, Wheel, WheelOnSoil};
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
pub(crate) const NORMAL_LOAD: Field<Number> = field(
    &WheelOnSoil::NORMAL_LOAD,
    "Vertical load W (N). Alone, the sinkage is solved so that F_z = W; beside sinkage_m or static_sinkage_m, the load takes the place of the soil's sinkage modulus.",
);

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

/// The sinkage: `sinkage_m`, `static_sinkage_m`, one of them under a known load, or the one that carries `normal_load_n`.
pub(crate) fn read(object: &Reader<'_>, wheel: Option<&Wheel>) -> Option<Sinkage> {
    let law = law_beside_static(object);
    let [sinkage, static_sinkage, load] = [&SINKAGE_M, &STATIC_SINKAGE, &NORMAL_LOAD].map(|field| object.optional(field));
    let known = match (object.has(&SINKAGE_M), object.has(&STATIC_SINKAGE)) {
        (true, true) => {
            for field in [&SINKAGE_M, &STATIC_SINKAGE] {
                let (one, other) = (SINKAGE_M.name, STATIC_SINKAGE.name);
                object.place_of(field).fault(format_args!("only one of `{one}` and `{other}` may be given"));
            }
            return None;
        }
        (true, false) => within_wheel(object, sinkage??, wheel).map(KnownSinkage::Given),
        (false, true) => static_sinkage?.zip(law).map(|(static_sinkage, law)| KnownSinkage::FromStatic { static_sinkage, law }),
        (false, false) if object.has(&NORMAL_LOAD) => return load?.map(Sinkage::CarryingLoad),
        (false, false) => {
            let (other, load) = (STATIC_SINKAGE.name, NORMAL_LOAD.name);
            object.place_of(&SINKAGE_M).fault(format_args!("is required, or `{other}` or `{load}`"));
            return None;
        }
    };
    Some(of_known(known?, load?))
}

/// A sinkage that is known, with the load where that is known as well.
pub(crate) fn of_known(sinkage: KnownSinkage, load: Option<f64>) -> Sinkage {
    match (load, sinkage) {
        (Some(load), sinkage) => Sinkage::UnderLoad { sinkage, load },
        (None, KnownSinkage::Given(sinkage)) => Sinkage::Given(sinkage),
        (None, KnownSinkage::FromStatic { static_sinkage, law }) => Sinkage::FromStatic { static_sinkage, law },
    }
}

/// Whether the load is known beside a sinkage, so that no sinkage modulus is needed.
pub(crate) fn is_under_load(object: &Reader<'_>) -> bool {
    object.has(&NORMAL_LOAD) && (object.has(&SINKAGE_M) || object.has(&STATIC_SINKAGE))
}

/// What a sinkage (m) beyond the radius (m) probably is in metres, as it continues behind the fault.
pub(crate) fn meant_in_metres(sinkage: f64, radius: f64) -> String {
    if sinkage >= 1.0 && sinkage / 1000.0 <= radius { in_millimetres(sinkage) } else { String::new() }
}

/// The sinkage, if it does not exceed the radius of the wheel, where that is known; else the fault is reported.
pub(crate) fn within_wheel(object: &Reader<'_>, sinkage: f64, wheel: Option<&Wheel>) -> Option<f64> {
    match wheel.map(Wheel::radius) {
        Some(radius) if sinkage > radius => {
            let meant = meant_in_metres(sinkage, radius);
            let error = terramechanics::Error::SinkageOutsideWheel { sinkage, radius };
            object.place_of(&SINKAGE_M).report(sinkage_figures(sinkage, radius), format_args!("{error}{meant}"));
            None
        }
        _ => Some(sinkage),
    }
}
