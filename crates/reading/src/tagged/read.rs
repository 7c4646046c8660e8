//! Reading an object whose fields depend on a word.

use crate::fault::{Scope, unknown_word};
use crate::field::{Field, Kind, wrong_type};
use crate::node::{Fields, Node, is_same};
use crate::number::Number;
use crate::object::{Unknown, report_oddities};
use crate::reader::Reader;
use crate::word::words;
use crate::{Chosen, Tagged, Variant};
use utoipa::openapi::{RefOr, Schema};

use super::{Base, Shared};

impl Tagged {
    /// Reads the object by itself.
    pub(super) fn read_alone(&self, node: &Node<'_>, place: Scope<'_>) -> Option<Chosen> {
        self.read_with(node, place, None, &|_| None)
    }

    /// Reads the object. Without a word it is a form of `base`, where there is one, whose values hold for what is absent; whatever
    /// then is absent still, `otherwise` may have by its name.
    fn read_with(
        &self,
        node: &Node<'_>,
        place: Scope<'_>,
        base: Option<&Base<'_>>,
        otherwise: &dyn Fn(&str) -> Option<f64>,
    ) -> Option<Chosen> {
        let Node::Object(fields) = node else { return wrong_type(&place, "an object", node) };
        let hint = |name: &str| {
            let within: Vec<_> = self.also.iter().map(|field| (field.name(), field.names_within())).collect();
            place.hints().unknown_field(name, &self.all_names(), &within)
        };
        let reader = Reader::new(fields, place);
        let tag = Field::required(self.tag, self.meaning, Tag(self));
        // Beside a preset a word that is null was not sent.
        let base = base.filter(|_| !reader.has(&Field::new(self.tag, self.meaning, Tag(self))));
        let of_base = base.and_then(|base| (self.variants)().iter().position(|variant| variant.name == base.form));
        // Most names are those of the form that is chosen.
        let form = of_base.map_or_else(|| self.form_of(fields), |index| (self.variants)().get(index));
        let own: &[Field<Number>] = form.map_or(&[], |variant| &variant.fields);
        let mut is_foreign = false;
        let known = |name: &str| match own.iter().find(|field| is_same(field.name, name)) {
            Some(field) => Some(field.name),
            None => {
                is_foreign |= name != self.tag && self.knows_beside(name).is_none();
                self.knows(name)
            }
        };
        report_oddities(fields, &place, Unknown::Refused, known, hint);
        let Some(index) = of_base.or_else(|| reader.required(&tag)) else {
            // What was sent is checked by its bounds alone.
            for Shared { name, number, .. } in self.shared() {
                let _ = reader.optional(&Field::new(name, "", number));
            }
            return None;
        };
        let variant = &(self.variants)()[index];
        let mut is_sound = true;
        let mut values = Vec::with_capacity(variant.fields.len());
        for field in variant.fields.iter() {
            let known = |name: &str| base.and_then(|base| (base.value)(name)).or_else(|| otherwise(name));
            let value = value(&reader, field, &known);
            is_sound &= value.is_some();
            values.push(value.flatten());
        }
        is_sound &= !is_foreign || self.report_foreign(fields, &place, variant);
        is_sound.then_some(Chosen { index, values })
    }

    /// Reports the parameters that only other forms have; false where there are any.
    fn report_foreign(&self, fields: &Fields<'_>, place: &Scope<'_>, variant: &Variant) -> bool {
        let is_parameter = |name: &str| variant.fields.iter().any(|field| is_same(field.name, name));
        let is_own = |name: &str| name == self.tag || is_parameter(name) || self.knows_beside(name).is_some();
        let mut only_own = true;
        for (name, _) in fields.iter().filter(|(name, node)| !matches!(node, Node::Null) && !is_own(name)) {
            let also = self.also.iter().map(|field| field.name());
            let takes: Vec<&str> = variant.fields.iter().map(|field| field.name).chain(also).collect();
            let takes = if takes.is_empty() { "no further field".to_owned() } else { takes.join(", ") };
            only_own = false;
            place.fault_of(&crate::shortened(name), format_args!("`{}` has no such field; it takes {takes}", variant.name));
        }
        only_own
    }
}

/// A parameter of the chosen form; no answer at all where it is wrong or lacking.
fn value(reader: &Reader<'_>, field: &Field<Number>, otherwise: &dyn Fn(&str) -> Option<f64>) -> Option<Option<f64>> {
    // What may follow from other fields may be null, as if it were not sent.
    let sent = Field { required: field.required && !field.kind.follows, ..*field };
    match reader.optional(&sent)?.or_else(|| otherwise(field.name)).or(field.kind.default_value()) {
        None if field.required => reader.required(&sent).map(Some),
        value => Some(value),
    }
}

/// The word that tells the form.
pub(super) struct Tag<'t>(pub(super) &'t Tagged);

impl Kind for Tag<'_> {
    type Value<'a> = usize;

    fn read<'a>(&self, node: &'a Node<'a>, place: Scope<'a>) -> Option<usize> {
        let Some(word) = node.text() else { return wrong_type(&place, "a string", node) };
        let found = (self.0.variants)().iter().position(|variant| variant.name == word);
        if found.is_none() {
            unknown_word(&place, word, &self.0.names());
        }
        found
    }

    fn absent(&self, place: &Scope<'_>) {
        place.fault(format_args!("is required: one of {}", self.0.names().join(", ")));
    }

    fn schema(&self, meaning: &str) -> RefOr<Schema> {
        words(self.0.names()).description(Some(meaning)).into()
    }
}

impl Reader<'_> {
    /// The chosen form of a tagged object, if it was sent. Without a word it is a form of `base`, where there is one, whose values
    /// hold for what is absent; whatever then is absent still, `otherwise` may have by its name.
    #[must_use]
    pub fn chosen(
        &self,
        field: &Field<&'static Tagged>,
        base: Option<&Base<'_>>,
        otherwise: &dyn Fn(&str) -> Option<f64>,
    ) -> Option<Option<Chosen>> {
        match self.raw(field) {
            Some((node, place)) => field.kind.read_with(node, place, base, otherwise).map(Some),
            None => Some(None),
        }
    }

    /// Whether a tagged object was sent with the word of its form.
    #[must_use]
    pub fn names_form(&self, field: &Field<&'static Tagged>) -> bool {
        self.within(field).is_some_and(|object| object.has(&Field::new(field.kind.tag, "", Tag(field.kind))))
    }

    /// The object that was sent, for the fields that it may have, of a tagged one those of any form; its names are checked where it is
    /// read.
    #[must_use]
    pub fn within<'r, K>(&'r self, field: &Field<K>) -> Option<Reader<'r>> {
        match self.raw(field)? {
            (Node::Object(fields), place) => Some(Reader::new(fields, place)),
            _ => None,
        }
    }
}
