//! What any contact may have beside the rule of its peak: another exit than by c3, and an interface between rim and soil.

use std::sync::LazyLock;

use terramechanics::{AngleRatio, Contact, ContactParams, ExitRule, Interface, PeakRule, SinkageRatio, WongReece};
use terramechanics_reading::{Base, Chosen, Field, Number, Object, Reader, Tagged, Variant};

use super::laws::{chosen, own_field, variants};
use super::soil::Needs;

const RATIO: Field<Number> = Field { required: true, ..own_field(&SinkageRatio::RATIO) };
const EXIT_OBJECT: Object = Object {
    name: "Exit",
    doc: "Where the contact ends behind the wheel, by the ratio of the sinkage there to that ahead: θ2 = −arccos(1 − η z/r). Lugs carry soil to the rear; 0.9 to 1.2 were published for them.",
    groups: &[&[&RATIO]],
};
pub(crate) const EXIT: Field<&Object> =
    Field::new("exit", "The exit by the ratio of rear to front sinkage, in place of c3.", &EXIT_OBJECT);

const FRICTION_ANGLE: Field<Number> = own_field(&Interface::FRICTION_ANGLE);
const ADHESION: Field<Number> = own_field(&Interface::ADHESION);
const SHEAR_MODULUS: Field<Number> = own_field(&Interface::SHEAR_MODULUS);
const INTERFACE_OBJECT: Object = Object {
    name: "Interface",
    doc: "What shears between a bare rim and the soil, before the soil shears in itself. What is absent is the soil's.",
    groups: &[&[&FRICTION_ANGLE, &ADHESION, &SHEAR_MODULUS]],
};
pub(crate) const INTERFACE: Field<&Object> = Field::new(
    "interface",
    "Strength and shear modulus between a bare rim and the soil, for a wheel without lugs; the soil's unless given.",
    &INTERFACE_OBJECT,
);
pub(super) const C3: Field<Number> = own_field(&AngleRatio::C3);
const C1: Field<Number> = own_field(&WongReece::C1);
const C2: Field<Number> = own_field(&WongReece::C2);

/// The contact of a request: a rule for its peak, and what every contact has.
pub(crate) const FORMS: Tagged = Tagged {
    name: "Contact",
    doc: "Where the stresses are largest and where the contact ends: θm by the rule; θ2 = c3 θ1, or by `exit` in place of c3. What lies between rim and soil stands in `interface`.",
    tag: "rule",
    meaning: "midpoint: θm = (θ1 + θ2)/2; wong_reece: θm = (c1 + c2 s) θ1; half_sinkage: θm = arccos(1 − z/(2r)).",
    suffix: "Contact",
    variants: || {
        static VARIANTS: LazyLock<Vec<Variant>> =
            LazyLock::new(|| variants(PeakRule::LAWS, |rule| rule.parameters.iter().chain([&AngleRatio::C3]).collect()));
        &VARIANTS
    },
    also: &[&EXIT, &INTERFACE],
    without_word: Some(
        "Single values of the contact that the catalogue measured with the soil, in place of its own; the rule and its other values stay. Without such a contact the rule is midpoint, with c3 = 0.",
    ),
};

/// The rule of a contact, and its exit by c3.
fn of_form(Chosen { index, values }: &Chosen) -> Option<ContactParams> {
    let (c3, values) = values.split_last()?;
    let exit = ExitRule::AngleRatio(AngleRatio { c3: (*c3)? });
    Some(ContactParams { rule: chosen(PeakRule::LAWS, *index, values)?, exit, ..ContactParams::MIDPOINT })
}

/// The contact that was sent, if one was; without the circles. What it leaves out is that of the `measured` one, if it
/// names no rule; of the midpoint, where none was measured and nothing belongs to another rule.
pub(crate) fn read(
    object: &Reader<'_>,
    field: &Field<&'static Tagged>,
    measured: Option<&Contact>,
    needs: Needs<'_>,
) -> Option<Option<ContactParams>> {
    let takes_midpoint = object.within(field).is_some_and(|sent| !sent.has(&C1) && !sent.has(&C2));
    let measured = measured.or_else(|| takes_midpoint.then_some(&Contact::MIDPOINT)).map(Contact::params);
    let value = |name: &str| {
        let parameters = measured.into_iter().flat_map(|params| params.rule.parameters().chain(params.exit.parameters()));
        parameters.into_iter().find(|(of, _)| of.name == name).map(|(_, value)| value)
    };
    let base = measured.map(|params| Base { form: params.rule.law().name, value: &value });
    let form = object.chosen(field, base.as_ref(), needs.fitted);
    let Some(beside) = object.within(field) else { return form.map(|_| None) };
    let (exit, interface) = (exit(&beside), interface(&beside));
    let params = of_form(&form??)?;
    Some(Some(ContactParams { exit: exit?.unwrap_or(params.exit), interface: interface?, ..params }))
}

/// The exit in place of that by c3; none where that holds.
fn exit(contact: &Reader<'_>) -> Option<Option<ExitRule>> {
    let Some(exit) = contact.optional(&EXIT)? else { return Some(None) };
    let ratio = exit.required(&RATIO);
    if contact.has(&C3) {
        contact.place_of(&EXIT).fault(format_args!("takes the place of `{}`; give one of them", C3.name));
        return None;
    }
    Some(Some(ExitRule::SinkageRatio(SinkageRatio { ratio: ratio? })))
}

fn interface(contact: &Reader<'_>) -> Option<Option<Interface>> {
    let Some(interface) = contact.optional(&INTERFACE)? else { return Some(None) };
    let friction_angle = interface.optional(&FRICTION_ANGLE);
    let adhesion = interface.optional(&ADHESION);
    let shear_modulus = interface.optional(&SHEAR_MODULUS);
    Some(Some(Interface { friction_angle: friction_angle?, adhesion: adhesion?, shear_modulus: shear_modulus? }))
}

/// The contact, whose faults are those of its field.
pub(crate) fn checked(object: &Reader<'_>, field: &Field<&'static Tagged>, params: ContactParams) -> Option<Contact> {
    Contact::new(params).map_err(|invalid| object.place_of(field).fault(invalid)).ok()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_rule_of_the_model_can_be_chosen() {
        for (index, variant) in (FORMS.variants)().iter().enumerate() {
            let values = variant.fields.iter().map(|field| field.kind.default_value().or(Some(0.5))).collect();
            assert_eq!(of_form(&Chosen { index, values }).map(|params| params.rule.law().name), Some(variant.name));
        }
    }
}
