//! The slip–sinkage law of a request.

use terramechanics::{LinearSlipSinkage, SlipSinkage};
use utoipa::openapi::{RefOr, Schema};

use super::variants::{made, numbers_of};
use crate::wire::{Choice, Number, Object, Scope, Spec, Variant, tagged_schema, wire_object};

/// The slip–sinkage laws and their parameters.
const SLIP_SINKAGE_LAWS: &[Variant] =
    &[Variant { name: "lyasko", required: &[], optional: &[] }, Variant { name: "linear", required: &["gain"], optional: &[] }];

fn slip_sinkage_names() -> Vec<&'static str> {
    Variant::names(SLIP_SINKAGE_LAWS)
}

fn slip_sinkage_schema(doc: &str, fields: &[(&'static str, &dyn Spec)]) -> RefOr<Schema> {
    tagged_schema(doc, fields, "law", SLIP_SINKAGE_LAWS)
}

wire_object! {
    /// How the sinkage follows from the static one: lyasko, z = z0 (1 + s)/(1 − s/2); linear, z = z0 (1 + S s).
    SlipSinkageDto as "SlipSinkage" with slip_sinkage_schema {
        law: String = Choice { doc: "Name of the law.", words: slip_sinkage_names, default: None },
        gain: f64 = Number::of(&LinearSlipSinkage::GAIN, "S of the linear law (–)."),
    }
}

impl SlipSinkageDto {
    pub(super) fn check(&self, place: &Scope<'_>) -> Option<SlipSinkage> {
        self.report_oddities(place);
        self.law().required_word(place);
        let law = self.law().looked_up(place, |word| Variant::named(SLIP_SINKAGE_LAWS, word));
        let parameters = [self.gain()];
        let values = numbers_of(law, &parameters, place);
        made(SlipSinkage::LAWS, law?.name, &parameters, &values, place)
    }
}
