//! Whether wheels run in the ruts of those before, and how the soil comes back there.

use terramechanics::Unloading;
use terramechanics_reading::{Field, Flag, Number, Object, Reader};

use super::stations::STATIONS;
use crate::request::laws::field_or_default;

pub(super) const RUT: Field<Flag> = Field::new(
    "rut",
    "Whether each wheel runs in the rut of the one before it, by the quadrature; needs `stations`. Of two side by side, the first follows the first.",
    Flag,
);

const BASE: Field<Number> = field_or_default(&Unloading::BASE, Unloading::BASE.meaning);
const GAIN: Field<Number> = field_or_default(&Unloading::GAIN, Unloading::GAIN.meaning);

const OBJECT: Object = Object {
    name: "Unloading",
    doc: "How soil comes back behind a wheel: p = p_u − k_u (z_u − z) with k_u = k_0 + A_u z_u. A value that is left out is the middle of the range that was measured.",
    groups: &[&[&BASE, &GAIN]],
};

pub(super) const UNLOADING: Field<&Object> =
    Field::new("unloading", "How soil comes back behind a wheel, beside `rut`.", &OBJECT);

/// How the soil comes back, where wheels run in ruts.
pub(super) fn read(object: &Reader<'_>) -> Option<Option<Unloading>> {
    let rut = object.optional(&RUT)?.unwrap_or(false);
    let unloading = match object.optional(&UNLOADING)? {
        Some(sent) => {
            let (base, gain) = (sent.or_default(&BASE), sent.or_default(&GAIN));
            Unloading { base: base?, gain: gain? }
        }
        None => Unloading::MEASURED,
    };
    if object.has(&UNLOADING) && !rut {
        object.place_of(&UNLOADING).fault(format_args!("needs `{}` beside it", RUT.name));
        return None;
    }
    if rut && !object.has(&STATIONS) {
        object
            .place_of(&RUT)
            .fault(format_args!("needs `{}`, which tell the wheel that follows from the one before", STATIONS.name));
        return None;
    }
    Some(rut.then_some(unloading))
}
