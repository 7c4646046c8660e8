//! Objects with named fields, declared once for reading, checking and the contract.

use std::fmt;
use std::marker::PhantomData;

use serde::de::{DeserializeSeed, Deserializer, MapAccess, Visitor};
use utoipa::ToSchema;
use utoipa::openapi::path::Parameter;
use utoipa::openapi::schema::{AdditionalProperties, ObjectBuilder, OneOfBuilder, Ref, Type};
use utoipa::openapi::{RefOr, Schema};

use super::choice::shortened;
use super::hint::unknown_field;
use super::{Scope, Spec};

/// A field name that does not belong where it stands.
#[derive(Debug, Clone)]
pub(crate) enum Oddity {
    /// No such field.
    Unknown(String),
    /// A field that was there already.
    Repeated(&'static str),
}

/// Oddities kept of one object; a body full of unknown names is refused as well by the first few.
const MOST_ODDITIES: usize = 20;

/// A request object.
pub(crate) trait Object {
    /// The names of its fields.
    const NAMES: &'static [&'static str];

    /// Adds the query parameters that stand for its fields, under the name of the object with a dot, or none.
    fn parameters(around: &str, found: &mut Vec<Parameter>);

    /// The fields that are objects, with the names of theirs.
    fn names_within() -> Vec<(&'static str, &'static [&'static str])>;

    /// Names that do not belong.
    fn oddities(&self) -> &[Oddity];

    /// Keeps an oddity, if there are not too many already.
    fn keep(oddities: &mut Vec<Oddity>, oddity: Oddity) {
        if oddities.len() < MOST_ODDITIES {
            oddities.push(oddity);
        }
    }

    /// Reports the names that do not belong.
    fn report_oddities(&self, place: &Scope<'_>) {
        for oddity in self.oddities() {
            match oddity {
                Oddity::Repeated(name) => place.field(name).fault("is given more than once"),
                Oddity::Unknown(name) => {
                    let hint = unknown_field(name, Self::NAMES, &Self::names_within());
                    place.fault_of(&shortened(name), format_args!("unknown field; {hint}"));
                }
            }
        }
    }
}

/// A field that is itself an object.
#[derive(Debug)]
pub(crate) struct Nested<T> {
    doc: &'static str,
    required: bool,
    object: PhantomData<fn() -> T>,
}

impl<T> Nested<T> {
    /// An object that may be left out.
    pub(crate) const fn optional(doc: &'static str) -> Self {
        Self { doc, required: false, object: PhantomData }
    }

    /// An object that has to be there.
    pub(crate) const fn required(doc: &'static str) -> Self {
        Self { doc, required: true, object: PhantomData }
    }
}

impl<T: ToSchema + Object> Spec for Nested<T> {
    fn schema(&self) -> RefOr<Schema> {
        let mut reference = Ref::from_schema_name(T::name());
        reference.description = self.doc.to_owned();
        RefOr::Ref(reference)
    }

    fn schemas(&self, found: &mut Vec<(String, RefOr<Schema>)>) {
        found.push((T::name().into_owned(), T::schema()));
        T::schemas(found);
    }

    fn parameters(&self, name: &str, found: &mut Vec<Parameter>) {
        let outside = found.len();
        T::parameters(&format!("{name}."), found);
        if !self.required {
            found[outside..].iter_mut().for_each(|parameter| default_in_words(parameter, name));
        }
    }

    fn names_within(&self) -> &'static [&'static str] {
        T::NAMES
    }

    fn is_required(&self) -> bool {
        self.required
    }
}

/// Says in words what holds for a field once the object `around` is there. As the default of a parameter it would be wrong:
/// a client that sends it has named the object, and is then asked for the rest of it.
fn default_in_words(parameter: &mut Parameter, around: &str) {
    let default = match &mut parameter.schema {
        Some(RefOr::T(Schema::Object(object))) => object.default.take(),
        Some(RefOr::T(Schema::OneOf(one_of))) => one_of.default.take(),
        _ => None,
    };
    if let (Some(default), Some(description)) = (default, &mut parameter.description) {
        description.push_str(&format!(" With the rest of `{around}`, {default} unless given."));
    }
}

/// The schema of an object that refuses unknown fields.
pub(crate) fn object_schema(doc: &str, fields: &[(&'static str, &dyn Spec)]) -> RefOr<Schema> {
    let mut object =
        ObjectBuilder::new().description(Some(doc)).additional_properties(Some(AdditionalProperties::FreeForm(false)));
    for (name, spec) in fields {
        object = object.property(*name, spec.schema());
        if spec.is_required() {
            object = object.required(*name);
        }
    }
    object.into()
}

/// One variant of an object that a tag distinguishes: the tag's value and the fields that go with it.
pub(crate) struct Variant {
    pub(crate) name: &'static str,
    pub(crate) required: &'static [&'static str],
    pub(crate) optional: &'static [&'static str],
}

impl Variant {
    /// The variant of that name.
    pub(crate) fn named(variants: &'static [Self], name: &str) -> Option<&'static Self> {
        variants.iter().find(|variant| variant.name == name)
    }

    /// The names of all variants.
    pub(crate) fn names(variants: &'static [Self]) -> Vec<&'static str> {
        variants.iter().map(|variant| variant.name).collect()
    }

    /// The fields of the variant.
    pub(crate) fn fields(&self) -> impl Iterator<Item = &'static str> {
        self.required.iter().chain(self.optional).copied()
    }
}

/// The schema of an object with one shape per value of its `tag`, each of which refuses the fields of the others.
pub(crate) fn tagged_schema(
    doc: &str,
    fields: &[(&'static str, &dyn Spec)],
    tag: &'static str,
    variants: &[Variant],
) -> RefOr<Schema> {
    let mut any = OneOfBuilder::new().description(Some(doc));
    for variant in variants {
        let name = ObjectBuilder::new().schema_type(Type::String).enum_values(Some([variant.name]));
        let mut object = ObjectBuilder::new()
            .title(Some(variant.name))
            .additional_properties(Some(AdditionalProperties::FreeForm(false)))
            .property(tag, name)
            .required(tag);
        for (field, spec) in fields.iter().filter(|(field, _)| variant.fields().any(|name| name == *field)) {
            object = object.property(*field, spec.schema());
            if variant.required.contains(field) {
                object = object.required(*field);
            }
        }
        any = any.item(object);
    }
    any.into()
}

/// Puts the name of an object before the titles of its shapes, so that no two shapes have the same. Generated clients name a
/// shape by its title; without one, by its place in the list.
pub(crate) fn named_shapes(name: &str, mut schema: RefOr<Schema>) -> RefOr<Schema> {
    if let RefOr::T(Schema::OneOf(any)) = &mut schema {
        for shape in &mut any.items {
            if let RefOr::T(Schema::Object(utoipa::openapi::Object { title: Some(title), .. })) = shape {
                title.insert_str(0, &format!("{name} "));
            }
        }
    }
    schema
}

/// The next name of a map: its index among `known`, or the name itself.
pub(crate) fn read_name<'de, A: MapAccess<'de>>(
    map: &mut A,
    known: &'static [&'static str],
) -> Result<Option<Result<usize, String>>, A::Error> {
    map.next_key_seed(NameSeed(known))
}

struct NameSeed(&'static [&'static str]);

impl<'de> DeserializeSeed<'de> for NameSeed {
    type Value = Result<usize, String>;

