//! Quantities in the contract: a number or a column, with its unit as `x-unit`.

use std::collections::BTreeMap;

use serde_json::Value;
use utoipa::openapi::extensions::ExtensionsBuilder;
use utoipa::openapi::schema::{ArrayBuilder, ArrayItems, KnownFormat, Object, ObjectBuilder, SchemaFormat, SchemaType, Type};
use utoipa::openapi::{RefOr, Schema};

use super::About;
use super::unit::of_field;

/// A quantity in an object of the contract.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Field {
    pub(crate) about: &'static About,
    /// Whether a value may be null.
    pub(crate) nullable: bool,
    /// When it is there, if not always.
    pub(crate) present: Option<&'static str>,
}

impl Field {
    /// A quantity that always has a value.
    pub(crate) fn always(about: &'static About) -> Self {
        Self { about, nullable: false, present: None }
    }

    /// A quantity that may be null.
    pub(crate) fn or_null(about: &'static About) -> Self {
        Self { nullable: true, ..Self::always(about) }
    }

    fn description(&self) -> String {
        let about = self.about.description();
        match self.present {
            Some(when) => format!("{}; present {when}.", about.trim_end_matches('.')),
            None if about.ends_with('.') => about,
            None => about + ".",
        }
    }

    /// The schema of one value.
    pub(crate) fn number(&self) -> RefOr<Schema> {
        of_number(self.about.unit, self.nullable).description(Some(self.description())).into()
    }

    /// The schema of a list of values.
    pub(crate) fn column(&self) -> RefOr<Schema> {
        let items = if self.about.unit.is_empty() {
            ObjectBuilder::new().schema_type(Type::String)
        } else {
            of_number(self.about.unit, self.nullable)
        };
        ArrayBuilder::new().items(items).description(Some(self.description())).into()
    }
}

/// A number in `unit`.
pub(crate) fn of_number(unit: &str, nullable: bool) -> ObjectBuilder {
    let number = if nullable { SchemaType::from_iter([Type::Number, Type::Null]) } else { Type::Number.into() };
    let told = || ExtensionsBuilder::new().add("x-unit", Value::from(unit)).build();
    let extensions = (unit != About::OF_ANOTHER).then(told);
    ObjectBuilder::new().schema_type(number).format(Some(SchemaFormat::KnownFormat(KnownFormat::Double))).extensions(extensions)
}

/// An object of fields, each written by `schema`.
pub(crate) fn object_of(doc: &str, fields: &[Field], schema: impl Fn(&Field) -> RefOr<Schema>) -> ObjectBuilder {
    with_fields(ObjectBuilder::new().description(Some(doc)), fields, schema)
}

/// The object with further fields.
pub(crate) fn with_fields(object: ObjectBuilder, fields: &[Field], schema: impl Fn(&Field) -> RefOr<Schema>) -> ObjectBuilder {
    fields.iter().fold(object, |object, field| {
        let object = object.property(field.about.name, schema(field));
        if field.present.is_none() { object.required(field.about.name) } else { object }
    })
}

/// Gives each number whose name tells its unit that unit as `x-unit`, unless it has one.
pub(crate) fn add_units(schemas: &mut BTreeMap<String, RefOr<Schema>>) {
    for schema in schemas.values_mut() {
        let objects: Vec<&mut Object> = match schema {
            RefOr::T(Schema::Object(object)) => vec![object],
            RefOr::T(Schema::OneOf(any)) => any.items.iter_mut().filter_map(as_object).collect(),
            _ => Vec::new(),
        };
        for (name, field) in objects.into_iter().flat_map(|object| &mut object.properties) {
            if let (Some(unit), Some(number)) = (of_field(name), number_in(field)) {
                number.extensions.get_or_insert_default().entry("x-unit".to_owned()).or_insert_with(|| unit.into());
            }
        }
    }
}

fn as_object(schema: &mut RefOr<Schema>) -> Option<&mut Object> {
    if let RefOr::T(Schema::Object(object)) = schema { Some(object) } else { None }
}

/// The number that a field is, or has items of.
fn number_in(field: &mut RefOr<Schema>) -> Option<&mut Object> {
    let object = match field {
        RefOr::T(Schema::Array(list)) => match &mut list.items {
            ArrayItems::RefOrSchema(items) => as_object(items)?,
            ArrayItems::False => return None,
        },
        field => as_object(field)?,
    };
    let is_number = |of: &Type| matches!(of, Type::Number | Type::Integer);
    let has_number = match &object.schema_type {
        SchemaType::Type(of) => is_number(of),
        SchemaType::Array(of) => of.iter().any(is_number),
        SchemaType::AnyValue => false,
    };
    has_number.then_some(object)
}
