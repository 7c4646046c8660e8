//! The shear law of a soil.

use terramechanics::{Declared, JanosiHanamoto, ShearLaw, WongPeak, WongResidual};
use utoipa::openapi::{RefOr, Schema};

use super::variants::{made, numbers_of};
use crate::wire::{Choice, Number, Object, Scope, Spec, Variant, tagged_schema, wire_object};

/// The shear laws and their parameters; Janosi–Hanamoto's is the soil's `shear_modulus_m`.
pub(crate) const SHEAR_LAWS: &[Variant] = &[
    Variant { name: "janosi_hanamoto", required: &[], optional: &[] },
    Variant { name: "wong_residual", required: &["residual_ratio", "peak_displacement_m"], optional: &[] },
    Variant { name: "wong_peak", required: &["peak_displacement_m"], optional: &[] },
];

fn shear_law_names() -> Vec<&'static str> {
    Variant::names(SHEAR_LAWS)
}

fn shear_schema(doc: &str, fields: &[(&'static str, &dyn Spec)]) -> RefOr<Schema> {
    tagged_schema(doc, fields, "law", SHEAR_LAWS)
}

wire_object! {
    /// How shear strength builds up with displacement: to the full strength and no further (Janosi–Hanamoto), over a hump to a residual, or over a peak to nothing (Wong).
    ShearDto as "Shear" with shear_schema {
        law: String = Choice { doc: "Name of the law.", words: shear_law_names, default: None },
        residual_ratio: f64 = Number::of(&WongResidual::RESIDUAL_RATIO, "Residual over largest strength K_r (–)."),
        peak_displacement_m: f64 = Number::of(&WongPeak::PEAK_DISPLACEMENT, "Shear displacement K_w at the largest strength (m).").length(),
    }
}

impl ShearDto {
    /// The law, or none for the one that takes the soil's own modulus; nothing where something was reported.
    pub(super) fn check(&self, place: &Scope<'_>) -> Option<Option<ShearLaw>> {
        self.report_oddities(place);
        self.law().required_word(place);
        let law = self.law().looked_up(place, |word| Variant::named(SHEAR_LAWS, word));
        let parameters = [self.residual_ratio(), self.peak_displacement_m()];
        let values = numbers_of(law, &parameters, place);
        match law?.name {
            JanosiHanamoto::NAME => Some(None),
            name => made(ShearLaw::LAWS, name, &parameters, &values, place).map(Some),
        }
    }
}
