//! Objects whose fields all have defaults: `true` asks for them, in a body and in a query.

use serde::de::MapAccess;
use utoipa::openapi::path::Parameter;
use utoipa::openapi::schema::{ObjectBuilder, OneOfBuilder, Type};
use utoipa::openapi::{RefOr, Schema};

use super::{Nested, Spec, Wire};

/// An object, or `true` for one without fields.
#[derive(Debug, Clone, Default)]
pub(crate) struct Asked<T>(pub(crate) T);

/// What stands in the contract for such an object.
#[derive(Debug)]
pub(crate) struct AskedSpec<T> {
    pub(crate) doc: &'static str,
    pub(crate) object: Nested<T>,
}

fn yes(doc: Option<&'static str>) -> ObjectBuilder {
    ObjectBuilder::new().schema_type(Type::Boolean).enum_values(Some([true])).description(doc)
}

impl<T> Spec for AskedSpec<T>
where
    Nested<T>: Spec,
{
    fn schema(&self) -> RefOr<Schema> {
        OneOfBuilder::new().description(Some(self.doc)).item(self.object.schema()).item(yes(None)).into()
    }

    fn schemas(&self, found: &mut Vec<(String, RefOr<Schema>)>) {
        self.object.schemas(found);
    }

    fn parameters(&self, name: &str, found: &mut Vec<Parameter>) {
        Flag(self.doc).parameters(name, found);
        self.object.parameters(name, found);
    }
}

/// The `true` of a query.
struct Flag(&'static str);

impl Spec for Flag {
    fn schema(&self) -> RefOr<Schema> {
        yes(Some(self.0)).into()
    }
}

impl<T: Wire<Spec = Nested<T>> + Default + 'static> Wire for Asked<T>
where
    Nested<T>: Spec,
{
    type Spec = AskedSpec<T>;
    const EXPECTED: &'static str = "an object or true";

    fn flag(value: bool) -> Option<Self> {
        value.then(Self::default)
    }

    fn object<'de, A: MapAccess<'de>>(map: A) -> Result<Option<Self>, A::Error> {
        Ok(T::object(map)?.map(Self))
    }
}
