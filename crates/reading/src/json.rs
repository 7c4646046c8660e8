//! A JSON text as a tree.

use std::borrow::Cow;
use std::cell::Cell;
use std::fmt;

use serde::de::{DeserializeSeed, Deserializer, IgnoredAny, MapAccess, SeqAccess, Visitor};

use crate::node::{Fields, List, Node};

/// Objects and lists within each other that are kept; of what lies deeper only the kind is. No request lies deeper.
const DEEPEST: usize = 12;

/// Fields of objects, and items of lists that are no numbers, which a text may have in all.
pub const MOST_NODES: usize = 10_000;

/// Fields for which an object has room at first.
const USUAL_FIELDS: usize = 12;

/// Why there is no tree.
#[derive(Debug)]
pub enum Unread {
    /// The text is not JSON.
    NotJson(serde_json::Error),
    /// It has more than [`MOST_NODES`] fields and items.
    TooMuch,
}

impl fmt::Display for Unread {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::NotJson(error) => error.fmt(f),
            Self::TooMuch => write!(f, "there may be {MOST_NODES} fields in all"),
        }
    }
}

impl std::error::Error for Unread {}

/// Reads a whole JSON text; a byte order mark before it, which some editors and shells write, is passed over
/// (RFC 8259, section 8.1).
///
/// # Errors
/// Where the text is not JSON or has too many fields.
///
/// ```
/// use terramechanics_reading::{Node, json};
/// let Node::Object(fields) = json(br#"{"slip": 0.2, "slip": 0.3}"#)? else { panic!("an object") };
/// assert_eq!(fields.iter().count(), 2); // repeated names are seen
/// # Ok::<(), terramechanics_reading::Unread>(())
/// ```
pub fn json(text: &[u8]) -> Result<Node<'_>, Unread> {
    let text = text.strip_prefix(b"\xEF\xBB\xBF").unwrap_or(text);
    let left = Cell::new(Some(MOST_NODES));
    let seed = Seed { left: &left, depth: DEEPEST, keep: true };
    // Looked through at once, the text need not be looked at again name by name; where it is no text, the parser says where.
    let node = match std::str::from_utf8(text) {
        Ok(text) => whole(seed, serde_json::Deserializer::from_str(text)),
        Err(_) => whole(seed, serde_json::Deserializer::from_slice(text)),
    };
    let node = node.map_err(Unread::NotJson)?;
    if left.get().is_none() { Err(Unread::TooMuch) } else { Ok(node) }
}

fn whole<'de, R: serde_json::de::Read<'de>>(
    seed: Seed<'_>,
    mut deserializer: serde_json::Deserializer<R>,
) -> serde_json::Result<Node<'de>> {
    let node = seed.deserialize(&mut deserializer)?;
    deserializer.end()?;
    Ok(node)
}

/// The tree of a value that a program made.
impl<'a> From<&'a serde_json::Value> for Node<'a> {
    fn from(value: &'a serde_json::Value) -> Self {
        let left = Cell::new(Some(usize::MAX));
        // A value can always be read.
        Seed { left: &left, depth: DEEPEST, keep: true }.deserialize(value).unwrap_or(Node::Null)
    }
}

/// Reads one value.
#[derive(Clone, Copy)]
struct Seed<'s> {
    /// Nodes that may still come; none once there were too many.
    left: &'s Cell<Option<usize>>,
    depth: usize,
    /// Whether what the value holds is kept.
    keep: bool,
}

impl Seed<'_> {
    /// Takes one of the nodes that are left; false where there is none.
    fn take(self) -> bool {
        let left = self.left.get().and_then(|left| left.checked_sub(1));
        self.left.set(left);
        left.is_some()
    }

    fn text<'de>(self, text: impl FnOnce() -> Cow<'de, str>) -> Node<'de> {
        Node::Text(if self.keep { text() } else { Cow::Borrowed("") })
    }
}

impl<'de> DeserializeSeed<'de> for Seed<'_> {
    type Value = Node<'de>;

    fn deserialize<D: Deserializer<'de>>(self, deserializer: D) -> Result<Node<'de>, D::Error> {
        deserializer.deserialize_any(self)
    }
}

