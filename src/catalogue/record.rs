//! Records of the catalogue as they are kept, and what the model makes of them.

use std::collections::BTreeMap;

use serde::{Deserialize, Serialize};
use terramechanics::{
    AngleRatio, Contact, ContactParams, ExitRule, JanosiHanamoto, Parameter, Parametrised, PeakRule, PressureSinkage, ShearLaw,
    Soil, WheelParams,
};
use utoipa::ToSchema;

/// How well a value is founded, best first.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Deserialize, Serialize, ToSchema)]
#[serde(rename_all = "lowercase")]
pub(crate) enum Grade {
    /// Read in the source itself.
    Primary,
    /// Quoted by others; the source itself was not read.
    Secondary,
    /// Assigned from a guideline or from another soil or wheel, tuned by hand, or a choice of simulation code.
    Proxy,
}

impl Grade {
    /// Its name on the wire.
    pub(super) fn name(self) -> &'static str {
        match self {
            Self::Primary => "primary",
            Self::Secondary => "secondary",
            Self::Proxy => "proxy",
        }
    }
}

/// One value of a record.
#[derive(Debug, Clone, Deserialize)]
#[serde(deny_unknown_fields)]
pub(crate) struct Value {
    /// In SI units.
    pub(crate) value: f64,
    /// As published, with its unit.
    pub(crate) published: String,
    /// The ends of the range that was published, in SI units, where it was one.
    pub(super) range: Option<[f64; 2]>,
    pub(super) source: Option<String>,
    pub(super) grade: Option<Grade>,
    pub(super) note: Option<String>,
}

/// The values of a record by name.
pub(crate) type Values = BTreeMap<String, Value>;

/// A wheel of the catalogue.
#[derive(Debug, Clone, Deserialize)]
#[serde(deny_unknown_fields)]
pub(crate) struct WheelRecord {
    pub(crate) id: String,
    pub(super) name: String,
    pub(crate) kind: String,
    pub(crate) source: String,
    pub(super) grade: Grade,
    pub(super) note: Option<String>,
    /// Fields that are not known and that the service assumes, though the wheel has or may have something there.
    #[serde(default)]
    pub(super) assumed: Vec<String>,
    pub(crate) values: Values,
}

/// A soil of the catalogue.
#[derive(Debug, Clone, Deserialize)]
#[serde(deny_unknown_fields)]
pub(crate) struct SoilRecord {
    pub(crate) id: String,
    pub(super) name: String,
    pub(crate) kind: String,
    pub(crate) source: String,
    pub(super) grade: Grade,
    pub(super) note: Option<String>,
    /// The pressure–sinkage law to which the values belong, if there are any of one.
    pub(crate) law: Option<String>,
    /// The soil whose law stands in for one of which values were never published.
    pub(super) law_substitute: Option<LawSubstitute>,
    /// Largest slip of the wheel tests to which n1 was fitted, where it is known.
    pub(crate) largest_fitted_slip: Option<f64>,
    pub(crate) values: Values,
    pub(super) shear: Option<ShearRecord>,
    pub(super) contact: Option<ContactRecord>,
}

/// A law that stands in for another.
#[derive(Debug, Clone, Deserialize)]
#[serde(deny_unknown_fields)]
pub(super) struct LawSubstitute {
    /// The soil that has it.
    pub(super) soil: String,
    /// Why that soil.
    pub(super) reason: String,
}

/// A shear law other than Janosi–Hanamoto's.
#[derive(Debug, Clone, Deserialize)]
pub(super) struct ShearRecord {
    pub(super) law: String,
    #[serde(flatten)]
    pub(super) values: Values,
}

/// A measured contact.
#[derive(Debug, Clone, Deserialize)]
pub(super) struct ContactRecord {
    pub(super) rule: String,
    #[serde(flatten)]
    pub(super) values: Values,
}

/// What a soil has besides the values of its laws; the modulus of the shear law that none names is among them.
const SOIL_PARAMETERS: [Parameter; 8] = [
    Soil::COHESION,
    Soil::FRICTION_ANGLE,
    JanosiHanamoto::MODULUS,
    Soil::LATERAL_SHEAR_MODULUS,
    Soil::UNIT_WEIGHT,
    Soil::BULK_DENSITY,
    Soil::GRAVITY,
    Soil::GRANULAR_STIFFNESS,
];
pub(super) const SOIL_FIELDS: [&str; SOIL_PARAMETERS.len()] = names(&SOIL_PARAMETERS);
pub(super) const WHEEL_FIELDS: [&str; WheelParams::PARAMETERS.len()] = names(WheelParams::PARAMETERS);

