//! Requests and their parts in the contract.

use std::borrow::Cow;
use std::marker::PhantomData;

use terramechanics_reading::{Components, Object, Tagged};
use utoipa::openapi::path::{Parameter, ParameterIn};
use utoipa::openapi::{RefOr, Schema};
use utoipa::{IntoParams, PartialSchema, ToSchema};

use super::Request;

/// What is declared of a type that is read from requests.
pub(crate) trait Described {
    const SHAPE: Shape;
}

/// The form of an object.
pub(crate) enum Shape {
    Object(&'static Object),
    Tagged(&'static Tagged),
}

impl<R: Request> Described for R {
    const SHAPE: Shape = Shape::Object(R::OBJECT);
}

/// Stands in the contract for what a client writes to have a `T`.
pub(crate) struct Documented<T>(PhantomData<T>);

impl<T: Described> PartialSchema for Documented<T> {
    fn schema() -> RefOr<Schema> {
        match T::SHAPE {
            Shape::Object(object) => object.schema(),
            Shape::Tagged(tagged) => tagged.schema(),
        }
    }
}

impl<T: Described> ToSchema for Documented<T> {
    fn name() -> Cow<'static, str> {
        Cow::Borrowed(match T::SHAPE {
            Shape::Object(object) => object.name,
            Shape::Tagged(tagged) => tagged.name,
        })
    }

    fn schemas(found: &mut Components) {
        match T::SHAPE {
            Shape::Object(object) => object.components(found),
            Shape::Tagged(tagged) => tagged.components(found),
        }
    }
}

impl<R: Request> IntoParams for Documented<R> {
    fn into_params(_: impl Fn() -> Option<ParameterIn>) -> Vec<Parameter> {
        let mut found = Vec::new();
        R::OBJECT.parameters("", &mut found);
        found
    }
}
