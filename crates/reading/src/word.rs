//! Words: out of a list that is declared, out of one that is looked up, or the client's own.

use utoipa::openapi::schema::{ObjectBuilder, Type};
use utoipa::openapi::{Ref, RefOr, Schema};

use crate::fault::Scope;
use crate::fault::unknown_word;
use crate::field::{Components, Kind, wrong_type};
use crate::node::Node;
use crate::reader::Defaulting;

/// One of some words, each with what it means to the program.
#[derive(Debug, Clone, Copy)]
pub struct Word<T: 'static> {
    /// The words.
    pub words: &'static [(&'static str, T)],
    /// What holds where the field is left out.
    pub default: Option<T>,
}

impl<T: Copy> Word<T> {
    /// One of these.
    #[must_use]
    pub const fn new(words: &'static [(&'static str, T)]) -> Self {
        Self { words, default: None }
    }

    /// What holds where the field is left out.
    #[must_use]
    pub const fn or(self, default: T) -> Self {
        Self { default: Some(default), ..self }
    }

    pub(crate) fn names(&self) -> Vec<&'static str> {
        self.words.iter().map(|(word, _)| *word).collect()
    }

    /// What a word means; one that is not known is reported.
    pub(crate) fn look_up(&self, word: &str, place: &Scope<'_>) -> Option<T> {
        let found = self.words.iter().find(|(known, _)| *known == word).map(|(_, value)| *value);
        if found.is_none() {
            unknown_word(place, word, &self.names());
        }
        found
    }
}

/// The schema of one of some words.
pub(crate) fn words(names: Vec<&'static str>) -> ObjectBuilder {
    ObjectBuilder::new().schema_type(Type::String).enum_values(Some(names))
}

impl<T: Copy + PartialEq + Sync> Kind for Word<T> {
    type Value<'a> = T;

    fn read<'a>(&self, node: &'a Node<'a>, place: Scope<'a>) -> Option<T> {
        match node.text() {
            Some(word) => self.look_up(word, &place),
            None => wrong_type(&place, "a string", node),
        }
    }

    fn schema(&self, meaning: &str) -> RefOr<Schema> {
        let default = self.default.and_then(|default| self.words.iter().find(|(_, value)| *value == default));
        words(self.names()).description(Some(meaning)).default(default.map(|(word, _)| (*word).into())).into()
    }
}

impl<T: Copy + PartialEq + Sync> Defaulting for Word<T> {
    fn default(&self) -> Option<T> {
        self.default
    }
}

/// One of some words that are known only when the program runs.
#[derive(Debug, Clone, Copy)]
pub struct Lookup<T: 'static> {
    /// The name of the words in the contract, where several fields take them.
    pub name: Option<&'static str>,
    /// The words.
    pub words: fn() -> Vec<&'static str>,
    /// What a word means.
    pub find: fn(&str) -> Option<T>,
}

impl<T> Kind for Lookup<T> {
    type Value<'a> = T;

    fn read<'a>(&self, node: &'a Node<'a>, place: Scope<'a>) -> Option<T> {
        let Some(word) = node.text() else { return wrong_type(&place, "a string", node) };
        let found = (self.find)(word);
        if found.is_none() {
            unknown_word(&place, word, &(self.words)());
        }
        found
    }

    fn schema(&self, meaning: &str) -> RefOr<Schema> {
        match self.name {
            Some(name) => Ref::builder().ref_location_from_schema_name(name).description(Some(meaning)).build().into(),
            None => words((self.words)()).description(Some(meaning)).into(),
        }
    }

    fn components(&self, found: &mut Components) {
        if let Some(name) = self.name {
            found.push((name.to_owned(), words((self.words)()).into()));
        }
    }
}

/// A name that a client gives: a text that stands on one line.
#[derive(Debug, Clone, Copy)]
pub struct Label;

impl Label {
    /// Characters of the longest.
    pub const LONGEST: usize = 60;
}

impl Kind for Label {
    type Value<'a> = &'a str;

    fn read<'a>(&self, node: &'a Node<'a>, place: Scope<'a>) -> Option<&'a str> {
        let Some(text) = node.text() else { return wrong_type(&place, "a string", node) };
        let length = text.chars().take(Self::LONGEST + 1).count();
        if !(1..=Self::LONGEST).contains(&length) || text.chars().any(char::is_control) {
            place.fault(format_args!("must have from 1 to {} characters, none of them a control character", Self::LONGEST));
            return None;
        }
        Some(text)
    }

    fn schema(&self, meaning: &str) -> RefOr<Schema> {
        ObjectBuilder::new()
            .schema_type(Type::String)
            .description(Some(meaning))
            .min_length(Some(1))
            .max_length(Some(Self::LONGEST))
            .pattern(Some(r"^[^\u0000-\u001f\u007f-\u009f]+$"))
            .into()
    }
}

/// True or false.
#[derive(Debug, Clone, Copy)]
pub struct Flag;

impl Kind for Flag {
    type Value<'a> = bool;

    fn read<'a>(&self, node: &'a Node<'a>, place: Scope<'a>) -> Option<bool> {
        match node {
            Node::Flag(value) => Some(*value),
            // In a query only `true` stands for itself.
            Node::Parameter(text) if text == "false" => Some(false),
            other => wrong_type(&place, "true or false", other),
        }
    }

    fn schema(&self, meaning: &str) -> RefOr<Schema> {
        ObjectBuilder::new().schema_type(Type::Boolean).description(Some(meaning)).into()
    }

    fn what(&self) -> &'static str {
        "true or false"
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::fault::Faults;
    use crate::hints::Hints;

    fn read<'a, K: Kind>(kind: K, node: &'a Node<'a>, faults: &'a Faults) -> Option<K::Value<'a>> {
        kind.read(node, Scope::root(faults))
    }

    #[test]
    fn a_word_means_what_its_table_says() {
        const SIDE: Word<i8> = Word::new(&[("left", -1), ("right", 1)]).or(1);
        let faults = Faults::new(&Hints::NONE);
        assert_eq!(read(SIDE, &Node::Text("left".into()), &faults), Some(-1));
        assert_eq!(read(SIDE, &Node::Parameter("right".into()), &faults), Some(1));
        assert_eq!(read(SIDE, &Node::Text("rihgt".into()), &faults), None);
        assert_eq!(read(SIDE, &Node::Number(1.0), &faults), None);
        let said: Vec<_> = faults.into_list().into_iter().map(|fault| fault.detail).collect();
        assert_eq!(said, ["unknown name `rihgt`; did you mean `right`?", "must be a string, not a number"]);
        let schema = serde_json::to_value(SIDE.schema("A side.")).expect("JSON");
        assert_eq!(schema["enum"], serde_json::json!(["left", "right"]));
        assert_eq!(schema["default"], "right");
    }

    #[test]
    fn a_label_is_short_and_on_one_line() {
        let is_taken = |text: &str| read(Label, &Node::Text(text.into()), &Faults::new(&Hints::NONE)).is_some();
        assert!(is_taken("ä") && is_taken(&"ä".repeat(60)));
        assert!(!is_taken("") && !is_taken(&"a".repeat(61)) && !is_taken("a\nb") && !is_taken(&"a".repeat(1_000_000)));
    }

    #[test]
    fn a_flag_is_read_from_bodies_and_queries() {
        let faults = Faults::new(&Hints::NONE);
        assert_eq!(read(Flag, &Node::Flag(true), &faults), Some(true));
        assert_eq!(read(Flag, &Node::Parameter("false".into()), &faults), Some(false));
        assert_eq!(read(Flag, &Node::Parameter("yes".into()), &faults), None);
    }
}
