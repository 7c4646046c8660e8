//! The soil of a request.

mod exponent;
mod needs;

pub(crate) use needs::{LawOrigin, Needs};

use terramechanics::{Contact, Declared, Direct, JanosiHanamoto, PressureSinkage, ShearLaw, SinkageExponent, Soil, SoilParams};
use terramechanics_reading::{Base, Field, Lookup, Number, Object, Reader, Scope, Tagged};

use super::fitted_law;
use super::laws::{self, own_field};
use super::preset::Preset;
use super::weights::{BULK_DENSITY, GRANULAR_STIFFNESS, GRAVITY, UNIT_WEIGHT, Weights};
use super::{Described, Documented, Shape};
use crate::catalogue::{self, SoilRecord, is_of_exponent};

const PRESET: Field<Lookup<&'static SoilRecord>> = Field::new(
    "preset",
    "A soil of the catalogue, see /v1/soils.",
    Lookup { name: Some("SoilPreset"), words: catalogue::soil_ids, find: catalogue::soil },
);
pub(crate) const COHESION: Field<Number> = own_field(&Soil::COHESION);
pub(super) const FRICTION_ANGLE: Field<Number> = own_field(&Soil::FRICTION_ANGLE);
pub(super) const SHEAR_MODULUS: Field<Number> = own_field(&JanosiHanamoto::MODULUS);
pub(super) const PRESSURE_SINKAGE: Field<&Tagged> = Field::new(
    "pressure_sinkage",
    "Pressure–sinkage law. With `law` it replaces the preset's as a whole; without, its values replace those of the preset's law.",
    &laws::PRESSURE_SINKAGE,
);
pub(super) const LATERAL_SHEAR_MODULUS: Field<Number> = own_field(&Soil::LATERAL_SHEAR_MODULUS);
pub(crate) const SHEAR: Field<&Tagged> = Field::new(
    "shear",
    "Shear law; else the preset's, else janosi_hanamoto with shear_modulus_m. Without `law` its values replace those of the preset's law.",
    &laws::SHEAR,
);
/// The laws of a soil, which a variant of a comparison may have in place of its own.
pub(crate) const VARIED_SHEAR: Field<&Tagged> = Field { meaning: "Shear law, for that of the soil.", ..SHEAR };
pub(crate) const VARIED_PRESSURE_SINKAGE: Field<&Tagged> =
    Field { meaning: "Pressure–sinkage law, for that of the soil.", ..PRESSURE_SINKAGE };

pub(crate) const SOIL: Object = Object {
    name: "Soil",
    doc: "A soil. Without `preset`, `cohesion_pa`, `friction_angle_rad`, `pressure_sinkage` (save where it cancels: in the closed forms under a load that is known beside the sinkage, in /v1/coupled and in the linear estimator; the quadrature then takes its `n0` alone) and what the shear law needs are required; the method resistive_force needs `friction_angle_rad` and `bulk_density_kg_m3` (or `granular_stiffness_n_m3`) instead. With a preset, any field beside it overrides the catalogue's, and a field inside a law without `law` that of the preset's law.",
    groups: &[&[
        &PRESET,
        &COHESION,
        &FRICTION_ANGLE,
        &SHEAR_MODULUS,
        &PRESSURE_SINKAGE,
        &LATERAL_SHEAR_MODULUS,
        &UNIT_WEIGHT,
        &BULK_DENSITY,
        &GRAVITY,
        &GRANULAR_STIFFNESS,
        &SHEAR,
    ]],
};

pub(crate) type SoilObject = Documented<Soil>;

impl Described for Soil {
    const SHAPE: Shape = Shape::Object(&SOIL);
}

/// A soil that was read.
#[derive(Clone, Copy)]
pub(crate) struct FoundSoil {
    pub(crate) soil: Soil,
    /// The contact that the catalogue measured with it.
    pub(crate) contact: Option<Contact>,
    pub(crate) law: LawOrigin,
    entry: Option<&'static SoilRecord>,
}

