//! The soil of a request.

use std::f64::consts::FRAC_PI_2;

use terramechanics::{
    Bekker, Contact, Diameter, Direct, JanosiHanamoto, PressureSinkage, Reece, ShearLaw, SinkageExponent, Soil, SoilParams,
    WongPeak, WongResidual,
};
use utoipa::openapi::{RefOr, Schema};

use super::wheel::missing;
use crate::catalogue::{self, SoilRecord};
use crate::wire::{Choice, Entry, Field, Nested, Number, Object, Scope, Spec, Variant, tagged_schema, wire_object};

wire_object! {
    /// A soil. Without `preset`, `cohesion_pa`, `friction_angle_rad`, `pressure_sinkage` (save where it cancels: in /v1/coupled and the linear estimator) and what the shear law needs are required; with it, any field beside it overrides the catalogue's.
    SoilDto as "Soil" {
        preset: String = Choice { doc: "A soil of the catalogue, see /v1/soils.", words: catalogue::soil_ids, default: None },
        cohesion_pa: f64 = Number::new("Cohesion c (Pa).", 0.0, 1e8),
        friction_angle_rad: f64 = Number::new("Internal friction angle φ (rad).", 0.0, FRAC_PI_2).open_above().angle(),
        shear_modulus_m: f64 = Number::new("Shear deformation modulus K (m) of Janosi–Hanamoto's law; no other needs it.", 1e-6, 10.0).length(),
        pressure_sinkage: PressureSinkageDto = Nested::optional("Pressure–sinkage law; replaces the preset's as a whole."),
        lateral_shear_modulus_m: f64 = Number::new("Shear deformation modulus K_y across the direction of travel (m); unless given or in the catalogue, shear_modulus_m, or the shear law's own length where that is not there either.", 1e-6, 10.0).length(),
        unit_weight_n_m3: f64 = Number::new("Unit weight γ (N/m³), for what lies beside and in front of the wheel; that of Reece's law unless given or in the catalogue.", 1.0, 1e6),
        shear: ShearDto = Nested::optional("Shear law; else the preset's, else janosi_hanamoto with shear_modulus_m."),
    }
}

