//! Records of the catalogue as they are kept, and as they are shown.

use std::collections::BTreeMap;

use serde::{Deserialize, Serialize};
use terramechanics::{
    Bekker, Contact, ContactParams, Diameter, Direct, PeakRule, PressureSinkage, Reece, ShearLaw, SinkageExponent, WongPeak,
    WongResidual,
};
use utoipa::ToSchema;

use crate::request::{LAWS, RULES, SHEAR_LAWS};

/// How well a value is founded.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Deserialize, Serialize, ToSchema)]
#[serde(rename_all = "lowercase")]
pub(crate) enum Grade {
    /// Read in the source itself.
    Primary,
    /// Quoted by others; the source itself was not read.
    Secondary,
    /// Assigned from a guideline or another soil or wheel.
    Proxy,
}

/// One value of a record.
#[derive(Debug, Clone, Deserialize)]
#[serde(deny_unknown_fields)]
pub(crate) struct Value {
    /// In SI units.
    pub(crate) value: f64,
    /// As published, with its unit.
    pub(crate) published: String,
    source: Option<String>,
    grade: Option<Grade>,
    note: Option<String>,
}

/// A wheel of the catalogue.
#[derive(Debug, Clone, Deserialize)]
#[serde(deny_unknown_fields)]
pub(crate) struct WheelRecord {
    pub(crate) id: String,
    name: String,
    kind: String,
    pub(crate) source: String,
    grade: Grade,
    note: Option<String>,
    pub(crate) values: BTreeMap<String, Value>,
}

/// A soil of the catalogue.
#[derive(Debug, Clone, Deserialize)]
#[serde(deny_unknown_fields)]
pub(crate) struct SoilRecord {
    pub(crate) id: String,
    name: String,
    kind: String,
    pub(crate) source: String,
    grade: Grade,
    note: Option<String>,
    pub(crate) law: String,
    pub(crate) values: BTreeMap<String, Value>,
    shear: Option<ShearRecord>,
    contact: Option<ContactRecord>,
}

/// A shear law other than Janosi–Hanamoto's.
#[derive(Debug, Clone, Deserialize)]
struct ShearRecord {
    law: String,
    #[serde(flatten)]
    values: BTreeMap<String, Value>,
}

/// A measured contact.
#[derive(Debug, Clone, Deserialize)]
struct ContactRecord {
    rule: String,
    #[serde(flatten)]
    values: BTreeMap<String, Value>,
}

/// One value as it is shown, complete with its source.
#[derive(Debug, Serialize, ToSchema)]
#[schema(as = CatalogueValue)]
pub(crate) struct ValueView<'a> {
    /// In SI units.
    value: f64,
    /// As published, with its unit.
    published: &'a str,
    /// Where it was published.
    source: &'a str,
    grade: Grade,
    /// What a user should know of it.
    #[serde(skip_serializing_if = "Option::is_none")]
    note: Option<&'a str>,
}

/// A wheel as it is shown.
#[derive(Debug, Serialize, ToSchema)]
#[schema(as = CatalogueWheel)]
pub(crate) struct WheelView<'a> {
    /// Its name as a `preset`.
    #[schema(example = "letter")]
    id: &'a str,
    name: &'a str,
    /// Paper, flight or test.
    kind: &'a str,
    /// Where its values were published, unless a value says otherwise.
    source: &'a str,
    grade: Grade,
    /// What a user should know of it.
    #[serde(skip_serializing_if = "Option::is_none")]
    note: Option<&'a str>,
    /// The wheel as a request would spell it out.
    wheel: BTreeMap<&'a str, f64>,
    /// Every value with its source; also some that are no part of a request, such as `nominal_load_n`.
    values: BTreeMap<&'a str, ValueView<'a>>,
    /// Required fields without a published value: a request has to add them.
    missing: Vec<&'static str>,
}

