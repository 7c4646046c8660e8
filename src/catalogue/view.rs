//! Records of the catalogue as they are shown.

use std::collections::BTreeMap;

use serde::Serialize;
use terramechanics::{AngleRatio, Law, PeakRule, PressureSinkage, ShearLaw, Soil};
use utoipa::ToSchema;

use super::record::{Grade, SOIL_FIELDS, SoilRecord, Value, Values, WHEEL_FIELDS, WheelRecord};
use super::substitutes::Substitute;

/// One value as it is shown, complete with its source.
#[derive(Debug, Serialize, ToSchema)]
#[schema(as = CatalogueValue)]
pub(crate) struct ValueView<'a> {
    /// In SI units.
    value: f64,
    /// As published, with its unit.
    published: &'a str,
    /// The ends of the range that was published, in SI units, where it was one.
    #[serde(skip_serializing_if = "Option::is_none")]
    #[schema(nullable = false)]
    range: Option<[f64; 2]>,
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
    /// Paper, flight, test, terrestrial.
    kind: &'a str,
    /// Where its values were published, unless a value says otherwise.
    source: &'a str,
    grade: Grade,
    /// What a user should know of it.
    #[serde(skip_serializing_if = "Option::is_none")]
    note: Option<&'a str>,
    /// The wheel as a request would spell it out.
    wheel: BTreeMap<&'a str, f64>,
    /// Load that the wheel carries in service or carried in its tests (N); no part of a request's wheel.
    #[serde(skip_serializing_if = "Option::is_none")]
    nominal_load_n: Option<f64>,
    /// Every value with its source; also some that are no part of a request, such as `lug_count`.
    values: BTreeMap<&'a str, ValueView<'a>>,
    /// Required fields without a published value: a request has to add them, or to allow with `"assume": true` that those under `assumed` are taken.
    missing: Vec<&'static str>,
    /// What stands in for values that were never published. A `lug_height_m` among them is taken in every request that sends none, with a warning: the wheel has or may have lugs of unknown height and is computed as smooth.
    assumed: &'static [Substitute],
}

/// A soil as it is shown.
#[derive(Debug, Serialize, ToSchema)]
#[schema(as = CatalogueSoil)]
pub(crate) struct SoilView<'a> {
    /// Its name as a `preset`.
    #[schema(example = "letter-sand")]
    id: &'a str,
    name: &'a str,
    /// Paper, lunar, martian, lunar simulant, martian simulant, test-bed sand, terrestrial, snow, synthetic.
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
    /// Largest slip of the wheel tests to which n1 was fitted, where it is known.
    #[serde(skip_serializing_if = "Option::is_none")]
    #[schema(nullable = false)]
    largest_fitted_slip: Option<f64>,
    /// Every value with its source.
    values: BTreeMap<&'a str, ValueView<'a>>,
    /// Required fields without a published value: a request has to add them, or to allow with `"assume": true` that those under `assumed` are taken.
    missing: Vec<&'static str>,
    /// What `"assume": true` takes for the missing fields; a missing `pressure_sinkage` is taken as a whole, field by field.
    assumed: Vec<&'static Substitute>,
}

/// Fields of a soil.
#[derive(Debug, Serialize, ToSchema)]
#[schema(as = CatalogueSoilFields)]
struct SoilBody<'a> {
    #[serde(flatten)]
    own: BTreeMap<&'a str, f64>,
    #[serde(skip_serializing_if = "Option::is_none")]
    pressure_sinkage: Option<TaggedBody<'a>>,
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

/// The values of the given names that are there.
fn numbers<'a>(values: &'a Values, names: &[&str]) -> BTreeMap<&'a str, f64> {
    values.iter().filter(|(name, _)| names.contains(&name.as_str())).map(|(name, value)| (name.as_str(), value.value)).collect()
}

fn views<'a>(values: &'a Values, source: &'a str, grade: Grade) -> BTreeMap<&'a str, ValueView<'a>> {
    let view = |value: &'a Value| ValueView {
        value: value.value,
        published: &value.published,
        range: value.range,
        source: value.source.as_deref().unwrap_or(source),
        grade: value.grade.unwrap_or(grade),
        note: value.note.as_deref(),
    };
    values.iter().map(|(name, value)| (name.as_str(), view(value))).collect()
}

/// The names of the parameters of a law.
fn parameters<F>(law: Option<&Law<F>>) -> Vec<&'static str> {
    law.iter().flat_map(|law| law.parameters).map(|parameter| parameter.name).collect()
}

impl WheelRecord {
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
            nominal_load_n: self.values.get("nominal_load_n").map(|value| value.value),
            values: views(&self.values, &self.source, self.grade),
            missing: self.missing(),
            assumed: self.substitutes(),
        }
    }
}

impl SoilRecord {
    /// The record as it is shown.
    pub(crate) fn view(&self) -> SoilView<'_> {
        let missing = self.missing();
        // The density is missing only by the method resistive_force.
        let is_missing = |of: &&Substitute| {
            of.field.split('.').next().is_some_and(|field| missing.contains(&field) || field == Soil::BULK_DENSITY.name)
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
                pressure_sinkage: self.law.as_ref().map(|law| TaggedBody {
                    law: Some(law),
                    rule: None,
                    parameters: numbers(&self.values, &parameters(PressureSinkage::named(law))),
                }),
                shear: self.shear.as_ref().map(|shear| TaggedBody {
                    law: Some(&shear.law),
                    rule: None,
                    parameters: numbers(&shear.values, &parameters(ShearLaw::named(&shear.law))),
                }),
            },
            contact: self.contact.as_ref().map(|contact| TaggedBody {
                law: None,
                rule: Some(&contact.rule),
                parameters: numbers(
                    &contact.values,
                    &[&parameters(PeakRule::named(&contact.rule))[..], &[AngleRatio::C3.name]].concat(),
                ),
            }),
            largest_fitted_slip: self.largest_fitted_slip,
            values,
            assumed: self.substitutes().iter().filter(is_missing).collect(),
            missing,
        }
    }
}
