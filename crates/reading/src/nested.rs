//! A request within another, which is read by itself.

use utoipa::openapi::schema::OneOfBuilder;
use utoipa::openapi::{RefOr, Schema};

use crate::fault::Scope;
use crate::field::{Components, Kind, wrong_type};
use crate::node::Node;
use crate::object::Object;

/// One of several requests. Which it is, another field says; so it is kept as it was sent.
#[derive(Debug, Clone, Copy)]
pub struct Nested {
    /// The requests.
    pub requests: &'static [&'static Object],
}

impl Kind for Nested {
    type Value<'a> = &'a Node<'a>;

    fn read<'a>(&self, node: &'a Node<'a>, place: Scope<'a>) -> Option<&'a Node<'a>> {
        match node {
            Node::Object(_) => Some(node),
            other => wrong_type(&place, "an object", other),
        }
    }

    fn schema(&self, meaning: &str) -> RefOr<Schema> {
        let any = OneOfBuilder::new().description(Some(meaning));
        self.requests.iter().fold(any, |any, request| any.item(request.reference(""))).into()
    }

    fn components(&self, found: &mut Components) {
        self.requests.iter().for_each(|request| request.component(found));
    }

    fn what(&self) -> &'static str {
        "a request"
    }
}