/// The soil, from the request and the preset it names.
pub(crate) fn read(object: &Reader<'_>, needs: Needs<'_>) -> Option<FoundSoil> {
    let preset = Preset::read(object, &PRESET);
    let value = |field: &Field<Number>| preset.value(object, field, (needs.fitted)(field.name));
    let or_none = |field: &Field<Number>| preset.optional(object, field).map(|value| value.unwrap_or(0.0));
    let weights = Weights::read(object, &preset).map(|weights| weights.with_fitted(needs.fitted));
    let weights =
        if needs.granular_stiffness { weights.map(|weights| weights.with_assumed_density(object, &preset)) } else { weights };
    let follows = needs.granular_stiffness && weights.as_ref().is_some_and(|weights| weights.granular_stiffness.is_none());
    let cohesion = if needs.strength { value(&COHESION) } else { or_none(&COHESION) };
    let friction_angle = if needs.strength || follows { value(&FRICTION_ANGLE) } else { or_none(&FRICTION_ANGLE) };
    let shear = shear(object, &preset, needs);
    let lateral_shear_modulus = preset.optional(object, &LATERAL_SHEAR_MODULUS).map(|own| {
        // Wong's laws do not take `shear_modulus_m`; where it is there all the same, it says how the soil yields to shear.
        let beside_another_law = || match shear.flatten() {
            Some(ShearLaw::WongResidual(_) | ShearLaw::WongPeak(_)) => preset.optional(object, &SHEAR_MODULUS).flatten(),
            Some(ShearLaw::JanosiHanamoto(_)) | None => None,
        };
        own.or_else(beside_another_law)
    });
    let is_stiff = !needs.granular_stiffness
        || weights.as_ref().is_some_and(|weights| weights.are_enough(object, &preset, (&FRICTION_ANGLE, friction_angle)));
    let weight = weights.as_ref().and_then(Weights::unit_weight);
    let exponent_alone = exponent::alone(object, &preset, needs);
    let pressure_sinkage = match exponent_alone {
        Some(None) => pressure_sinkage(object, &preset, needs, weight),
        Some(Some(_)) => Some((None, LawOrigin::Absent)),
        None => None,
    };
    let (pressure_sinkage, law) = pressure_sinkage?;
    let params = SoilParams {
        cohesion: cohesion?,
        friction_angle: friction_angle?,
        shear: shear?,
        pressure_sinkage,
        exponent_alone: exponent_alone?,
        lateral_shear_modulus: lateral_shear_modulus?,
        ..SoilParams::BARE
    };
    let weights = weights?;
    if !preset.is_sound || !is_stiff {
        return None;
    }
    // Of a law that is overridden, what was sent holds as it is, and the rest is the catalogue's.
    let overrides = |name: &'static str| {
        let field: Field<Number> = Field::new(name, "", Number::any(""));
        object.within(&PRESSURE_SINKAGE).is_some_and(|law| law.has(&field))
    };
    let is_published = |name: &'static str| match law {
        LawOrigin::Catalogue => true,
        LawOrigin::Overridden => !overrides(name),
        LawOrigin::Request | LawOrigin::Replaced | LawOrigin::Absent => false,
    };
    let soil =
        weights.soil(params, is_published(Soil::UNIT_WEIGHT.name)).map_err(|invalid| object.place().fault(invalid)).ok()?;
    let fitted_slip =
        preset.entry.filter(|_| is_published(SinkageExponent::SLIP_GAIN.name)).and_then(|record| record.largest_fitted_slip);
    let soil = fitted_slip.map_or(soil, |slip| soil.fitted_up_to(slip));
    Some(FoundSoil { soil, contact: preset.entry.and_then(SoilRecord::contact), law, entry: preset.entry })
}

impl FoundSoil {
    /// The range that the catalogue has of a parameter of the preset, and the preset.
    pub(crate) fn measured(&self, parameter: &str) -> Option<(&'static str, [f64; 2])> {
        let record = self.entry?;
        Some((&record.id, record.range(parameter)?))
    }

    /// A soil that stands for none.
    pub(crate) fn bare(soil: Soil) -> Self {
        Self { soil, contact: None, law: LawOrigin::Absent, entry: None }
    }

    /// Reports at the soil's `place` that the pressure–sinkage law is lacking, where it and its exponent are; false where it did.
    /// `enough` is added to the message: what is enough of a law.
    pub(crate) fn has_law(&self, place: &Scope<'_>, enough: &str) -> bool {
        let is_there = self.soil.sinkage_exponent().is_some();
        if !is_there {
            missing_law(&place.field(PRESSURE_SINKAGE.name), &Preset { entry: self.entry, is_sound: true }, enough);
        }
        is_there
    }
}

/// The shear law, if there is one; the modulus is asked for only where the law needs it, else it is checked by its bounds alone.
fn shear(object: &Reader<'_>, preset: &Preset<SoilRecord>, needs: Needs<'_>) -> Option<Option<ShearLaw>> {
    let published = preset.entry.and_then(SoilRecord::shear);
    let value =
        |name: &str| published.iter().flat_map(ShearLaw::parameters).find(|(of, _)| of.name == name).map(|(_, value)| value);
    let base = preset.entry.map(|_| Base { form: published.map_or(JanosiHanamoto::NAME, |law| law.law().name), value: &value });
    let chosen = match object.chosen(&SHEAR, base.as_ref(), &|_| None)? {
        Some(chosen) => laws::shear(&chosen)?,
        None => published,
    };
    if let Some(law) = chosen {
        return object.optional(&SHEAR_MODULUS).map(|_| Some(law));
    }
    let modulus = preset.optional(object, &SHEAR_MODULUS)?;
    if modulus.is_none() && !needs.shear && !object.has(&SHEAR) {
        return Some(None);
    }
    let modulus = modulus.or_else(|| (needs.fitted)(SHEAR_MODULUS.name));
    let modulus = modulus.or_else(|| preset.assumed(object, &SHEAR_MODULUS));
    if modulus.is_none() {
        preset.missing(object, &SHEAR_MODULUS);
    }
    modulus.map(|modulus| Some(ShearLaw::JanosiHanamoto(JanosiHanamoto { modulus })))
}

