//! What a client sent, as one tree for bodies and queries.

use std::borrow::Cow;

use crate::literal::number;
use crate::shortened;

/// A value as it was sent.
#[derive(Debug, Clone, PartialEq)]
pub enum Node<'a> {
    /// `null`.
    Null,
    /// `true` or `false`.
    Flag(bool),
    /// A number; infinite where a query has one beyond all doubles.
    Number(f64),
    /// A text.
    Text(Cow<'a, str>),
    /// The text of a query's parameter, which may have been meant as anything.
    Parameter(Cow<'a, str>),
    /// An array, apart from the node, so that all nodes are small.
    List(Box<List<'a>>),
    /// An object.
    Object(Fields<'a>),
}

impl Node<'_> {
    /// What it is, in words, for messages.
    ///
    /// ```
    /// use terramechanics_reading::Node;
    /// assert_eq!(Node::Number(1.0).in_words(), "a number");
    /// assert_eq!(Node::Parameter("0,5".into()).in_words(), "`0,5`, whose decimal point is a comma");
    /// ```
    #[must_use]
    pub fn in_words(&self) -> Cow<'static, str> {
        Cow::Borrowed(match self {
            Self::Null => "null",
            Self::Flag(true) => "true",
            Self::Flag(false) => "false",
            Self::Number(_) => "a number",
            Self::Text(_) => "a string",
            Self::Parameter(text) if text.is_empty() => "nothing",
            Self::Parameter(text) => {
                // It is repeated, so that one sees what stood in its way.
                let comma = number(&text.replacen(',', ".", 1)).is_some();
                let hint = if comma { ", whose decimal point is a comma" } else { "" };
                return Cow::Owned(format!("`{}`{hint}", shortened(text)));
            }
            Self::List(_) => "an array",
            Self::Object(_) => "an object",
        })
    }

    /// The text, if it is one.
    #[must_use]
    pub fn text(&self) -> Option<&str> {
        match self {
            Self::Text(text) | Self::Parameter(text) => Some(text),
            _ => None,
        }
    }
}

/// Whether two names are the same; most that are not differ in their length or their first letter.
#[inline]
pub(crate) fn is_same(a: &str, b: &str) -> bool {
    a.len() == b.len() && a.as_bytes().first() == b.as_bytes().first() && a == b
}

/// The fields of an object, in their order; a name may be there more than once.
#[derive(Debug, Clone, Default, PartialEq)]
pub struct Fields<'a>(pub(crate) Vec<(Cow<'a, str>, Node<'a>)>);

impl<'a> Fields<'a> {
    /// The value at that place.
    #[must_use]
    pub fn get(&self, at: usize) -> Option<&Node<'a>> {
        self.0.get(at).map(|(_, node)| node)
    }

    /// Names and values.
    pub fn iter(&self) -> impl Iterator<Item = (&str, &Node<'a>)> {
        self.0.iter().map(|(name, node)| (name.as_ref(), node))
    }
}

/// An array: numbers in a row, and the items that are none beside them.
#[derive(Debug, Clone, Default, PartialEq)]
pub struct List<'a> {
    /// NaN where an item is no number.
    numbers: Vec<f64>,
    /// The first items that are neither a number nor null, with their places.
    others: Vec<(usize, Node<'a>)>,
}

/// An item of an array.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Item<'n, 'a> {
    /// A number.
    Number(f64),
    /// `null`, or one of so many others that it was not kept.
    Null,
    /// Anything else.
    Other(&'n Node<'a>),
}

impl<'a> List<'a> {
    /// Items that are neither a number nor null and are kept of any list; no request has lists of more objects or names.
    pub const MOST_OTHERS: usize = 64;

    /// Whether another item that is no number is kept.
    pub(crate) fn keeps_others(&self) -> bool {
        self.others.len() < Self::MOST_OTHERS
    }

    pub(crate) fn push(&mut self, item: Node<'a>) {
        match item {
            Node::Number(value) => self.push_number(value),
            Node::Null => self.push_number(f64::NAN),
            other => {
                if self.keeps_others() {
                    self.others.push((self.numbers.len(), other));
                }
                self.push_number(f64::NAN);
            }
        }
    }

    /// Adds a number, or NaN for null.
    #[inline]
    pub(crate) fn push_number(&mut self, value: f64) {
        self.numbers.push(value);
    }

    /// Number of items.
    #[must_use]
    pub fn len(&self) -> usize {
        self.numbers.len()
    }

    /// Whether there are no items.
    #[must_use]
    pub fn is_empty(&self) -> bool {
        self.numbers.is_empty()
    }

    /// The numbers, NaN where an item is none.
    #[must_use]
    pub fn numbers(&self) -> &[f64] {
        &self.numbers
    }

    /// The first items that are neither a number nor null, with their places.
    #[must_use]
    pub fn others(&self) -> &[(usize, Node<'a>)] {
        &self.others
    }

    pub(crate) fn other_mut(&mut self, at: usize) -> Option<&mut Node<'a>> {
        self.others.get_mut(at).map(|(_, node)| node)
    }

    /// All items.
    pub fn items(&self) -> impl Iterator<Item = Item<'_, 'a>> {
        let mut others = self.others.iter().peekable();
        self.numbers.iter().enumerate().map(move |(at, &number)| match others.next_if(|(place, _)| *place == at) {
            Some((_, other)) => Item::Other(other),
            None if number.is_nan() => Item::Null,
            None => Item::Number(number),
        })
    }
}

impl Item<'_, '_> {
    /// What it is, in words, for messages.
    #[must_use]
    pub fn in_words(&self) -> Cow<'static, str> {
        match self {
            Self::Number(_) => Cow::Borrowed("a number"),
            Self::Null => Cow::Borrowed("null"),
            Self::Other(node) => node.in_words(),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn items_that_are_no_numbers_keep_their_places() {
        let mut list = List::default();
        for item in [Node::Number(1.0), Node::Null, Node::Flag(true), Node::Number(2.0), Node::Text("a".into())] {
            list.push(item);
        }
        let items: Vec<_> = list.items().collect();
        assert_eq!(items[..2], [Item::Number(1.0), Item::Null]);
        assert_eq!(items[2..], [Item::Other(&Node::Flag(true)), Item::Number(2.0), Item::Other(&Node::Text("a".into()))]);
    }

    #[test]
    fn few_of_many_odd_items_are_kept() {
        let mut list = List::default();
        (0..1000).for_each(|_| list.push(Node::Flag(false)));
        assert_eq!((list.len(), list.others().len()), (1000, List::MOST_OTHERS));
    }
}