const fn names<const N: usize>(parameters: &'static [Parameter]) -> [&'static str; N] {
    let mut names = [""; N];
    let mut i = 0;
    while i < N {
        names[i] = parameters[i].name;
        i += 1;
    }
    names
}

/// The required parameters that have no value.
fn lacking(values: &Values, parameters: &'static [Parameter]) -> Vec<&'static str> {
    let lacks = |parameter: &&Parameter| parameter.is_required() && !values.contains_key(parameter.name);
    parameters.iter().filter(lacks).map(|parameter| parameter.name).collect()
}

impl WheelRecord {
    /// The value of that name.
    pub(crate) fn number(&self, name: &str) -> Option<f64> {
        self.values.get(name).map(|value| value.value)
    }

    /// Required fields that are not known.
    pub(crate) fn missing(&self) -> Vec<&'static str> {
        lacking(&self.values, WheelParams::PARAMETERS)
    }

    /// Whether a field is not known and assumed, though the wheel has or may have something there.
    pub(crate) fn assumes(&self, name: &str) -> bool {
        self.assumed.iter().any(|assumed| assumed == name)
    }
}

impl SoilRecord {
    /// The value of that name.
    pub(crate) fn number(&self, name: &str) -> Option<f64> {
        self.values.get(name).map(|value| value.value)
    }

    /// The range that was published of the value of that name, where it was one.
    pub(crate) fn range(&self, name: &str) -> Option<[f64; 2]> {
        self.values.get(name).and_then(|value| value.range)
    }

    /// Gravity where the soil lies or was tested (m/s²), if that is known.
    pub(crate) fn gravity(&self) -> Option<f64> {
        self.number(Soil::GRAVITY.name)
    }

    /// The record with the gravity of the body where soils of its kind lie or were tested, unless it has its own. A soil of paper or
    /// of simulations lies nowhere.
    pub(super) fn with_gravity(mut self) -> Self {
        let body = match self.kind.as_str() {
            "lunar" => "moon",
            "martian" => "mars",
            "lunar simulant" | "martian simulant" | "test-bed sand" | "terrestrial" | "snow" => "earth",
            _ => return self,
        };
        if let Some(known) = super::gravity().iter().find(|known| known.id == body) {
            let value = || Value {
                value: known.acceleration_m_s2,
                published: format!("{} m/s2", known.acceleration_m_s2),
                range: None,
                source: Some(known.source.clone()),
                grade: None,
                note: Some("That of the body where soils of this kind lie or are tested; their source does not state it.".into()),
            };
            self.values.entry(Soil::GRAVITY.name.to_owned()).or_insert_with(value);
        }
        self
    }

    /// The pressure–sinkage law, if all its parameters are known.
    pub(crate) fn pressure_sinkage(&self) -> Option<PressureSinkage> {
        PressureSinkage::named(self.law.as_deref()?)?.from_named(|name| self.number(name)).ok()
    }

    /// The shear law, if it is another than Janosi–Hanamoto's.
    pub(crate) fn shear(&self) -> Option<ShearLaw> {
        let record = self.shear.as_ref()?;
        let number = |name: &str| record.values.get(name).map(|value| value.value);
        ShearLaw::named(&record.law)?.from_named(number).ok()
    }

    /// The contact that was measured with the soil.
    pub(crate) fn contact(&self) -> Option<Contact> {
        let record = self.contact.as_ref()?;
        let number = |name: &str| record.values.get(name).map(|value| value.value);
        let rule = PeakRule::named(&record.rule)?.from_named(number).ok()?;
        let exit = ExitRule::AngleRatio(AngleRatio { c3: number(AngleRatio::C3.name).or(AngleRatio::C3.default())? });
        Contact::new(ContactParams { rule, exit, ..ContactParams::MIDPOINT }).ok()
    }

    /// Required parameters of the pressure–sinkage law that are not known.
    pub(crate) fn missing_of_law(&self) -> Vec<&'static str> {
        let parameters = self.law.as_deref().and_then(PressureSinkage::named).map_or(&[][..], |law| law.parameters);
        lacking(&self.values, parameters)
    }

    /// Required fields that are not known.
    pub(crate) fn missing(&self) -> Vec<&'static str> {
        let mut missing = lacking(&self.values, &SOIL_PARAMETERS);
        missing.retain(|name| *name != JanosiHanamoto::MODULUS.name || self.shear().is_none());
        if self.pressure_sinkage().is_none() {
            missing.push("pressure_sinkage");
        }
        missing
    }
}
