//! What a client may write: fields with their bounds, read without stopping at the first fault.
//!
//! A request object is declared once, with [`wire_object!`]: the fields, their types and their bounds. From that one
//! declaration come the reader, the checks and the JSON schema, so the bounds in the contract are the enforced ones. Reading
//! never fails on the content: what is missing, of a wrong type or unknown is kept and reported together.

mod asked;
mod choice;
mod entry;
mod faults;
mod field;
mod hint;
mod label;
mod list;
mod number;
mod object;
mod query;
mod series;
mod syntax;

pub(crate) use asked::{Asked, AskedSpec};
pub(crate) use choice::{Choice, shortened, unknown_word};
pub(crate) use entry::Entry;
pub(crate) use faults::{FieldFault, Scope};
pub(crate) use field::{Field, Wire, read};
pub(crate) use hint::nearest;
pub(crate) use label::{Label, LabelSpec};
pub(crate) use list::{List, ListSpec};
pub(crate) use number::{Lambda, LambdaSpec, Number, in_millimetres};
pub(crate) use object::{Nested, Object, Oddity, Variant, named_shapes, object_schema, read_name, tagged_schema, wire_object};
pub(crate) use query::Query;
pub(crate) use series::{Each, EachSpec, MOST_NUMBERS, Names, NamesSpec, Pair, PairSpec, Series, SeriesSpec};
pub(crate) use syntax::fault_in_words;

use utoipa::openapi::path::{Parameter, ParameterBuilder, ParameterIn};
use utoipa::openapi::{RefOr, Required, Schema};

/// What is allowed for a field, as a JSON schema.
pub(crate) trait Spec {
    /// The schema, with the field's description.
    fn schema(&self) -> RefOr<Schema>;

    /// Adds the named schemas that it refers to.
    fn schemas(&self, _found: &mut Vec<(String, RefOr<Schema>)>) {}

    /// Adds the query parameters that stand for the field under `name`.
    fn parameters(&self, name: &str, found: &mut Vec<Parameter>) {
        let mut schema = self.schema();
        // Said once, where readers of the document look for it.
        let description = match &mut schema {
            RefOr::T(Schema::Object(object)) => object.description.take(),
            RefOr::T(Schema::OneOf(one_of)) => one_of.description.take(),
            _ => None,
        };
        let parameter = ParameterBuilder::new().name(name).parameter_in(ParameterIn::Query).required(Required::False);
        found.push(parameter.description(description).schema(Some(schema)).build());
    }

    /// The names of the fields of an object; none of anything else.
    fn names_within(&self) -> &'static [&'static str] {
        &[]
    }

    /// Whether a request without the field is refused whatever else it has.
    fn is_required(&self) -> bool {
        false
    }
}
