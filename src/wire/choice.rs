//! Words out of a closed list, and the word that was probably meant.

use utoipa::openapi::schema::{ObjectBuilder, Type};
use utoipa::openapi::{RefOr, Schema};

use super::{Entry, Scope, Spec, Wire, nearest};

/// One of some words.
#[derive(Debug)]
pub(crate) struct Choice {
    pub(crate) doc: &'static str,
    pub(crate) words: fn() -> Vec<&'static str>,
    pub(crate) default: Option<&'static str>,
}

impl Spec for Choice {
    fn schema(&self) -> RefOr<Schema> {
        ObjectBuilder::new()
            .schema_type(Type::String)
            .description(Some(self.doc))
            .enum_values(Some((self.words)()))
            .default(self.default.map(serde_json::Value::from))
            .into()
    }
}

impl Wire for String {
    type Spec = Choice;
    const EXPECTED: &'static str = "a string";

    fn text(value: &str) -> Option<Self> {
        Some(value.to_owned())
    }
}

impl Entry<'_, String> {
    /// The word; that none was sent is reported with the words there are.
    pub(crate) fn required_word(&self, object: &Scope<'_>) {
        if !self.is_present() {
            object.field(self.name).fault(format_args!("is required: one of {}", (self.spec.words)().join(", ")));
        }
    }

    /// What `lookup` makes of the word, if one was sent; an unknown one is reported with the nearest known.
    pub(crate) fn looked_up<T>(&self, object: &Scope<'_>, lookup: impl Fn(&str) -> Option<T>) -> Option<T> {
        let word = self.given(object)?;
        let found = lookup(word);
        if found.is_none() {
            unknown_word(&object.field(self.name), word, &(self.spec.words)());
        }
        found
    }
}

/// Reports a word that is not known.
pub(crate) fn unknown_word(place: &Scope<'_>, word: &str, known: &[&str]) {
    let word = shortened(word);
    match nearest(&word, known) {
        Some(near) => place.fault(format_args!("unknown name `{word}`; did you mean `{near}`?")),
        None => place.fault(format_args!("unknown name `{word}`; known are {}", known.join(", "))),
    }
}

/// A client's word, cut to a length that is fit for a message.
pub(crate) fn shortened(word: &str) -> String {
    const LONGEST: usize = 60;
    if word.chars().count() <= LONGEST { word.to_owned() } else { word.chars().take(LONGEST).chain(['…']).collect() }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_long_word_is_cut() {
        assert_eq!(shortened(&"ä".repeat(100)).chars().count(), 61);
    }
}
