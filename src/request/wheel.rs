//! The wheel of a request.

use terramechanics::{Wheel, WheelParams};
use terramechanics_reading::{Field, Lookup, Number, Object, Reader};

use super::preset::Preset;
use super::{Described, Shape};
use crate::catalogue::{self, WheelRecord};

const PRESET: Field<Lookup<&'static WheelRecord>> = Field::new(
    "preset",
    "A wheel of the catalogue, see /v1/wheels.",
    Lookup { words: catalogue::wheel_ids, find: catalogue::wheel },
);
const RADIUS: Field<Number> = Field::new("radius_m", "Rim radius r (m).", Number::new("m", 1e-3, 100.0));
const WIDTH: Field<Number> = Field::new("width_m", "Width b (m).", Number::new("m", 1e-3, 100.0));
const LUG_HEIGHT: Field<Number> =
    Field::new("lug_height_m", "Lug height h (m); 0 unless given or in the catalogue.", Number::new("m", 0.0, 10.0));
const LUG_COEFFICIENT: Field<Number> = Field::new(
    "lug_coefficient",
    "Lug coefficient λ_s [–]: the shear stress acts at r + λ_s h; 0.5 unless given or in the catalogue.",
    Number::new("1", 0.0, 1.0),
);

pub(super) const WHEEL: Object = Object {
    name: "Wheel",
    doc: "A rigid wheel. Without `preset`, `radius_m` and `width_m` are required; with it, any field beside it overrides the catalogue's.",
    groups: &[&[&PRESET, &RADIUS, &WIDTH, &LUG_HEIGHT, &LUG_COEFFICIENT]],
};

impl Described for Wheel {
    const SHAPE: Shape = Shape::Object(&WHEEL);
}

/// The wheel, from the request and the preset it names.
pub(super) fn read(object: &Reader<'_>) -> Option<Wheel> {
    let preset = Preset::read(object, &PRESET);
    let radius = preset.value(object, &RADIUS, None);
    let width = preset.value(object, &WIDTH, None);
    let lug_height = preset.value(object, &LUG_HEIGHT, Some(0.0));
    let lug_coefficient = preset.value(object, &LUG_COEFFICIENT, Some(Wheel::TYPICAL_LUG_COEFFICIENT));
    let params = WheelParams { radius: radius?, width: width?, lug_height: lug_height?, lug_coefficient: lug_coefficient? };
    if !preset.is_sound {
        return None;
    }
    let wheel = Wheel::new(params).map_err(|invalid| object.place().fault(invalid)).ok()?;
    let assumed = !object.has(&LUG_HEIGHT) && preset.entry.is_some_and(|record| record.assumes(LUG_HEIGHT.name));
    Some(if assumed { wheel.with_unknown_lug_height() } else { wheel })
}