/// A soil as it is shown.
#[derive(Debug, Serialize, ToSchema)]
#[schema(as = CatalogueSoil)]
pub(crate) struct SoilView<'a> {
    /// Its name as a `preset`.
    #[schema(example = "letter-sand")]
    id: &'a str,
    name: &'a str,
    /// Lunar, martian, simulant, test-bed sand, terrestrial, snow.
    kind: &'a str,
    /// Where its values were published, unless a value says otherwise.
    source: &'a str,
    grade: Grade,
    /// What a user should know of it.
    #[serde(skip_serializing_if = "Option::is_none")]
    note: Option<&'a str>,
    /// The soil as a request would spell it out, without what is missing.
    soil: SoilBody<'a>,
    /// The contact that was measured with it, which holds unless a request has its own.
    #[serde(skip_serializing_if = "Option::is_none")]
    contact: Option<TaggedBody<'a>>,
    /// Every value with its source.
    values: BTreeMap<&'a str, ValueView<'a>>,
    /// Required fields without a published value: a request has to add them.
    missing: Vec<&'static str>,
}

/// Fields of a soil.
#[derive(Debug, Serialize, ToSchema)]
#[schema(as = CatalogueSoilFields)]
struct SoilBody<'a> {
    #[serde(flatten)]
    own: BTreeMap<&'a str, f64>,
    pressure_sinkage: TaggedBody<'a>,
    #[serde(skip_serializing_if = "Option::is_none")]
    shear: Option<TaggedBody<'a>>,
}

/// A law or a rule with its parameters.
#[derive(Debug, Serialize, ToSchema)]
#[schema(as = CatalogueLaw)]
struct TaggedBody<'a> {
    #[serde(skip_serializing_if = "Option::is_none")]
    law: Option<&'a str>,
    #[serde(skip_serializing_if = "Option::is_none")]
    rule: Option<&'a str>,
    #[serde(flatten)]
    parameters: BTreeMap<&'a str, f64>,
}

const SOIL_REQUIRED: [&str; 3] = ["cohesion_pa", "friction_angle_rad", "shear_modulus_m"];
pub(super) const SOIL_FIELDS: [&str; 5] =
    ["cohesion_pa", "friction_angle_rad", "shear_modulus_m", "lateral_shear_modulus_m", "unit_weight_n_m3"];
const WHEEL_FIELDS: [&str; 4] = ["radius_m", "width_m", "lug_height_m", "lug_coefficient"];
const WHEEL_REQUIRED: [&str; 2] = ["radius_m", "width_m"];

type Values = BTreeMap<String, Value>;

/// The values of the given names that are there.
fn numbers<'a>(values: &'a Values, names: &[&str]) -> BTreeMap<&'a str, f64> {
    values.iter().filter(|(name, _)| names.contains(&name.as_str())).map(|(name, value)| (name.as_str(), value.value)).collect()
}

fn absent(values: &Values, names: impl IntoIterator<Item = &'static str>) -> Vec<&'static str> {
    names.into_iter().filter(|name| !values.contains_key(*name)).collect()
}

fn views<'a>(values: &'a Values, source: &'a str, grade: Grade) -> BTreeMap<&'a str, ValueView<'a>> {
    let view = |value: &'a Value| ValueView {
        value: value.value,
        published: &value.published,
        source: value.source.as_deref().unwrap_or(source),
        grade: value.grade.unwrap_or(grade),
        note: value.note.as_deref(),
    };
    values.iter().map(|(name, value)| (name.as_str(), view(value))).collect()
}

impl WheelRecord {
    /// Required fields that are not known.
    pub(crate) fn missing(&self) -> Vec<&'static str> {
        absent(&self.values, WHEEL_REQUIRED)
    }

    /// The record as it is shown.
    pub(crate) fn view(&self) -> WheelView<'_> {
        WheelView {
            id: &self.id,
            name: &self.name,
            kind: &self.kind,
            source: &self.source,
            grade: self.grade,
            note: self.note.as_deref(),
            wheel: numbers(&self.values, &WHEEL_FIELDS),
            values: views(&self.values, &self.source, self.grade),
            missing: self.missing(),
        }
    }
}

impl SoilRecord {
    /// The value of that name.
    pub(crate) fn number(&self, name: &str) -> Option<f64> {
        self.values.get(name).map(|value| value.value)
    }

