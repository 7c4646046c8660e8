//! The pressure–sinkage law of a soil.

use terramechanics::{Bekker, Diameter, Direct, PressureSinkage, Reece, SinkageExponent};
use utoipa::openapi::{RefOr, Schema};

use super::variants::numbers_of;
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
        k_c: f64 = Number::new("Cohesive modulus: Bekker's k_c (N/m^(n+1)), may be negative, or Reece's k_c' (–).", -1e9, 1e9),
        k_phi: f64 = Number::new("Frictional modulus: Bekker's k_phi (N/m^(n+2)) or Reece's k_phi' (–).", -1e9, 1e12),
        k_s: f64 = Number::new("Sinkage modulus K_s (Pa/m^N).", 1e-6, 1e15),
        unit_weight_n_m3: f64 = Number::new("Unit weight γ (N/m³).", 0.0, 1e6),
        k: f64 = Number::new("Coefficient k of Meirion-Griffith & Spenko (N/m^(n+m+2)).", 1e-6, 1e15),
        m: f64 = Number::new("Exponent m of the wheel's diameter (–).", -10.0, 10.0),
        n0: f64 = Number::new("Sinkage exponent without slip (–).", 1e-3, 10.0),
        n1: f64 = Number::new("Gain of the exponent with slip (–).", -10.0, 10.0).or(0.0),
        n2: f64 = Number::new("Gain of the exponent with skid (–): N = n0 − n2 s at s < 0; n1 holds there too unless given.", -10.0, 10.0),
    }
}

pub(super) fn is_among(fitted: &[(&'static str, f64)], name: &str) -> bool {
    fitted.iter().any(|(known, _)| *known == name)
}

impl PressureSinkageDto {
    /// A law that is as good as any other, for what all of them cancel in.
    pub(super) fn any() -> Self {
        Self { law: Field::Given("direct".to_owned()), k_s: Field::Given(1e6), n0: Field::Given(1.0), ..Self::default() }
    }

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
        let [k_c, k_phi, k_s, unit_weight, k, m, base, slip_gain, skid_gain] = numbers_of(law, &parameters, place);
        let exponent = SinkageExponent { base: base?, slip_gain: slip_gain?, skid_gain };
        Some(match law?.name {
            "bekker" => PressureSinkage::Bekker(Bekker { k_c: k_c?, k_phi: k_phi?, exponent }),
            "direct" => PressureSinkage::Direct(Direct { k_s: k_s?, exponent }),
            "reece" => PressureSinkage::Reece(Reece { k_c: k_c?, k_phi: k_phi?, unit_weight: unit_weight?, exponent }),
            "diameter" => PressureSinkage::Diameter(Diameter { k: k?, m: m?, exponent }),
            unread => return place.unread(unread),
        })
    }
}
