//! The pressure–sinkage law of a soil.

use terramechanics::{Bekker, Diameter, Direct, PressureSinkage, Reece, SinkageExponent};
use utoipa::openapi::{RefOr, Schema};

use super::variants::{made, numbers_of};
use crate::catalogue::SoilRecord;
use crate::wire::{Choice, Field, Number, Object, Scope, Spec, Variant, tagged_schema, wire_object};

/// The laws and their parameters.
pub(crate) const LAWS: &[Variant] = &[
    Variant { name: "bekker", required: &["k_c", "k_phi", "n0"], optional: &["n1", "n2"] },
    Variant { name: "direct", required: &["k_s", "n0"], optional: &["n1", "n2"] },
    Variant { name: "reece", required: &["k_c", "k_phi", "unit_weight_n_m3", "n0"], optional: &["n1", "n2"] },
    Variant { name: "diameter", required: &["k", "m", "n0"], optional: &["n1", "n2"] },
];

fn law_names() -> Vec<&'static str> {
    Variant::names(LAWS)
}

fn law_schema(doc: &str, fields: &[(&'static str, &dyn Spec)]) -> RefOr<Schema> {
    tagged_schema(doc, fields, "law", LAWS)
}

wire_object! {
    /// A pressure–sinkage law σ = K_s z^N with N = n0 + n1 s, or n0 − n2 s at negative slip where n2 is given.
    PressureSinkageDto as "PressureSinkage" with law_schema {
        law: String = Choice { doc: "Name of the law.", words: law_names, default: None },
        k_c: f64 = Number::of(&Bekker::K_C, "Cohesive modulus: Bekker's k_c (N/m^(n+1)), may be negative, or Reece's k_c' (–)."),
        k_phi: f64 = Number::of(&Bekker::K_PHI, "Frictional modulus: Bekker's k_phi (N/m^(n+2)) or Reece's k_phi' (–)."),
        k_s: f64 = Number::of(&Direct::K_S, "Sinkage modulus K_s (Pa/m^N)."),
        unit_weight_n_m3: f64 = Number::of(&Reece::UNIT_WEIGHT, "Unit weight γ (N/m³)."),
        k: f64 = Number::of(&Diameter::K, "Coefficient k of Meirion-Griffith & Spenko (N/m^(n+m+2))."),
        m: f64 = Number::of(&Diameter::M, "Exponent m of the wheel's diameter (–)."),
        n0: f64 = Number::of(&SinkageExponent::BASE, "Sinkage exponent without slip (–)."),
        n1: f64 = Number::of(&SinkageExponent::SLIP_GAIN, "Gain of the exponent with slip (–)."),
        n2: f64 = Number::of(&SinkageExponent::SKID_GAIN, "Gain of the exponent with skid (–): N = n0 − n2 s at s < 0; n1 holds there too unless given."),
    }
}

pub(super) fn is_among(fitted: &[(&'static str, f64)], name: &str) -> bool {
    fitted.iter().any(|(known, _)| *known == name)
}

impl PressureSinkageDto {
    /// The law of which all moduli are fitted, with the exponents of the preset; none where the moduli or n0 would be lacking.
    pub(super) fn of_fitted(preset: Option<&SoilRecord>, fitted: &[(&'static str, f64)]) -> Option<Self> {
        let has = |name: &str| is_among(fitted, name);
        let law = match (has("k_s"), has("k_c") && has("k_phi")) {
            (true, _) => "direct",
            (false, true) => "bekker",
            (false, false) => return None,
        };
        let published = |name: &str| {
            let value = preset.and_then(|record| record.values.get(name));
            value.map_or(Field::Absent, |value| Field::Given(value.value))
        };
        let (n0, n1, n2) = (published("n0"), published("n1"), published("n2"));
        let mut dto = Self { law: Field::Given(law.to_owned()), n0, n1, n2, ..Self::default() };
        dto.fill(fitted);
        matches!(dto.n0, Field::Given(_)).then_some(dto)
    }

    /// Puts in what is fitted and absent, as far as the law takes it.
    pub(super) fn fill(&mut self, fitted: &[(&'static str, f64)]) {
        let variant = match &self.law {
            Field::Given(law) => Variant::named(LAWS, law),
            Field::Absent | Field::Wrong(_) => None,
        };
        for &(name, value) in fitted {
            let field = match name {
                "k_s" => &mut self.k_s,
                "k_c" => &mut self.k_c,
                "k_phi" => &mut self.k_phi,
                "n0" => &mut self.n0,
                "n1" => &mut self.n1,
                _ => continue,
            };
            let is_taken = variant.is_some_and(|variant| variant.fields().any(|field| field == name));
            if is_taken && matches!(field, Field::Absent) {
                *field = Field::Given(value);
            }
        }
    }

    pub(super) fn check(&self, place: &Scope<'_>) -> Option<PressureSinkage> {
        self.report_oddities(place);
        self.law().required_word(place);
        let law = self.law().looked_up(place, |word| Variant::named(LAWS, word));
        let parameters =
            [self.k_c(), self.k_phi(), self.k_s(), self.unit_weight_n_m3(), self.k(), self.m(), self.n0(), self.n1(), self.n2()];
        let values = numbers_of(law, &parameters, place);
        made(PressureSinkage::LAWS, law?.name, &parameters, &values, place)
    }
}