impl SoilDto {
    /// The soil, and the contact that the catalogue measured with it.
    pub(crate) fn check(&self, place: &Scope<'_>) -> Option<(Soil, Option<Contact>)> {
        self.report_oddities(place);
        let preset = self.preset().looked_up(place, catalogue::soil);
        let unknown_preset = self.preset().is_present() && preset.is_none();
        let value = |entry: Entry<'_, f64>| {
            if entry.is_present() {
                return entry.checked(place);
            }
            let published = preset.and_then(|record| record.number(entry.name));
            if published.is_none() && !unknown_preset {
                missing(place, entry.name, preset.map(|record| record.id.as_str()));
            }
            published
        };
        let cohesion = value(self.cohesion_pa());
        let friction_angle = value(self.friction_angle_rad());
        let shear = self.shear_law(place, preset, || value(self.shear_modulus_m()));
        let optional = |entry: Entry<'_, f64>| {
            if entry.is_present() { entry.checked(place) } else { preset.and_then(|record| record.number(entry.name)) }
        };
        // Wong's laws do not take `shear_modulus_m`; where it is there all the same, it says how the soil yields to shear.
        let beside_another_law = || match shear {
            Some(ShearLaw::WongResidual(_) | ShearLaw::WongPeak(_)) => optional(self.shear_modulus_m()),
            Some(ShearLaw::JanosiHanamoto(_)) | None => None,
        };
        let lateral_shear_modulus = match self.lateral_shear_modulus_m() {
            entry if entry.is_present() => entry.checked(place),
            entry => preset.and_then(|record| record.number(entry.name)).or_else(beside_another_law),
        };
        let unit_weight = optional(self.unit_weight_n_m3());
        let law = self.pressure_sinkage();
        let pressure_sinkage = if law.is_present() {
            law.given(place).and_then(|dto| dto.check(&place.field(law.name)))
        } else {
            let published = preset.and_then(SoilRecord::pressure_sinkage);
            if published.is_none() && !unknown_preset {
                missing_law(place, law.name, preset);
            }
            published
        };
        let params = SoilParams {
            cohesion: cohesion?,
            friction_angle: friction_angle?,
            shear: shear?,
            pressure_sinkage: pressure_sinkage?,
            unit_weight,
            lateral_shear_modulus,
        };
        if unknown_preset {
            return None;
        }
        let soil = Soil::new(params).map_err(|invalid| place.fault(invalid)).ok()?;
        let soil = preset.and_then(SoilRecord::gravity).map_or(soil, |gravity| soil.in_gravity(gravity));
        let fitted_slip = preset.filter(|_| !law.is_present()).and_then(|record| record.largest_fitted_slip);
        let soil = fitted_slip.map_or(soil, |slip| soil.fitted_up_to(slip));
        Some((soil, preset.and_then(SoilRecord::contact)))
    }

    /// The soil with a value for each of `fitted` that neither it nor its preset has; and whether the preset's law gave way to
    /// the direct one, because the modulus of that is fitted.
    pub(super) fn filled(&self, fitted: &[(&'static str, f64)]) -> (Self, bool) {
        let preset = match &self.preset {
            Field::Given(id) => catalogue::soil(id),
            Field::Absent | Field::Wrong(_) => None,
        };
        let mut soil = self.clone();
        for &(name, value) in fitted {
            let field = match name {
                "cohesion_pa" => &mut soil.cohesion_pa,
                "friction_angle_rad" => &mut soil.friction_angle_rad,
                "shear_modulus_m" => &mut soil.shear_modulus_m,
                _ => continue,
            };
            if matches!(field, Field::Absent) && preset.is_none_or(|record| !record.values.contains_key(name)) {
                *field = Field::Given(value);
            }
        }
        let gives_way = match &mut soil.pressure_sinkage {
            Field::Given(law) => {
                law.fill(fitted);
                false
            }
            Field::Absent => {
                let published = preset.filter(|record| record.pressure_sinkage().is_some());
                let law = PressureSinkageDto::of_fitted(preset, fitted);
                let gives_way =
                    published.is_some_and(|record| record.law.as_deref() != Some("direct")) && is_among(fitted, "k_s");
                if let Some(law) = law.filter(|_| published.is_none() || gives_way) {
                    soil.pressure_sinkage = Field::Given(law);
                }
                gives_way
            }
            Field::Wrong(_) => false,
        };
        (soil, gives_way)
    }

    /// The soil with other laws, where there are any.
    pub(super) fn with_laws(&self, shear: &Entry<'_, ShearDto>, pressure_sinkage: &Entry<'_, PressureSinkageDto>) -> Self {
        let (shear, pressure_sinkage) = (shear.or(&self.shear), pressure_sinkage.or(&self.pressure_sinkage));
        Self { shear, pressure_sinkage, ..self.clone() }
    }

    /// The soil with any law where neither it nor its preset has a pressure–sinkage law, for what that law cancels in; and whether
    /// it has one of its own.
    pub(super) fn with_any_law(&self) -> (Self, bool) {
        let published = match &self.preset {
            Field::Given(id) => catalogue::soil(id).is_some_and(|record| record.pressure_sinkage().is_some()),
            Field::Absent | Field::Wrong(_) => false,
        };
        let mut soil = self.clone();
        let is_known = self.pressure_sinkage().is_present() || published;
        if !is_known {
            let (law, k_s, n0) = (Field::Given("direct".to_owned()), Field::Given(1e6), Field::Given(1.0));
            soil.pressure_sinkage = Field::Given(PressureSinkageDto { law, k_s, n0, ..Default::default() });
        }
        (soil, is_known)
    }

    /// The shear law; `modulus` is asked for only where the law needs it, else it is checked by its bounds alone.
    fn shear_law(
        &self,
        place: &Scope<'_>,
        preset: Option<&SoilRecord>,
        modulus: impl FnOnce() -> Option<f64>,
    ) -> Option<ShearLaw> {
        let law = self.shear();
        let chosen =
            if law.is_present() { law.given(place)?.check(&place.field(law.name))? } else { preset.and_then(SoilRecord::shear) };
        match chosen {
            Some(law) => {
                let given = self.shear_modulus_m();
                if given.is_present() { given.checked(place).map(|_| law) } else { Some(law) }
            }
            None => Some(ShearLaw::JanosiHanamoto(JanosiHanamoto { modulus: modulus()? })),
        }
    }
}

/// Reports that the pressure–sinkage law is missing, with the parameters that are not published where some are.
fn missing_law(place: &Scope<'_>, name: &'static str, preset: Option<&SoilRecord>) {
    match preset.map(|record| (record, record.law.as_deref(), record.missing_of_law())) {
        Some((record, Some(law), parameters)) => place.field(name).fault(format_args!(
            "is required: the catalogue has no published value for `{}`; of the law `{law}` it lacks {}",
            record.id,
            parameters.join(", ")
        )),
        _ => missing(place, name, preset.map(|record| record.id.as_str())),
    }
}

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
        residual_ratio: f64 = Number::new("Residual over largest strength K_r (–).", 1e-3, 1.0),
        peak_displacement_m: f64 = Number::new("Shear displacement K_w at the largest strength (m).", 1e-6, 10.0).length(),
    }
}

