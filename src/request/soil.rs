//! The soil of a request.

use terramechanics::{Contact, JanosiHanamoto, ShearLaw, Soil, SoilParams};

use super::pressure_sinkage::{PressureSinkageDto, is_among};
use super::shear::ShearDto;
use super::wheel::missing;
use crate::catalogue::{self, SoilRecord};
use crate::wire::{Choice, Entry, Field, Nested, Number, Object, Scope, wire_object};

wire_object! {
    /// A soil. Without `preset`, `cohesion_pa`, `friction_angle_rad`, `pressure_sinkage` (save where it cancels: in /v1/coupled and the linear estimator) and what the shear law needs are required; with it, any field beside it overrides the catalogue's.
    SoilDto as "Soil" {
        preset: String = Choice { doc: "A soil of the catalogue, see /v1/soils.", words: catalogue::soil_ids, default: None },
        cohesion_pa: f64 = Number::within(&Soil::COHESION, "Cohesion c (Pa)."),
        friction_angle_rad: f64 = Number::within(&Soil::FRICTION_ANGLE, "Internal friction angle φ (rad).").angle(),
        shear_modulus_m: f64 = Number::within(&JanosiHanamoto::MODULUS, "Shear deformation modulus K (m) of Janosi–Hanamoto's law; no other needs it.").length(),
        pressure_sinkage: PressureSinkageDto = Nested::optional("Pressure–sinkage law; replaces the preset's as a whole."),
        lateral_shear_modulus_m: f64 = Number::within(&Soil::LATERAL_SHEAR_MODULUS, "Shear deformation modulus K_y across the direction of travel (m); unless given or in the catalogue, shear_modulus_m, or the shear law's own length where that is not there either.").length(),
        unit_weight_n_m3: f64 = Number::within(&Soil::UNIT_WEIGHT, "Unit weight γ (N/m³), for what lies beside and in front of the wheel; that of Reece's law unless given or in the catalogue."),
        shear: ShearDto = Nested::optional("Shear law; else the preset's, else janosi_hanamoto with shear_modulus_m."),
    }
}

/// The laws that a request cannot do without; others may be absent.
#[derive(Clone, Copy)]
pub(crate) struct Needs {
    pub(crate) pressure_sinkage: bool,
    pub(crate) shear: bool,
}

impl Needs {
    pub(crate) const BOTH_LAWS: Self = Self { pressure_sinkage: true, shear: true };
}

impl SoilDto {
    /// The soil, and the contact that the catalogue measured with it.
    pub(crate) fn check(&self, place: &Scope<'_>, needs: Needs) -> Option<(Soil, Option<Contact>)> {
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
        let shear = if needs.shear || self.has_shear(preset) {
            self.shear_law(place, preset, || value(self.shear_modulus_m())).map(Some)
        } else {
            Some(None)
        };
        let optional = |entry: Entry<'_, f64>| {
            if entry.is_present() { entry.checked(place) } else { preset.and_then(|record| record.number(entry.name)) }
        };
        // Wong's laws do not take `shear_modulus_m`; where it is there all the same, it says how the soil yields to shear.
        let beside_another_law = || match shear.flatten() {
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
            law.given(place).and_then(|dto| dto.check(&place.field(law.name))).map(Some)
        } else {
            let published = preset.and_then(SoilRecord::pressure_sinkage);
            if published.is_none() && needs.pressure_sinkage && !unknown_preset {
                missing_law(place, law.name, preset);
            }
            if published.is_none() && needs.pressure_sinkage { None } else { Some(published) }
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
        let preset = self.record();
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

    /// What the catalogue has of the preset, if it is one; nothing is reported.
    fn record(&self) -> Option<&'static SoilRecord> {
        match &self.preset {
            Field::Given(id) => catalogue::soil(id),
            Field::Absent | Field::Wrong(_) => None,
        }
    }

    /// The soil with other laws, where there are any.
    pub(super) fn with_laws(&self, shear: &Entry<'_, ShearDto>, pressure_sinkage: &Entry<'_, PressureSinkageDto>) -> Self {
        let (shear, pressure_sinkage) = (shear.or(&self.shear), pressure_sinkage.or(&self.pressure_sinkage));
        Self { shear, pressure_sinkage, ..self.clone() }
    }

    /// Whether a shear law is known, here or in the catalogue.
    fn has_shear(&self, preset: Option<&SoilRecord>) -> bool {
        let published = preset.is_some_and(|record| record.shear().is_some() || record.number("shear_modulus_m").is_some());
        published || self.shear().is_present() || self.shear_modulus_m().is_present()
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
