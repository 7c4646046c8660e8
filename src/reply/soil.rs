//! A soil and a contact as a request spells them out, so that what is answered can be sent back.

use serde::{Serialize, Serializer};
use terramechanics::{
    Bekker, ContactParams, Declared, ExitRule, JanosiHanamoto, Parameter, Parametrised, PressureSinkage, ShearLaw,
    SinkageExponent, Soil, SoilParams,
};

/// An object of a request: its fields by name, in order.
#[derive(Debug)]
pub(crate) struct Spelled(Vec<(&'static str, Member)>);

#[derive(Debug)]
enum Member {
    Number(f64),
    Word(&'static str),
    Object(Spelled),
}

impl Serialize for Spelled {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        serializer.collect_map(self.0.iter().map(|(name, member)| (name, member)))
    }
}

impl Serialize for Member {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        match self {
            Self::Number(value) => value.serialize(serializer),
            Self::Word(word) => word.serialize(serializer),
            Self::Object(object) => object.serialize(serializer),
        }
    }
}

/// A law or a rule under its tag, with the values of its parameters.
fn tagged(tag: &'static str, name: &'static str, values: impl Iterator<Item = (&'static Parameter, f64)>) -> Spelled {
    let values = values.map(|(parameter, value)| (parameter.name, Member::Number(value)));
    Spelled([(tag, Member::Word(name))].into_iter().chain(values).collect())
}

/// A soil, with those of its laws that are known.
pub(crate) fn soil(soil: &SoilParams) -> Spelled {
    // The law that a request has without naming one.
    let (modulus, shear) = match soil.shear {
        Some(ShearLaw::JanosiHanamoto(law)) => (Some(law.modulus), None),
        other => (None, other.map(|law| Member::Object(tagged("law", law.law().name, law.parameters())))),
    };
    let alone = || soil.exponent_alone.as_ref().map(exponent);
    let law = soil.pressure_sinkage.as_ref().map(pressure_sinkage).or_else(alone);
    let members = [
        (Soil::COHESION.name, Some(Member::Number(soil.cohesion))),
        (Soil::FRICTION_ANGLE.name, Some(Member::Number(soil.friction_angle))),
        (JanosiHanamoto::MODULUS.name, modulus.map(Member::Number)),
        ("pressure_sinkage", law.map(Member::Object)),
        ("shear", shear),
        (Soil::LATERAL_SHEAR_MODULUS.name, soil.lateral_shear_modulus.map(Member::Number)),
        (Soil::UNIT_WEIGHT.name, soil.unit_weight.map(Member::Number)),
        (Soil::BULK_DENSITY.name, soil.bulk_density.map(Member::Number)),
        (Soil::GRAVITY.name, soil.gravity.map(Member::Number)),
        (Soil::GRANULAR_STIFFNESS.name, soil.granular_stiffness.map(Member::Number)),
    ];
    Spelled(members.into_iter().filter_map(|(name, member)| Some((name, member?))).collect())
}

fn pressure_sinkage(law: &PressureSinkage) -> Spelled {
    tagged("law", law.law().name, law.parameters())
}

/// An exponent without a law, as a request has it under a load that is known.
fn exponent(exponent: &SinkageExponent) -> Spelled {
    let values = SinkageExponent::PARAMETERS.iter().zip(exponent.values());
    let member = |(parameter, value): (&'static Parameter, Option<f64>)| Some((parameter.name, Member::Number(value?)));
    Spelled(values.filter_map(member).collect())
}

/// Bekker's law with an exponent that does not change with slip; none that a request would refuse.
pub(crate) fn bekker(k_c: f64, k_phi: f64, n0: f64) -> Option<Spelled> {
    let values = [(&Bekker::K_C, k_c), (&Bekker::K_PHI, k_phi), (&SinkageExponent::BASE, n0)];
    let is_taken = |(of, value): &(&Parameter, f64)| of.requirement.holds(*value) && (of.least..=of.most).contains(value);
    values.iter().all(is_taken).then(|| tagged("law", Bekker::NAME, values.into_iter()))
}

/// A contact.
pub(crate) fn contact(contact: &ContactParams) -> Spelled {
    let numbers = |values: Vec<(&'static Parameter, f64)>| {
        Member::Object(Spelled(values.into_iter().map(|(parameter, value)| (parameter.name, Member::Number(value))).collect()))
    };
    let mut spelled = match contact.exit {
        ExitRule::AngleRatio(_) => {
            tagged("rule", contact.rule.law().name, contact.rule.parameters().chain(contact.exit.parameters()))
        }
        ExitRule::SinkageRatio(_) => {
            let mut rule = tagged("rule", contact.rule.law().name, contact.rule.parameters());
            rule.0.push(("exit", numbers(contact.exit.parameters().collect())));
            rule
        }
    };
    let interface = contact.interface.map(|interface| numbers(interface.parameters().collect()));
    spelled.0.extend(interface.map(|interface| ("interface", interface)));
    spelled
}
