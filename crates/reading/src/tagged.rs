//! Objects whose fields depend on a word: the laws of a family, each with its parameters.

mod read;

use std::borrow::Cow;

use utoipa::openapi::path::Parameter;
use utoipa::openapi::schema::{AdditionalProperties, Discriminator, ObjectBuilder, OneOfBuilder, Type};
use utoipa::openapi::{RefOr, Schema};

use crate::fault::Scope;
use crate::field::{Components, Field, Group, Kind, component_name, parameter};
use crate::node::{Fields, Node, is_same};
use crate::number::Number;
use crate::object::{parameters_within, reference};
use crate::path::{Astray, Way};
use crate::word::words;
use read::Tag;

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
    /// Fields that any form may have beside its parameters; they are read by [`Reader::within`](crate::Reader::within).
    pub also: Group,
    /// What the object is without the word, where something else can tell its form.
    pub without_word: Option<&'static str>,
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

/// The form that an object has which names none, and what holds for its parameters.
pub struct Base<'b> {
    /// The word of the form.
    pub form: &'b str,
    /// The values of its parameters, by name.
    pub value: &'b dyn Fn(&str) -> Option<f64>,
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

    /// The tag and the parameters of all forms, each once.
    fn all_names(&self) -> Vec<&'static str> {
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

    /// The schema of one form.
    fn form(&self, variant: &Variant) -> RefOr<Schema> {
        let mut object = ObjectBuilder::new()
            .description(Some(variant.doc))
            .additional_properties(Some(AdditionalProperties::FreeForm(false)))
            .property(self.tag, words(vec![variant.name]))
            .required(self.tag);
        for field in variant.fields.iter() {
            object = object.property(field.name, field.kind.schema(field.meaning));
            if field.required && !field.kind.follows {
                object = object.required(field.name);
            }
        }
        for field in self.also {
            object = object.property(field.name(), field.schema());
        }
        object.into()
    }

    /// The schema of an object without a word.
    fn values(&self, doc: &str) -> RefOr<Schema> {
        let object =
            ObjectBuilder::new().description(Some(doc)).additional_properties(Some(AdditionalProperties::FreeForm(false)));
        // Named, so that readers of the schema tell this form from those with a word; else the fields of all are in each.
        let no_word = ObjectBuilder::new().schema_type(Type::Null).description(Some("Absent; with a word it is a whole law."));
        let object = object.property(self.tag, no_word);
        let object = self.shared().into_iter().fold(object, |object, Shared { name, meaning, number }| {
            // What holds where it is absent is not the form's default.
            object.property(name, number.without_default().schema(&meaning))
        });
        self.also.iter().fold(object, |object, field| object.property(field.name(), field.schema())).into()
    }

    /// The name of that schema in the contract.
    fn values_name(&self) -> String {
        format!("{}Values", self.name)
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

impl Kind for &'static Tagged {
    type Value<'a> = Chosen;

    fn read<'a>(&self, node: &'a Node<'a>, place: Scope<'a>) -> Option<Chosen> {
        self.read_alone(node, place)
    }

    fn schema(&self, meaning: &str) -> RefOr<Schema> {
        match self.without_word {
            None => reference(self.name, meaning),
            Some(_) => {
                let forms = OneOfBuilder::new().description(Some(meaning)).item(reference(self.name, ""));
                forms.item(reference(&self.values_name(), "")).into()
            }
        }
    }

    fn components(&self, found: &mut Components) {
        found.push((self.name.to_owned(), Tagged::schema(self)));
        found.extend(self.without_word.map(|doc| (self.values_name(), self.values(doc))));
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

    fn number_at(&self, way: Way<'_>) -> Result<Number, Astray> {
        let Some((name, behind)) = way.step() else {
            return Err(Astray::NoNumber { what: format!("an object; its fields are {}", self.all_names().join(", ")) });
        };
        if let Some(shared) = self.shared().into_iter().find(|shared| shared.name == name) {
            return shared.number.number_at(behind);
        }
        match self.also.iter().find(|field| field.name() == name) {
            Some(field) => field.number_at(behind),
            None if name == self.tag => Err(behind.astray("a word")),
            None => Err(behind.unknown(name, &self.all_names(), &[])),
        }
    }
}
