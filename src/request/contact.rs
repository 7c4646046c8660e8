//! The contact of a request.

use terramechanics::{Contact, ContactParams, PeakRule, WongReece};
use utoipa::openapi::{RefOr, Schema};

use super::variants::{made, numbers_of};
use crate::wire::{Choice, Field, Number, Object, Scope, Spec, Variant, tagged_schema, wire_object};

/// The rules for the angle of maximum stress and their parameters.
pub(crate) const RULES: &[Variant] = &[
    Variant { name: "midpoint", required: &[], optional: &["c3"] },
    Variant { name: "wong_reece", required: &["c1", "c2"], optional: &["c3"] },
    Variant { name: "half_sinkage", required: &[], optional: &["c3"] },
];

fn rule_names() -> Vec<&'static str> {
    Variant::names(RULES)
}

fn rule_schema(doc: &str, fields: &[(&'static str, &dyn Spec)]) -> RefOr<Schema> {
    tagged_schema(doc, fields, "rule", RULES)
}

wire_object! {
    /// Where the stresses are largest and where the contact ends: θm by the rule, θ2 = c3 θ1.
    ContactDto as "Contact" with rule_schema {
        rule: String = Choice { doc: "midpoint: θm = (θ1 + θ2)/2; wong_reece: θm = (c1 + c2 s) θ1; half_sinkage: θm = arccos(1 − z/(2r)).", words: rule_names, default: None },
        c1: f64 = Number::of(&WongReece::C1, "c1 of θm = (c1 + c2 s) θ1 (–)."),
        c2: f64 = Number::of(&WongReece::C2, "c2 of θm = (c1 + c2 s) θ1 (–)."),
        c3: f64 = Number::of(&Contact::EXIT_RATIO, "c3 of θ2 = c3 θ1 (–); negative where the contact reaches behind the lowest point."),
    }
}

impl ContactDto {
    /// The contact with a value for each of `fitted` that its rule takes and it does not have.
    pub(super) fn filled(&self, fitted: &[(&'static str, f64)]) -> Self {
        let mut contact = self.clone();
        if matches!(&contact.rule, Field::Given(rule) if rule == "wong_reece") {
            for &(name, value) in fitted {
                let field = match name {
                    "c1" => &mut contact.c1,
                    "c2" => &mut contact.c2,
                    _ => continue,
                };
                if matches!(field, Field::Absent) {
                    *field = Field::Given(value);
                }
            }
        }
        contact
    }

    /// The contact.
    pub(crate) fn check(&self, place: &Scope<'_>) -> Option<Contact> {
        self.report_oddities(place);
        self.rule().required_word(place);
        let rule = self.rule().looked_up(place, |word| Variant::named(RULES, word));
        let parameters = [self.c1(), self.c2(), self.c3()];
        let values = numbers_of(rule, &parameters, place);
        let [_, _, exit_ratio] = values;
        let rule = made(PeakRule::LAWS, rule?.name, &parameters, &values, place)?;
        let exit_ratio = exit_ratio?;
        Contact::new(ContactParams { rule, exit_ratio }).map_err(|invalid| place.fault(invalid)).ok()
    }
}
