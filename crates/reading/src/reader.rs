//! Reading the fields of an object.

use std::borrow::Cow;

use crate::fault::Scope;
use crate::field::{Field, Kind};
use crate::node::{Fields, Node, is_same};

/// An object that was sent, and where it stands.
///
/// A field is read by its declaration. What is wrong is reported where it stands, and nothing comes of it; so a caller reads all
/// fields before it gives up on one.
///
/// ```
/// use terramechanics_reading::{Faults, Field, Group, Hints, Number, Object, json, read};
///
/// const RADIUS: Field<Number> = Field::required("radius_m", "Radius (m).", Number::new("m", 1e-3, 100.0));
/// const LUGS: Field<Number> = Field::new("lug_height_m", "Height of the lugs (m).", Number::new("m", 0.0, 10.0).or(0.0));
/// const WHEEL: Object = Object { name: "Wheel", doc: "A wheel.", groups: &[&[&RADIUS, &LUGS]] };
///
/// let body = json(br#"{"radius_m": 500, "lug_hieght_m": 0.01}"#).expect("JSON");
/// let faults = read(&body, &WHEEL, &Hints::NONE, |wheel| {
///     let (radius, lugs) = (wheel.required(&RADIUS), wheel.or_default(&LUGS));
///     Some((radius?, lugs?))
/// }).expect_err("two faults");
/// assert_eq!(faults[0].detail, "unknown field; did you mean `lug_height_m`?");
/// assert_eq!(faults[1].detail, "must be from 0.001 to 100, not 500; it is in metres: 500 mm are 0.5");
/// ```
#[derive(Clone, Copy)]
pub struct Reader<'a> {
    fields: &'a [(Cow<'a, str>, Node<'a>)],
    /// The marks of all names, by which most fields that were not sent are told at once.
    marks: u64,
    place: Scope<'a>,
    over: Option<&'a Reader<'a>>,
}

/// One of 64 bits, the same for the same name.
#[inline]
fn mark(name: &str) -> u64 {
    let [first, .., last] = name.as_bytes() else { return 1 };
    1 << ((name.len() * 7 + usize::from(*first) * 3 + usize::from(*last)) % 64)
}

/// What holds where a field of a kind is left out.
pub trait Defaulting: Kind {
    /// The default; none where there is none.
    fn default(&self) -> Option<Self::Value<'_>>;
}

impl<'a> Reader<'a> {
    pub(crate) fn new(fields: &'a Fields<'a>, place: Scope<'a>) -> Self {
        let marks = fields.0.iter().fold(0, |marks, (name, _)| marks | mark(name));
        Self { fields: &fields.0, marks, place, over: None }
    }

    /// An object without fields.
    #[must_use]
    pub fn empty(place: Scope<'a>) -> Self {
        Self { fields: &[], marks: 0, place, over: None }
    }

    /// The object in which the fields of `over` take the place of those of the same name; they keep their own places.
    #[must_use]
    pub fn overlaid(self, over: &'a Reader<'a>) -> Self {
        Self { over: Some(over), ..self }
    }

    /// The object as one that stands at another place.
    #[must_use]
    pub fn at(self, place: Scope<'a>) -> Self {
        Self { place, ..self }
    }

    /// Where the object stands.
    #[must_use]
    pub fn place(&self) -> &Scope<'a> {
        &self.place
    }

    /// What was sent for a field, right or wrong, and the object in which it stands.
    fn find<K>(&self, field: &Field<K>) -> Option<(&Self, &'a Node<'a>)> {
        if let Some(found) = self.over.and_then(|over| over.find(field)) {
            return Some(found);
        }
        if self.marks & mark(field.name) == 0 {
            return None;
        }
        let (_, node) = self.fields.iter().rfind(|(name, _)| is_same(name, field.name))?;
        (field.required || !matches!(node, Node::Null)).then_some((self, node))
    }

    /// Whether something was sent for a field, right or wrong.
    #[must_use]
    pub fn has<K>(&self, field: &Field<K>) -> bool {
        self.find(field).is_some()
    }

    /// Where a field stands, or would stand.
    #[must_use]
    pub fn place_of<'r, K>(&'r self, field: &Field<K>) -> Scope<'r> {
        self.find(field).map_or(self, |(reader, _)| reader).place.field(field.name)
    }

    /// Its value, if it was sent; no answer at all where what was sent is wrong.
    #[must_use]
    pub fn optional<'r, K: Kind>(&'r self, field: &Field<K>) -> Option<Option<K::Value<'r>>> {
        match self.find(field) {
            Some((reader, node)) => field.kind.read(node, reader.place.field(field.name)).map(Some),
            None => Some(None),
        }
    }

    /// Its value; that none was sent is reported.
    #[must_use]
    pub fn required<'r, K: Kind>(&'r self, field: &Field<K>) -> Option<K::Value<'r>> {
        let value = self.optional(field)?;
        if value.is_none() {
            field.kind.absent(&self.place.field(field.name));
        }
        value
    }

    /// Its value, or what holds where it was not sent; none where what was sent is wrong or there is no default.
    #[must_use]
    pub fn or_default<'r, K: Defaulting>(&'r self, field: &'r Field<K>) -> Option<K::Value<'r>> {
        self.optional(field)?.or_else(|| field.kind.default())
    }

    /// What was sent for a field that is an object, before anything of it was read.
    pub(crate) fn raw<'r, K>(&'r self, field: &Field<K>) -> Option<(&'r Node<'r>, Scope<'r>)> {
        let (reader, node) = self.find(field)?;
        Some((node, reader.place.field(field.name)))
    }
}
