//! Alternatives to a request: laws that take the place of its own.

use terramechanics::{Braking, NormalStressRadius, Operation};
use terramechanics_reading::{Faults, Field, FieldFault, Label, Object, Objects, Reader, Scope, Tagged, Word};

use crate::request::circles::VARIED_CIRCLES;
use crate::request::method::{BRAKING_FIELD, BRAKING_LAWS, NORMAL_STRESS_RADIUS};
use crate::request::sinkage::SLIP_SINKAGE;
use crate::request::soil::{VARIED_PRESSURE_SINKAGE, VARIED_SHEAR};
use crate::request::system::CONTACT;
use crate::request::unused::Unused;

const NAME: Field<Label> =
    Field::required("name", "What the variant is called in the answer; no other has the same name.", Label);
const VARIED_CONTACT: Field<&Tagged> = Field { meaning: "The contact.", ..CONTACT };
const VARIED_SLIP_SINKAGE: Field<&Tagged> =
    Field { meaning: "Slip–sinkage law; the request has a static_sinkage_m.", ..SLIP_SINKAGE };
const VARIED_BRAKING: Field<Word<Braking>> =
    Field::new(BRAKING_FIELD.name, "Law for a braking wheel; two_zone with the quadrature as the only method.", BRAKING_LAWS);
const VARIED_RADIUS: Field<Word<NormalStressRadius>> =
    Field { kind: Word::new(NORMAL_STRESS_RADIUS.kind.words), ..NORMAL_STRESS_RADIUS };

const VARIANT: Object = Object {
    name: "CompareVariant",
    doc: "The request with other laws: what stands here takes the place of the request's own.",
    groups: &[
        &[&NAME, &VARIED_SHEAR, &VARIED_PRESSURE_SINKAGE, &VARIED_CONTACT, &VARIED_SLIP_SINKAGE, &VARIED_BRAKING, &VARIED_RADIUS],
        VARIED_CIRCLES,
    ],
};
pub(super) const VARIANTS: Field<Objects> = Field::new(
    "variants",
    "Alternatives to the request as it stands, each with a series by every method.",
    Objects { object: &VARIANT, fewest: 0, most: 8 },
);

/// The name of a variant, if none of the earlier ones has it.
pub(super) fn name(variant: &Reader<'_>, earlier: &[String]) -> Option<String> {
    let name = variant.required(&NAME)?;
    if earlier.iter().any(|earlier| earlier == name) {
        variant.place_of(&NAME).fault("is the name of an earlier variant");
        return None;
    }
    Some(name.to_owned())
}

/// The operations of `request` with what the variant has in place of its own. `faults` are those of the request as it stands, which
/// are not reported again.
pub(super) fn operations(
    request: &Reader<'_>,
    (variant, index): (&Reader<'_>, usize),
    faults: &[FieldFault],
) -> Option<(Vec<Operation>, Unused)> {
    let found = Faults::apart(request.place());
    let root = Scope::root(&found);
    let list = root.field(VARIANTS.name).item(index);
    let own = format!("{}/", list.pointer());
    let operations = {
        let varying = variant.at(list);
        super::operations(&request.at(root).overlaid(&varying), Some(&varying))
    };
    request.place().assume_all(found.assumptions().unwrap_or_default());
    for fault in found.into_list() {
        if fault.pointer.starts_with(&own) {
            request.place().pass_on(fault);
        } else if !faults.contains(&fault) {
            let FieldFault { pointer, detail, .. } = fault;
            variant.place().fault(format_args!("with this variant, {pointer} {detail}"));
        }
    }
    operations
}
