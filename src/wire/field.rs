//! A field as it was sent.

use std::borrow::Cow;
use std::fmt;
use std::marker::PhantomData;

use serde::de::{Deserialize, Deserializer, IgnoredAny, MapAccess, SeqAccess, Visitor};

use super::query::number;
use super::{Spec, shortened};

/// What a client sent for one field.
#[derive(Debug, Clone, Default)]
pub(crate) enum Field<T> {
    /// Nothing.
    #[default]
    Absent,
    /// A value of the right type.
    Given(T),
    /// A value of another type, in words.
    Wrong(Cow<'static, str>),
}

/// A type that a field may have, by what it makes of each kind of JSON value; `None` is the wrong type.
pub(crate) trait Wire: Sized {
    /// What bounds a field of the type has.
    type Spec: Spec + 'static;
    /// The type in words, for messages.
    const EXPECTED: &'static str;

    fn number(_value: f64) -> Option<Self> {
        None
    }

    fn text(_value: &str) -> Option<Self> {
        None
    }

    fn flag(_value: bool) -> Option<Self> {
        None
    }

    fn list<'de, A: SeqAccess<'de>>(mut list: A) -> Result<Option<Self>, A::Error> {
        while list.next_element::<IgnoredAny>()?.is_some() {}
        Ok(None)
    }

    fn object<'de, A: MapAccess<'de>>(mut object: A) -> Result<Option<Self>, A::Error> {
        while object.next_entry::<IgnoredAny, IgnoredAny>()?.is_some() {}
        Ok(None)
    }
}

impl<'de, T: Wire> Deserialize<'de> for Field<T> {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        deserializer.deserialize_any(FieldVisitor(PhantomData))
    }
}

struct FieldVisitor<T>(PhantomData<T>);

impl<T> Field<T> {
    /// A value of another type, which is named.
    fn wrong(found: &'static str) -> Self {
        Self::Wrong(Cow::Borrowed(found))
    }

    fn of(value: Option<T>, found: &'static str) -> Self {
        value.map_or_else(|| Self::wrong(found), Self::Given)
    }
}

impl<'de, T: Wire> Visitor<'de> for FieldVisitor<T> {
    type Value = Field<T>;

    fn expecting(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(T::EXPECTED)
    }

    fn visit_f64<E>(self, value: f64) -> Result<Self::Value, E> {
        Ok(Field::of(T::number(value), "a number"))
    }

    fn visit_u64<E: serde::de::Error>(self, value: u64) -> Result<Self::Value, E> {
        self.visit_f64(value as f64)
    }

    fn visit_i64<E: serde::de::Error>(self, value: i64) -> Result<Self::Value, E> {
        self.visit_f64(value as f64)
    }

    fn visit_bool<E>(self, value: bool) -> Result<Self::Value, E> {
        Ok(Field::of(T::flag(value), if value { "true" } else { "false" }))
    }

    fn visit_unit<E>(self) -> Result<Self::Value, E> {
        Ok(Field::wrong("null"))
    }

    fn visit_str<E>(self, value: &str) -> Result<Self::Value, E> {
        Ok(Field::of(T::text(value), "a string"))
    }

    /// The text of a query, where nothing tells a text from a number: it is repeated, so that one sees what stood in its way.
    fn visit_bytes<E>(self, value: &[u8]) -> Result<Self::Value, E> {
        let text = String::from_utf8_lossy(value);
        if let Some(value) = T::text(&text) {
            return Ok(Field::Given(value));
        }
        let hint = if number(&text.replacen(',', ".", 1)).is_some() { ", whose decimal point is a comma" } else { "" };
        let found = if text.is_empty() { "nothing".to_owned() } else { format!("`{}`{hint}", shortened(&text)) };
        Ok(Field::Wrong(found.into()))
    }

    fn visit_seq<A: SeqAccess<'de>>(self, list: A) -> Result<Self::Value, A::Error> {
        Ok(Field::of(T::list(list)?, "an array"))
    }

    fn visit_map<A: MapAccess<'de>>(self, object: A) -> Result<Self::Value, A::Error> {
        Ok(Field::of(T::object(object)?, "an object"))
    }
}

/// Reads a whole JSON text as a field; a byte order mark before it, which some editors and shells write, is passed over
/// (RFC 8259, section 8.1).
///
/// # Errors
/// Where the text is not JSON.
pub(crate) fn read<T: Wire>(text: &[u8]) -> serde_json::Result<Field<T>> {
    serde_json::from_slice(text.strip_prefix(b"\xEF\xBB\xBF").unwrap_or(text))
}