    fn deserialize<D: Deserializer<'de>>(self, deserializer: D) -> Result<Self::Value, D::Error> {
        deserializer.deserialize_identifier(self)
    }
}

impl Visitor<'_> for NameSeed {
    type Value = Result<usize, String>;

    fn expecting(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str("a field name")
    }

    fn visit_str<E>(self, name: &str) -> Result<Self::Value, E> {
        Ok(self.0.iter().position(|known| *known == name).ok_or_else(|| name.to_owned()))
    }
}

/// Declares a request object: `/// doc`, its name and its name in the contract, then its fields with types and specs.
///
/// An object whose schema is not the plain one names the function that builds it after `with`. Each field is read into a [`super::Field`], and the method of its name gives it with its spec as a [`super::Entry`].
macro_rules! wire_object {
    (#[doc = $doc:literal] $object:ident as $title:literal $(with $schema:path)? { $($field:ident: $type:ty = $spec:expr),+ $(,)? }) => {
        #[doc = $doc]
        #[derive(Debug, Clone, Default)]
        pub(crate) struct $object {
            $($field: $crate::wire::Field<$type>,)+
            oddities: Vec<$crate::wire::Oddity>,
        }

        impl $object {
            $(
                #[doc = concat!("The field `", stringify!($field), "`.")]
                pub(crate) fn $field(&self) -> $crate::wire::Entry<'_, $type> {
                    const SPEC: <$type as $crate::wire::Wire>::Spec = $spec;
                    $crate::wire::Entry { name: stringify!($field), field: &self.$field, spec: &SPEC }
                }
            )+
        }

        impl $crate::wire::Object for $object {
            const NAMES: &'static [&'static str] = &[$(stringify!($field)),+];

            fn parameters(around: &str, found: &mut Vec<::utoipa::openapi::path::Parameter>) {
                use $crate::wire::Spec;
                let empty = Self::default();
                $(empty.$field().spec.parameters(&format!("{around}{}", stringify!($field)), found);)+
            }

            fn names_within() -> Vec<(&'static str, &'static [&'static str])> {
                use $crate::wire::Spec;
                let empty = Self::default();
                vec![$((stringify!($field), empty.$field().spec.names_within())),+]
            }

            fn oddities(&self) -> &[$crate::wire::Oddity] {
                &self.oddities
            }
        }

        impl $crate::wire::Wire for $object {
            type Spec = $crate::wire::Nested<$object>;
            const EXPECTED: &'static str = "an object";

            fn object<'de, A: ::serde::de::MapAccess<'de>>(mut map: A) -> Result<Option<Self>, A::Error> {
                use $crate::wire::{Field, Object, Oddity, read_name};
                let mut object = Self::default();
                while let Some(name) = read_name(&mut map, Self::NAMES)? {
                    let index = match name {
                        Ok(index) => index,
                        Err(unknown) => {
                            Self::keep(&mut object.oddities, Oddity::Unknown(unknown));
                            map.next_value::<::serde::de::IgnoredAny>()?;
                            continue;
                        }
                    };
                    let mut at = 0..;
                    $(
                        if at.next() == Some(index) {
                            if !matches!(object.$field, Field::Absent) {
                                Self::keep(&mut object.oddities, Oddity::Repeated(stringify!($field)));
                            }
                            object.$field = map.next_value()?;
                            continue;
                        }
                    )+
                }
                Ok(Some(object))
            }
        }

        impl ::utoipa::IntoParams for $object {
            fn into_params(
                _: impl Fn() -> Option<::utoipa::openapi::path::ParameterIn>,
            ) -> Vec<::utoipa::openapi::path::Parameter> {
                let mut found = Vec::new();
                <Self as $crate::wire::Object>::parameters("", &mut found);
                found
            }
        }

        impl ::utoipa::PartialSchema for $object {
            fn schema() -> ::utoipa::openapi::RefOr<::utoipa::openapi::Schema> {
                type Fields<'a> = &'a [(&'static str, &'a dyn $crate::wire::Spec)];
                type Builder = fn(&str, Fields<'_>) -> ::utoipa::openapi::RefOr<::utoipa::openapi::Schema>;
                let plain: Builder = $crate::wire::object_schema;
                let builder = None$(.or(Some($schema as Builder)))?.unwrap_or(plain);
                let empty = Self::default();
                let schema = builder($doc.trim(), &[$((stringify!($field), empty.$field().spec)),+]);
                $crate::wire::named_shapes($title, schema)
            }
        }

        impl ::utoipa::ToSchema for $object {
            fn name() -> ::std::borrow::Cow<'static, str> {
                $title.into()
            }

            fn schemas(found: &mut Vec<(String, ::utoipa::openapi::RefOr<::utoipa::openapi::Schema>)>) {
                use $crate::wire::Spec;
                let empty = Self::default();
                $(empty.$field().spec.schemas(found);)+
            }
        }
    };
}

pub(crate) use wire_object;
