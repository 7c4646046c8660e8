//! Objects whose fields depend on a word: the laws of a family, each with its parameters.

use std::borrow::Cow;

use utoipa::openapi::path::Parameter;
use utoipa::openapi::schema::{AdditionalProperties, Discriminator, ObjectBuilder, OneOfBuilder};
use utoipa::openapi::{RefOr, Schema};

use crate::content::Content;
use crate::fault::Scope;
use crate::fault::unknown_word;
use crate::field::{Components, Field, Group, Kind, component_name, parameter, wrong_type};
use crate::node::{Fields, Node, is_same};
use crate::number::Number;
use crate::object::{Unknown, parameters_within, reference, report_oddities};
use crate::reader::Reader;
use crate::word::words;

/// An object with one form for each word of its tag.
#[derive(Clone, Copy)]
pub struct Tagged {
    /// Its name in the contract.
    pub name: &'static str,
    /// What it is.
    pub doc: &'static str,
    /// The field with the word.
    pub tag: &'static str,
    /// What that field says.
    pub meaning: &'static str,
    /// The end of the names of its forms in the contract, as `Law` in `BekkerLaw`.
    pub suffix: &'static str,
    /// The forms.
    pub variants: fn() -> &'static [Variant],
    /// Fields that any form may have beside its parameters; they are read by [`Reader::within`].
    pub also: Group,
}

impl std::fmt::Debug for Tagged {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        f.debug_struct("Tagged").field("name", &self.name).finish_non_exhaustive()
    }
}

/// One form of a tagged object.
#[derive(Debug, Clone)]
pub struct Variant {
    /// The word of the tag.
    pub name: &'static str,
    /// What it is.
    pub doc: &'static str,
    /// Its parameters.
    pub fields: Cow<'static, [Field<Number>]>,
}

/// A form that was chosen, with its parameters.
#[derive(Debug, Clone, PartialEq)]
pub struct Chosen {
    /// Its place among the variants.
    pub index: usize,
    /// The values of its fields, in their order; none for one that may be absent and is.
    pub values: Vec<Option<f64>>,
}

/// A parameter that one or more forms have.
struct Shared {
    name: &'static str,
    meaning: String,
    number: Number,
}