impl ShearDto {
    /// The law, or none for the one that takes the soil's own modulus; nothing where something was reported.
    fn check(&self, place: &Scope<'_>) -> Option<Option<ShearLaw>> {
        self.report_oddities(place);
        self.law().required_word(place);
        let law = self.law().looked_up(place, |word| Variant::named(SHEAR_LAWS, word));
        let [residual_ratio, peak_displacement] = numbers_of(law, &[self.residual_ratio(), self.peak_displacement_m()], place);
        Some(match law?.name {
            "janosi_hanamoto" => None,
            "wong_residual" => Some(ShearLaw::WongResidual(WongResidual {
                residual_ratio: residual_ratio?,
                peak_displacement: peak_displacement?,
            })),
            "wong_peak" => Some(ShearLaw::WongPeak(WongPeak { peak_displacement: peak_displacement? })),
            unread => return place.unread(unread),
        })
    }
}

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

fn is_among(fitted: &[(&'static str, f64)], name: &str) -> bool {
    fitted.iter().any(|(known, _)| *known == name)
}

impl PressureSinkageDto {
    /// The law of which all moduli are fitted, with the exponents of the preset; none where the moduli or n0 would be lacking.
    fn of_fitted(preset: Option<&SoilRecord>, fitted: &[(&'static str, f64)]) -> Option<Self> {
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
    fn fill(&mut self, fitted: &[(&'static str, f64)]) {
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

    fn check(&self, place: &Scope<'_>) -> Option<PressureSinkage> {
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

/// The numbers of a tagged object: those its variant takes, checked; one it does not take is reported. Where the variant is
/// not known, what was sent is checked by its bounds alone.
pub(super) fn numbers_of<const N: usize>(
    variant: Option<&Variant>,
    entries: &[Entry<'_, f64>; N],
    place: &Scope<'_>,
) -> [Option<f64>; N] {
    entries.each_ref().map(|entry| match variant {
        None => entry.checked(place),
        Some(variant) if variant.required.contains(&entry.name) => entry.required_number(place),
        Some(variant) if variant.optional.contains(&entry.name) => entry.or_default(place),
        Some(variant) => {
            if entry.is_present() {
                let takes: Vec<&str> = variant.fields().collect();
                let takes = if takes.is_empty() { "no further field".to_owned() } else { takes.join(", ") };
                place.field(entry.name).fault(format_args!("`{}` has no such field; it takes {takes}", variant.name));
            }
            None
        }
    })
}