/// The pressure–sinkage law: that of the request, else that of the preset, else the one whose moduli are fitted.
fn pressure_sinkage(
    object: &Reader<'_>,
    preset: &Preset<SoilRecord>,
    needs: Needs<'_>,
    unit_weight: Option<f64>,
) -> Option<(Option<PressureSinkage>, LawOrigin)> {
    let value = |name: &str| preset.entry.and_then(|record| record.number(name));
    let base = preset.entry.and_then(|record| record.law.as_deref()).map(|form| Base { form, value: &value });
    let of_soil = |name: &str| (needs.fitted)(name).or_else(|| unit_weight.filter(|_| name == UNIT_WEIGHT.name));
    if let Some(chosen) = object.chosen(&PRESSURE_SINKAGE, base.as_ref(), &of_soil)? {
        let is_whole = base.is_none() || object.names_form(&PRESSURE_SINKAGE);
        let origin = if is_whole { LawOrigin::Request } else { LawOrigin::Overridden };
        return laws::pressure_sinkage(&chosen).map(|law| (Some(law), origin));
    }
    let published = preset.entry.and_then(SoilRecord::pressure_sinkage);
    // A soil has one sinkage modulus: where it is fitted, that of another law has no place.
    let replaces = (needs.fitted)(Direct::K_S.name).is_some() && !matches!(published, None | Some(PressureSinkage::Direct(_)));
    let of_fitted = || of_fitted(preset.entry, needs.fitted);
    match published {
        Some(law) if !replaces => Some((Some(law), LawOrigin::Catalogue)),
        Some(_) => of_fitted().map(|law| (Some(law), LawOrigin::Replaced)),
        None => match of_fitted() {
            Some(law) => Some((Some(law), LawOrigin::Request)),
            None if needs.perhaps_pressure_sinkage => {
                let assumed = assumed_law(object, preset);
                Some((assumed, if assumed.is_some() { LawOrigin::Catalogue } else { LawOrigin::Absent }))
            }
            None if !needs.pressure_sinkage => Some((None, LawOrigin::Absent)),
            None => {
                let assumed = assumed_law(object, preset);
                if assumed.is_none() {
                    missing_law(&object.place_of(&PRESSURE_SINKAGE), preset, "");
                }
                assumed.map(|law| (Some(law), LawOrigin::Catalogue))
            }
        },
    }
}

/// The law of which all moduli are fitted, with the exponents of the preset; none where the moduli or n0 would be lacking.
fn of_fitted(preset: Option<&SoilRecord>, fitted: &dyn Fn(&str) -> Option<f64>) -> Option<PressureSinkage> {
    let value = |name: &str| {
        let published = preset.filter(|_| is_of_exponent(name)).and_then(|record| record.number(name));
        published.or_else(|| fitted(name))
    };
    fitted_law::laws().find_map(|law| law.from_named(value).ok())
}

/// The law of another soil, if it may be assumed; its parameters are then kept for the answer.
fn assumed_law(object: &Reader<'_>, preset: &Preset<SoilRecord>) -> Option<PressureSinkage> {
    let record = preset.entry.filter(|_| object.place().may_assume())?;
    let law = record.lender()?.pressure_sinkage()?;
    let place = object.place_of(&PRESSURE_SINKAGE);
    for parameter in law.law().parameters {
        if let Some(substitute) = record.substitutes().iter().find(|one| one.is_of_law(parameter.name)) {
            place.field(parameter.name).assume(&record.id, substitute.value, &substitute.reason);
        }
    }
    Some(law)
}

/// Reports that the pressure–sinkage law is missing, with the parameters that are not published where some are.
fn missing_law(place: &Scope<'_>, preset: &Preset<SoilRecord>, enough: &str) {
    let Some(record) = preset.entry else {
        // What was sent for the preset was reported.
        if preset.is_sound {
            place.fault(format_args!("is required{enough}"));
        }
        return;
    };
    let lacking = record
        .law
        .as_deref()
        .map_or_else(String::new, |law| format!("; of the law `{law}` it lacks {}", record.missing_of_law().join(", ")));
    let offer = record.lender().map_or_else(String::new, |lender| {
        format!("; with \"assume\": true it is the law of `{}`, see `assumed` in /v1/soils/{}", lender.id, record.id)
    });
    place.fault(format_args!("is required: the catalogue has no published value for `{}`{lacking}{offer}{enough}", record.id));
}
