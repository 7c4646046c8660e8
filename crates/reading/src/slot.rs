//! Numbers of a tree that are written anew again and again.

use std::borrow::Cow;

use crate::node::{Fields, List, Node};
use crate::path::Path;

/// Where a number stands in a tree, for good: trees do not shrink.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Slot(Vec<usize>);

/// What stands in the way of a path, in words, and the path of that.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Blocked {
    /// The path of what stands in the way, as a JSON pointer.
    pub pointer: String,
    /// What that is.
    pub found: Cow<'static, str>,
}

impl Node<'_> {
    /// The same tree by itself, apart from the text from which it was read.
    #[must_use]
    pub fn detached(&self) -> Node<'static> {
        let kept = |text: &str| Cow::Owned(String::from(text));
        match self {
            Self::Null => Node::Null,
            Self::Flag(flag) => Node::Flag(*flag),
            Self::Number(value) => Node::Number(*value),
            Self::Text(text) => Node::Text(kept(text)),
            Self::Parameter(text) => Node::Parameter(kept(text)),
            Self::List(list) => Node::List(Box::new(list.detached())),
            Self::Object(fields) => {
                Node::Object(Fields(fields.iter().map(|(name, node)| (kept(name), node.detached())).collect()))
            }
        }
    }

    /// Makes room for a number under a path: what stands there is replaced, objects on the way that are not there or null are added.
    ///
    /// # Errors
    /// What stands in the way.
    pub fn slot(&mut self, path: &Path) -> Result<Slot, Blocked> {
        let mut node = self;
        let mut slot = Vec::with_capacity(path.names().len());
        let mut way = String::new();
        for name in path.names() {
            if matches!(node, Node::Null) {
                *node = Node::Object(Fields::default());
            }
            let blocked = |found: Cow<'static, str>| Blocked { pointer: way.clone(), found };
            let at;
            (at, node) = match node {
                Node::Object(fields) => fields.place_of(name),
                Node::List(list) => {
                    let count = list.len();
                    let few = || Cow::Owned(format!("an array of {count} items"));
                    list.object_at(name).ok_or_else(|| blocked(few()))?
                }
                other => return Err(blocked(other.in_words())),
            };
            slot.push(at);
            way = format!("{way}/{name}");
        }
        *node = Node::Number(f64::NAN);
        Ok(Slot(slot))
    }

    /// Whether something other than null stands under these names, none of which is that of an item.
    #[must_use]
    pub fn has(&self, names: &[&str]) -> bool {
        let Some((name, below)) = names.split_first() else { return !matches!(self, Self::Null) };
        match self {
            Self::Object(fields) => fields.iter().any(|(known, node)| known == *name && node.has(below)),
            _ => false,
        }
    }

    /// Writes a number where [`slot`](Self::slot) of this tree made room.
    pub fn set(&mut self, slot: &Slot, value: f64) {
        let mut node = self;
        for &at in &slot.0 {
            let within = match node {
                Node::Object(fields) => fields.0.get_mut(at).map(|(_, node)| node),
                Node::List(list) => list.other_mut(at),
                _ => None,
            };
            let Some(within) = within else { return };
            node = within;
        }
        *node = Node::Number(value);
    }
}

impl<'a> Fields<'a> {
    /// The place of a field, the last of its name; it is added where it is not there.
    fn place_of(&mut self, name: &str) -> (usize, &mut Node<'a>) {
        let at = self.0.iter().rposition(|(known, _)| known == name).unwrap_or_else(|| {
            self.0.push((Cow::Owned(String::from(name)), Node::Null));
            self.0.len() - 1
        });
        (at, &mut self.0[at].1)
    }
}

impl<'a> List<'a> {
    fn detached(&self) -> List<'static> {
        let mut list = List::default();
        self.items().for_each(|item| {
            list.push(match item {
                crate::Item::Number(value) => Node::Number(value),
                crate::Item::Null => Node::Null,
                crate::Item::Other(node) => node.detached(),
            })
        });
        list
    }

    /// The item of that number, if it is none of the numbers, with its place among the others.
    fn object_at(&mut self, number: &str) -> Option<(usize, &mut Node<'a>)> {
        let number: usize = number.parse().ok()?;
        let at = self.others().iter().position(|(place, _)| *place == number)?;
        Some((at, self.other_mut(at)?))
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::json;

    fn path(pointer: &str) -> Path {
        Path::of_pointer(pointer).expect("a pointer")
    }

    #[test]
    fn numbers_are_written_wherever_they_stand() {
        let text = br#"{"slip": "x", "wheel": {"radius_m": 1}, "contact": null, "stations": [{"x_m": 1}, {"x_m": 2}]}"#;
        let mut tree = json(text).expect("JSON").detached();
        let pointers = ["/slip", "/wheel/width_m", "/contact/interface/adhesion_pa", "/stations/1/x_m"];
        let slots: Vec<Slot> = pointers.iter().map(|pointer| tree.slot(&path(pointer)).expect("a slot")).collect();
        for (i, slot) in slots.iter().enumerate() {
            tree.set(slot, i as f64);
        }
        let expected = br#"{"slip": 0, "wheel": {"radius_m": 1, "width_m": 1}, "contact": {"interface": {"adhesion_pa": 2}},
                            "stations": [{"x_m": 1}, {"x_m": 3}]}"#;
        // What is no number in a list is NaN there, which equals nothing.
        assert_eq!(format!("{tree:?}"), format!("{:?}", json(expected).expect("JSON")));
    }

    #[test]
    fn what_stands_in_the_way_is_told() {
        let mut tree = json(br#"{"wheel": 5, "stations": [{}]}"#).expect("JSON").detached();
        let blocked = |pointer: &str, found: &'static str| Err(Blocked { pointer: pointer.into(), found: found.into() });
        assert_eq!(tree.slot(&path("/wheel/radius_m")), blocked("/wheel", "a number"));
        assert_eq!(tree.slot(&path("/stations/1/x_m")), blocked("/stations", "an array of 1 items"));
    }
}