impl Tagged {
    /// The words of the tag.
    fn names(&self) -> Vec<&'static str> {
        (self.variants)().iter().map(|variant| variant.name).collect()
    }

    /// What is declared under a name in any of the forms.
    pub(crate) fn content_of(&self, name: &str) -> Option<Content> {
        if name == self.tag {
            return Some(Content::Other("a word"));
        }
        let parameter = self.shared().into_iter().find(|shared| shared.name == name).map(|shared| Content::Number(shared.number));
        parameter.or_else(|| self.also.iter().find(|field| field.name() == name).map(|field| field.content()))
    }

    /// The tag and the parameters of all forms, each once.
    pub(crate) fn all_names(&self) -> Vec<&'static str> {
        let also = self.also.iter().map(|field| field.name());
        std::iter::once(self.tag).chain(self.shared().into_iter().map(|shared| shared.name)).chain(also).collect()
    }

    /// The parameters of all forms, each once, with the meanings and bounds of all that have it.
    fn shared(&self) -> Vec<Shared> {
        let mut found: Vec<Shared> = Vec::new();
        for variant in (self.variants)() {
            for Field { name, meaning, kind, .. } in variant.fields.iter() {
                let meaning = kind.told(meaning);
                match found.iter_mut().find(|known| known.name == *name) {
                    None => found.push(Shared { name, meaning: meaning.into_owned(), number: *kind }),
                    Some(known) => {
                        if !known.meaning.contains(&*meaning) {
                            known.meaning.push_str(&format!(" In `{}`: {meaning}", variant.name));
                        }
                        known.number = known.number.or_as(*kind);
                    }
                }
            }
        }
        found
    }

    /// The form that an object chooses, if it does.
    fn form_of(&self, fields: &Fields<'_>) -> Option<&'static Variant> {
        let (_, word) = fields.iter().find(|(name, _)| is_same(name, self.tag))?;
        let word = word.text()?;
        (self.variants)().iter().find(|variant| is_same(variant.name, word))
    }

    fn knows(&self, name: &str) -> Option<&'static str> {
        if name == self.tag {
            return Some(self.tag);
        }
        let mut names = (self.variants)().iter().flat_map(|variant| variant.fields.iter().map(|field| field.name));
        names.find(|known| is_same(known, name)).or_else(|| self.knows_beside(name))
    }

    /// The name among those of the fields that any form may have.
    fn knows_beside(&self, name: &str) -> Option<&'static str> {
        self.also.iter().map(|field| field.name()).find(|known| is_same(known, name))
    }

    /// Reads the object; where a parameter is absent `otherwise` may have it, by its name.
    pub(crate) fn read_with(&self, node: &Node<'_>, place: Scope<'_>, otherwise: &dyn Fn(&str) -> Option<f64>) -> Option<Chosen> {
        let Node::Object(fields) = node else { return wrong_type(&place, "an object", node) };
        let hint = |name: &str| {
            let within: Vec<_> = self.also.iter().map(|field| (field.name(), field.names_within())).collect();
            place.hints().unknown_field(name, &self.all_names(), &within)
        };
        let reader = Reader::new(fields, place);
        // Most names are those of the form that is chosen.
        let own: &[Field<Number>] = self.form_of(fields).map_or(&[], |variant| &variant.fields);
        let mut is_foreign = false;
        let known = |name: &str| match own.iter().find(|field| is_same(field.name, name)) {
            Some(field) => Some(field.name),
            None => {
                is_foreign |= name != self.tag && self.knows_beside(name).is_none();
                self.knows(name)
            }
        };
        report_oddities(fields, &place, Unknown::Refused, known, hint);
        let tag = Field::required(self.tag, self.meaning, Tag(self));
        let Some(index) = reader.required(&tag) else {
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
            let value = value(&reader, field, otherwise);
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

    /// The schema of one form.
    fn form(&self, variant: &Variant) -> RefOr<Schema> {
        let mut object = ObjectBuilder::new()
            .description(Some(variant.doc))
            .additional_properties(Some(AdditionalProperties::FreeForm(false)))
            .property(self.tag, words(vec![variant.name]))
            .required(self.tag);
        for field in variant.fields.iter() {
            object = object.property(field.name, field.kind.schema(field.meaning));
            if field.required {
                object = object.required(field.name);
            }
        }
        for field in self.also {
            object = object.property(field.name(), field.schema());
        }
        object.into()
    }

    /// The name of a form in the contract.
    fn form_name(&self, variant: &Variant) -> String {
        component_name(variant.name.split('_')) + self.suffix
    }

    /// Its schema: one of its forms, told apart by the tag.
    #[must_use]
    pub fn schema(&self) -> RefOr<Schema> {
        let mut any = OneOfBuilder::new().description(Some(self.doc));
        let mut mapping = Vec::new();
        for variant in (self.variants)() {
            let name = self.form_name(variant);
            any = any.item(reference(&name, ""));
            mapping.push((variant.name, format!("#/components/schemas/{name}")));
        }
        any.discriminator(Some(Discriminator::with_mapping(self.tag, mapping))).into()
    }

    /// Adds the named schemas of its forms.
    pub fn components(&self, found: &mut Components) {
        found.extend((self.variants)().iter().map(|variant| (self.form_name(variant), self.form(variant))));
        self.also.iter().for_each(|field| field.components(found));
    }
}

/// A parameter of the chosen form; no answer at all where it is wrong or lacking.
fn value(reader: &Reader<'_>, field: &Field<Number>, otherwise: &dyn Fn(&str) -> Option<f64>) -> Option<Option<f64>> {
    match reader.optional(field)?.or_else(|| otherwise(field.name)).or(field.kind.default_value()) {
        None if field.required => reader.required(field).map(Some),
        value => Some(value),
    }
}

/// The word that tells the form.
struct Tag<'t>(&'t Tagged);

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

    fn content(&self) -> Content {
        Content::Other("a word")
    }
}

impl Kind for &'static Tagged {
    type Value<'a> = Chosen;

    fn read<'a>(&self, node: &'a Node<'a>, place: Scope<'a>) -> Option<Chosen> {
        self.read_with(node, place, &|_| None)
    }

    fn schema(&self, meaning: &str) -> RefOr<Schema> {
        reference(self.name, meaning)
    }

    fn components(&self, found: &mut Components) {
        found.push((self.name.to_owned(), Tagged::schema(self)));
        Tagged::components(self, found);
    }

    fn parameters(&self, name: &str, _: &str, required: bool, found: &mut Vec<Parameter>) {
        parameters_within(name, required, found, |around, found| {
            found.push(parameter(&format!("{around}{}", self.tag), self.meaning, Tag(self).schema(self.meaning)));
            for Shared { name, meaning, number } in self.shared() {
                found.push(parameter(&format!("{around}{name}"), &meaning, number.schema(&meaning)));
            }
            self.also.iter().for_each(|field| field.parameters(around, found));
        });
    }

    fn names_within(&self) -> Vec<&'static str> {
        self.all_names()
    }

    fn content(&self) -> Content {
        Content::Tagged(self)
    }
}

impl Reader<'_> {
    /// The chosen form of a tagged object, if it was sent; where a parameter is absent `otherwise` may have it, by its name.
    #[must_use]
    pub fn chosen(&self, field: &Field<&'static Tagged>, otherwise: &dyn Fn(&str) -> Option<f64>) -> Option<Option<Chosen>> {
        match self.raw(field) {
            Some((node, place)) => field.kind.read_with(node, place, otherwise).map(Some),
            None => Some(None),
        }
    }

    /// The tagged object that was sent, for the fields that any of its forms may have; its names are checked where it is read.
    #[must_use]
    pub fn within<'r>(&'r self, field: &Field<&'static Tagged>) -> Option<Reader<'r>> {
        match self.raw(field)? {
            (Node::Object(fields), place) => Some(Reader::new(fields, place)),
            _ => None,
        }
    }
}