    /// The pressure–sinkage law, if all its parameters are known.
    pub(crate) fn pressure_sinkage(&self) -> Option<PressureSinkage> {
        let number = |name: &str| self.number(name);
        let exponent = SinkageExponent { base: number("n0")?, slip_gain: number("n1").unwrap_or(0.0), skid_gain: number("n2") };
        Some(match self.law.as_str() {
            "bekker" => PressureSinkage::Bekker(Bekker { k_c: number("k_c")?, k_phi: number("k_phi")?, exponent }),
            "direct" => PressureSinkage::Direct(Direct { k_s: number("k_s")?, exponent }),
            "reece" => PressureSinkage::Reece(Reece {
                k_c: number("k_c")?,
                k_phi: number("k_phi")?,
                unit_weight: number("unit_weight_n_m3")?,
                exponent,
            }),
            "diameter" => PressureSinkage::Diameter(Diameter { k: number("k")?, m: number("m")?, exponent }),
            _ => return None,
        })
    }

    /// The shear law, if it is another than Janosi–Hanamoto's.
    pub(crate) fn shear(&self) -> Option<ShearLaw> {
        let record = self.shear.as_ref()?;
        let number = |name: &str| record.values.get(name).map(|value| value.value);
        Some(match record.law.as_str() {
            "wong_residual" => ShearLaw::WongResidual(WongResidual {
                residual_ratio: number("residual_ratio")?,
                peak_displacement: number("peak_displacement_m")?,
            }),
            "wong_peak" => ShearLaw::WongPeak(WongPeak { peak_displacement: number("peak_displacement_m")? }),
            _ => return None,
        })
    }

    /// The contact that was measured with the soil.
    pub(crate) fn contact(&self) -> Option<Contact> {
        let record = self.contact.as_ref()?;
        let number = |name: &str| record.values.get(name).map(|value| value.value);
        let rule = match record.rule.as_str() {
            "midpoint" => PeakRule::Midpoint,
            "half_sinkage" => PeakRule::HalfSinkage,
            "wong_reece" => PeakRule::WongReece { c1: number("c1")?, c2: number("c2")? },
            _ => return None,
        };
        Contact::new(ContactParams { rule, exit_ratio: number("c3").unwrap_or(0.0) }).ok()
    }

    /// Required fields that are not known.
    pub(crate) fn missing(&self) -> Vec<&'static str> {
        let mut missing = absent(&self.values, SOIL_REQUIRED);
        missing.retain(|name| *name != "shear_modulus_m" || self.shear().is_none());
        if self.pressure_sinkage().is_none() {
            missing.push("pressure_sinkage");
        }
        missing
    }

    /// The record as it is shown.
    pub(crate) fn view(&self) -> SoilView<'_> {
        let parameters = |variants: &'static [crate::wire::Variant], name: &str| -> Vec<&'static str> {
            crate::wire::Variant::named(variants, name).map(|variant| variant.fields().collect()).unwrap_or_default()
        };
        let mut values = views(&self.values, &self.source, self.grade);
        if let Some(contact) = &self.contact {
            values.extend(views(&contact.values, &self.source, self.grade));
        }
        if let Some(shear) = &self.shear {
            values.extend(views(&shear.values, &self.source, self.grade));
        }
        SoilView {
            id: &self.id,
            name: &self.name,
            kind: &self.kind,
            source: &self.source,
            grade: self.grade,
            note: self.note.as_deref(),
            soil: SoilBody {
                own: numbers(&self.values, &SOIL_FIELDS),
                pressure_sinkage: TaggedBody {
                    law: Some(&self.law),
                    rule: None,
                    parameters: numbers(&self.values, &parameters(LAWS, &self.law)),
                },
                shear: self.shear.as_ref().map(|shear| TaggedBody {
                    law: Some(&shear.law),
                    rule: None,
                    parameters: numbers(&shear.values, &parameters(SHEAR_LAWS, &shear.law)),
                }),
            },
            contact: self.contact.as_ref().map(|contact| TaggedBody {
                law: None,
                rule: Some(&contact.rule),
                parameters: numbers(&contact.values, &parameters(RULES, &contact.rule)),
            }),
            values,
            missing: self.missing(),
        }
    }
}
