//! The wheel of a request.

use terramechanics::{Wheel, WheelParams};
use terramechanics_reading::{Field, Lookup, Number, Object, Reader};

use super::laws::field;
use super::preset::Preset;
use super::{Described, Documented, Shape};
use crate::catalogue::{self, WheelRecord};

const PRESET: Field<Lookup<&'static WheelRecord>> = Field::new(
    "preset",
    "A wheel of the catalogue, see /v1/wheels.",
    Lookup { name: Some("WheelPreset"), words: catalogue::wheel_ids, find: catalogue::wheel },
);
const RADIUS: Field<Number> = field(&Wheel::RADIUS, "Rim radius r (m).");
const WIDTH: Field<Number> = field(&Wheel::WIDTH, "Width b (m).");
const LUG_HEIGHT: Field<Number> = field(&Wheel::LUG_HEIGHT, "Lug height h (m); 0 unless given or in the catalogue.");
const LUG_COEFFICIENT: Field<Number> = field(
    &Wheel::LUG_COEFFICIENT,
    "Lug coefficient λ_s [–]: the shear stress acts at r + λ_s h; 0.5 unless given or in the catalogue.",
);

pub(crate) const WHEEL: Object = Object {
    name: "Wheel",
    doc: "A rigid wheel. Without `preset`, `radius_m` and `width_m` are required; with it, any field beside it overrides the catalogue's.",
    groups: &[&[&PRESET, &RADIUS, &WIDTH, &LUG_HEIGHT, &LUG_COEFFICIENT]],
};

pub(crate) type WheelObject = Documented<Wheel>;

impl Described for Wheel {
    const SHAPE: Shape = Shape::Object(&WHEEL);
}

/// The wheel, from the request and the preset it names.
pub(crate) fn read(object: &Reader<'_>) -> Option<Wheel> {
    let preset = Preset::read(object, &PRESET);
    let radius = preset.value(object, &RADIUS, None);
    let width = preset.value(object, &WIDTH, None);
    let lug_height = preset.value(object, &LUG_HEIGHT, Wheel::LUG_HEIGHT.default());
    let lug_coefficient = preset.value(object, &LUG_COEFFICIENT, Wheel::LUG_COEFFICIENT.default());
    let params = WheelParams { radius: radius?, width: width?, lug_height: lug_height?, lug_coefficient: lug_coefficient? };
    if !preset.is_sound {
        return None;
    }
    let wheel = Wheel::new(params).map_err(|invalid| object.place().fault(invalid)).ok()?;
    let assumed = !object.has(&LUG_HEIGHT) && preset.entry.is_some_and(|record| record.assumes(LUG_HEIGHT.name));
    if assumed {
        preset.assumed(object, &LUG_HEIGHT);
    }
    Some(if assumed { wheel.with_unknown_lug_height() } else { wheel })
}