impl<'de> Visitor<'de> for Seed<'_> {
    type Value = Node<'de>;

    fn expecting(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str("a JSON value")
    }

    fn visit_f64<E>(self, value: f64) -> Result<Node<'de>, E> {
        Ok(Node::Number(value))
    }

    fn visit_u64<E>(self, value: u64) -> Result<Node<'de>, E> {
        Ok(Node::Number(value as f64))
    }

    fn visit_i64<E>(self, value: i64) -> Result<Node<'de>, E> {
        Ok(Node::Number(value as f64))
    }

    fn visit_bool<E>(self, value: bool) -> Result<Node<'de>, E> {
        Ok(Node::Flag(value))
    }

    fn visit_unit<E>(self) -> Result<Node<'de>, E> {
        Ok(Node::Null)
    }

    fn visit_borrowed_str<E>(self, value: &'de str) -> Result<Node<'de>, E> {
        Ok(self.text(|| Cow::Borrowed(value)))
    }

    fn visit_str<E>(self, value: &str) -> Result<Node<'de>, E> {
        Ok(self.text(|| Cow::Owned(value.to_owned())))
    }

    fn visit_seq<A: SeqAccess<'de>>(self, mut items: A) -> Result<Node<'de>, A::Error> {
        let mut list = List::default();
        if self.keep && self.depth > 0 {
            let inside = Self { depth: self.depth - 1, ..self };
            while items.next_element_seed(ItemSeed { inside, list: &mut list })?.is_some() {}
        } else {
            while items.next_element::<IgnoredAny>()?.is_some() {}
        }
        Ok(Node::List(Box::new(list)))
    }

    fn visit_map<A: MapAccess<'de>>(self, mut map: A) -> Result<Node<'de>, A::Error> {
        if !self.keep || self.depth == 0 {
            while map.next_entry::<IgnoredAny, IgnoredAny>()?.is_some() {}
            return Ok(Node::Object(Fields::default()));
        }
        let mut fields = Vec::with_capacity(USUAL_FIELDS);
        while let Some(name) = map.next_key_seed(Name)? {
            let keep = self.take();
            let value = map.next_value_seed(Self { depth: self.depth - 1, keep, ..self })?;
            if keep {
                fields.push((name, value));
            }
        }
        Ok(Node::Object(Fields(fields)))
    }
}

/// Reads an item of a list, above all a number, into the list.
struct ItemSeed<'s, 'l, 'de> {
    inside: Seed<'s>,
    list: &'l mut List<'de>,
}

impl<'de> ItemSeed<'_, '_, 'de> {
    fn other<E>(self, read: impl FnOnce(Seed<'_>) -> Result<Node<'de>, E>) -> Result<(), E> {
        let keep = self.list.keeps_others() && self.inside.take();
        let item = read(Seed { keep, ..self.inside })?;
        self.list.push(item);
        Ok(())
    }
}

impl<'de> DeserializeSeed<'de> for ItemSeed<'_, '_, 'de> {
    type Value = ();

    fn deserialize<D: Deserializer<'de>>(self, deserializer: D) -> Result<(), D::Error> {
        deserializer.deserialize_any(self)
    }
}

impl<'de> Visitor<'de> for ItemSeed<'_, '_, 'de> {
    type Value = ();

    fn expecting(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        self.inside.expecting(f)
    }

    fn visit_f64<E>(self, value: f64) -> Result<(), E> {
        self.list.push_number(value);
        Ok(())
    }

    fn visit_u64<E>(self, value: u64) -> Result<(), E> {
        self.list.push_number(value as f64);
        Ok(())
    }

    fn visit_i64<E>(self, value: i64) -> Result<(), E> {
        self.list.push_number(value as f64);
        Ok(())
    }

    fn visit_unit<E>(self) -> Result<(), E> {
        self.list.push_number(f64::NAN);
        Ok(())
    }

    fn visit_bool<E>(self, value: bool) -> Result<(), E> {
        self.other(|_| Ok(Node::Flag(value)))
    }

    fn visit_borrowed_str<E: serde::de::Error>(self, value: &'de str) -> Result<(), E> {
        self.other(|seed| seed.visit_borrowed_str(value))
    }

    fn visit_str<E: serde::de::Error>(self, value: &str) -> Result<(), E> {
        self.other(|seed| seed.visit_str(value))
    }

    fn visit_seq<A: SeqAccess<'de>>(self, items: A) -> Result<(), A::Error> {
        self.other(|seed| seed.visit_seq(items))
    }

    fn visit_map<A: MapAccess<'de>>(self, map: A) -> Result<(), A::Error> {
        self.other(|seed| seed.visit_map(map))
    }
}

/// Reads a name, which is borrowed where it stands in the text as it is.
struct Name;

impl<'de> DeserializeSeed<'de> for Name {
    type Value = Cow<'de, str>;

    fn deserialize<D: Deserializer<'de>>(self, deserializer: D) -> Result<Cow<'de, str>, D::Error> {
        deserializer.deserialize_str(self)
    }
}

impl<'de> Visitor<'de> for Name {
    type Value = Cow<'de, str>;

    fn expecting(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str("a name")
    }

    fn visit_borrowed_str<E>(self, name: &'de str) -> Result<Cow<'de, str>, E> {
        Ok(Cow::Borrowed(name))
    }

    fn visit_str<E>(self, name: &str) -> Result<Cow<'de, str>, E> {
        Ok(Cow::Owned(name.to_owned()))
    }
}

#[cfg(test)]
mod tests;
