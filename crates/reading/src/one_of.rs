//! Fields that may hold values of several types, which a reader tells apart by their type alone.

use utoipa::openapi::path::Parameter;
use utoipa::openapi::schema::{ObjectBuilder, OneOfBuilder, Type};
use utoipa::openapi::{RefOr, Schema};

use crate::fault::Scope;
use crate::field::{Components, Kind, parameter, wrong_type};
use crate::list::Numbers;
use crate::node::Node;
use crate::number::Number;
use crate::object::{Object, parameters_within};
use crate::path::{Astray, Way};
use crate::reader::Reader;
use crate::word::words;

/// One of several types.
#[derive(Debug, Clone, Copy)]
pub struct OneOf {
    /// The types in words, for messages.
    pub expected: &'static str,
    /// The types, all different.
    pub of: &'static [Alternative],
    /// What holds where the field is left out, for the contract.
    pub default: Option<f64>,
}

/// One of the types of a field.
#[derive(Debug, Clone, Copy)]
pub enum Alternative {
    /// A number.
    Number(Number),
    /// A word, and what it means.
    Word(&'static str, &'static str),
    /// A list of numbers.
    Numbers(Numbers),
    /// An object, and what it means.
    Object(&'static Object, &'static str),
    /// An object whose fields may all be absent, and what it means; `true` asks for it without any.
    Asked(&'static Object, &'static str),
}

impl Alternative {
    pub(crate) fn number(&self) -> Option<Number> {
        if let Self::Number(number) = self { Some(*number) } else { None }
    }
}

/// What a field of several types holds.
#[derive(Clone, Copy)]
pub enum Either<'a> {
    /// A number within the bounds.
    Number(f64),
    /// The word.
    Word,
    /// Numbers within the bounds.
    Numbers(&'a [f64]),
    /// An object.
    Object(Reader<'a>),
}

fn yes(meaning: Option<&str>) -> ObjectBuilder {
    ObjectBuilder::new().schema_type(Type::Boolean).enum_values(Some([true])).description(meaning)
}

impl OneOf {
    /// One of these, in words `expected`.
    #[must_use]
    pub const fn new(expected: &'static str, of: &'static [Alternative]) -> Self {
        Self { expected, of, default: None }
    }

    /// The schemas of the types that a text can stand for.
    fn plain(&self) -> Vec<RefOr<Schema>> {
        let plain = |alternative: &Alternative| match alternative {
            Alternative::Number(number) => Some(number.described(None).into()),
            Alternative::Word(word, meaning) => Some(words(vec![word]).description(Some(*meaning)).into()),
            Alternative::Asked(..) => Some(yes(None).into()),
            Alternative::Numbers(_) | Alternative::Object(..) => None,
        };
        self.of.iter().filter_map(plain).collect()
    }

    fn any(&self, meaning: &str, of: impl IntoIterator<Item = RefOr<Schema>>) -> RefOr<Schema> {
        let any = OneOfBuilder::new().description(Some(meaning)).default(self.default.map(serde_json::Value::from));
        of.into_iter().fold(any, OneOfBuilder::item).into()
    }

    fn objects(&self) -> impl Iterator<Item = (&'static Object, &'static str)> {
        self.of.iter().filter_map(|alternative| match alternative {
            Alternative::Object(object, meaning) | Alternative::Asked(object, meaning) => Some((*object, *meaning)),
            _ => None,
        })
    }
}

impl Kind for OneOf {
    type Value<'a> = Either<'a>;

    fn read<'a>(&self, node: &'a Node<'a>, place: Scope<'a>) -> Option<Either<'a>> {
        for alternative in self.of {
            return match (alternative, node) {
                (Alternative::Number(number), Node::Number(value)) => number.check(&place, *value).map(Either::Number),
                (Alternative::Word(word, _), Node::Text(text) | Node::Parameter(text)) if text == word => Some(Either::Word),
                (Alternative::Numbers(numbers), Node::List(list)) => numbers.check(list, place).map(Either::Numbers),
                (Alternative::Object(object, _) | Alternative::Asked(object, _), Node::Object(_)) => {
                    object.read(node, place).map(Either::Object)
                }
                (Alternative::Asked(..), Node::Flag(true)) => Some(Either::Object(Reader::empty(place))),
                _ => continue,
            };
        }
        let has_word = self.of.iter().any(|alternative| matches!(alternative, Alternative::Word(..)));
        if has_word && node.text().is_some() {
            place.fault(format_args!("must be {}", self.expected));
            return None;
        }
        wrong_type(&place, self.expected, node)
    }

    fn schema(&self, meaning: &str) -> RefOr<Schema> {
        let schemas = self.of.iter().flat_map(|alternative| match alternative {
            Alternative::Number(number) => vec![number.described(None).into()],
            Alternative::Word(word, meaning) => vec![words(vec![word]).description(Some(*meaning)).into()],
            Alternative::Numbers(numbers) => vec![numbers.array().into()],
            Alternative::Object(object, meaning) => vec![object.reference(meaning)],
            Alternative::Asked(object, meaning) => vec![object.reference(meaning), yes(None).into()],
        });
        self.any(meaning, schemas)
    }

    fn components(&self, found: &mut Components) {
        self.objects().for_each(|(object, _)| object.component(found));
    }

    fn parameters(&self, name: &str, meaning: &str, required: bool, found: &mut Vec<Parameter>) {
        let mut plain = self.plain();
        match (plain.len(), plain.pop()) {
            (0, _) | (_, None) => {}
            (1, Some(only)) => found.push(parameter(name, meaning, only)),
            (_, Some(last)) => {
                plain.push(last);
                found.push(parameter(name, meaning, self.any(meaning, plain)));
            }
        }
        for (object, _) in self.objects() {
            parameters_within(name, required, found, |around, found| object.parameters(around, found));
        }
    }

    fn names_within(&self) -> Vec<&'static str> {
        self.objects().flat_map(|(object, _)| object.names()).collect()
    }

    fn number_at(&self, way: Way<'_>) -> Result<Number, Astray> {
        match way.step() {
            Some(_) => match self.objects().next() {
                Some((object, _)) => object.number_within(way),
                None => Err(way.astray("a number")),
            },
            None => match self.of.iter().find_map(Alternative::number) {
                Some(number) => Ok(number),
                None => Err(Astray::NoNumber { what: self.expected.to_owned() }),
            },
        }
    }
}
