//! Numbers as fields of a request.

use utoipa::openapi::path::Parameter;
use utoipa::openapi::{RefOr, Schema};

use crate::fault::Scope;
use crate::field::{Kind, parameter, wrong_type};
use crate::node::Node;
use crate::number::Number;
use crate::path::{Astray, Way};
use crate::reader::Defaulting;

impl Kind for Number {
    type Value<'a> = f64;

    fn read<'a>(&self, node: &'a Node<'a>, place: Scope<'a>) -> Option<f64> {
        match node {
            Node::Number(value) => self.check(&place, *value),
            other => wrong_type(&place, "a number", other),
        }
    }

    fn schema(&self, meaning: &str) -> RefOr<Schema> {
        self.described(Some(&self.told(meaning))).into()
    }

    fn parameters(&self, name: &str, meaning: &str, _: bool, found: &mut Vec<Parameter>) {
        found.push(parameter(name, &self.told(meaning), self.schema(meaning)));
    }

    fn number_at(&self, way: Way<'_>) -> Result<Number, Astray> {
        match way.step() {
            None => Ok(*self),
            Some(_) => Err(way.astray("a number")),
        }
    }
}

impl Defaulting for Number {
    fn default(&self) -> Option<f64> {
        self.default
    }
}
