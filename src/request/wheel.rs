//! The wheel of a request.

use terramechanics::{Wheel, WheelParams};

use crate::catalogue;
use crate::wire::{Choice, Entry, Number, Object, Scope, wire_object};

wire_object! {
    /// A rigid wheel. Without `preset`, `radius_m` and `width_m` are required; with it, any field beside it overrides the catalogue's.
    WheelDto as "Wheel" {
        preset: String = Choice { doc: "A wheel of the catalogue, see /v1/wheels.", words: catalogue::wheel_ids, default: None },
        radius_m: f64 = Number::within(&Wheel::RADIUS, "Rim radius r (m).").length(),
        width_m: f64 = Number::within(&Wheel::WIDTH, "Width b (m).").length(),
        lug_height_m: f64 = Number::within(&Wheel::LUG_HEIGHT, "Lug height h (m); 0 unless given or in the catalogue.").length(),
        lug_coefficient: f64 = Number::within(&Wheel::LUG_COEFFICIENT, "Lug coefficient λ_s [–]: the shear stress acts at r + λ_s h; 0.5 unless given or in the catalogue."),
    }
}

impl WheelDto {
    /// The wheel, from the request and the preset it names.
    pub(crate) fn check(&self, place: &Scope<'_>) -> Option<Wheel> {
        self.report_oddities(place);
        let preset = self.preset().looked_up(place, catalogue::wheel);
        let unknown_preset = self.preset().is_present() && preset.is_none();
        let value = |entry: &Entry<'_, f64>, otherwise: Option<f64>| {
            let published = || preset.and_then(|record| record.number(entry.name));
            if entry.is_present() {
                return entry.checked(place);
            }
            let found = published().or(otherwise);
            if found.is_none() && !unknown_preset {
                missing(place, entry.name, preset.map(|record| record.id.as_str()));
            }
            found
        };
        let radius = value(&self.radius_m(), None);
        let width = value(&self.width_m(), None);
        let lug_height = value(&self.lug_height_m(), Some(0.0));
        let lug_coefficient = value(&self.lug_coefficient(), Some(Wheel::TYPICAL_LUG_COEFFICIENT));
        let params = WheelParams { radius: radius?, width: width?, lug_height: lug_height?, lug_coefficient: lug_coefficient? };
        if unknown_preset {
            return None;
        }
        let wheel = Wheel::new(params).map_err(|invalid| place.fault(invalid)).ok()?;
        let height = self.lug_height_m();
        let assumed = !height.is_present() && preset.is_some_and(|record| record.assumes(height.name));
        Some(if assumed { wheel.with_unknown_lug_height() } else { wheel })
    }
}

/// Reports that a value is missing, from the request and from the preset if one is named.
pub(super) fn missing(place: &Scope<'_>, name: &'static str, preset: Option<&str>) {
    match preset {
        Some(id) => place.field(name).fault(format_args!("is required: the catalogue has no published value for `{id}`")),
        None => place.field(name).fault("is required"),
    }
}
