//! Looking a field up by its path, in the declaration of a request and in a request that was sent.

use std::fmt;

use crate::hints::{Hints, shortened};
use crate::number::Number;
use crate::object::Object;
use crate::one_of::{Alternative, OneOf};
use crate::tagged::Tagged;

/// What a field may hold, for those who look for the fields within.
#[derive(Clone, Copy)]
pub enum Content {
    /// A number.
    Number(Number),
    /// An object.
    Object(&'static Object),
    /// An object whose fields depend on a word.
    Tagged(&'static Tagged),
    /// A list of objects of one form.
    Objects(&'static Object),
    /// One of several types.
    OneOf(OneOf),
    /// What holds no field and is no number, in words.
    Other(&'static str),
}

/// The names from the request down to a field.
#[derive(Debug, Clone, PartialEq, Eq, Hash)]
pub struct Path(Vec<String>);

impl Path {
    /// Names in a path; no request lies deeper.
    const MOST: usize = 8;

    /// The path of a JSON pointer (RFC 6901); none where the text is none, or leads deeper than any request.
    #[must_use]
    pub fn of_pointer(text: &str) -> Option<Self> {
        let names = text.strip_prefix('/')?.split('/').map(|name| name.replace("~1", "/").replace("~0", "~"));
        Self::of_names(names)
    }

    /// The path of names with dots between.
    #[must_use]
    pub fn of_dotted(text: &str) -> Option<Self> {
        Self::of_names(text.split('.').map(str::to_owned))
    }

    fn of_names(names: impl Iterator<Item = String>) -> Option<Self> {
        let names: Vec<String> = names.take(Self::MOST + 1).collect();
        (names.len() <= Self::MOST).then_some(Self(names))
    }

    /// The names.
    #[must_use]
    pub fn names(&self) -> &[String] {
        &self.0
    }

    /// The path as a JSON pointer.
    #[must_use]
    pub fn pointer(&self) -> String {
        self.0.iter().map(|name| format!("/{}", name.replace('~', "~0").replace('/', "~1"))).collect()
    }

    /// The path with dots between its names.
    #[must_use]
    pub fn dotted(&self) -> String {
        self.0.join(".")
    }
}

/// Why a path leads to no number.
#[derive(Debug, Clone, PartialEq, Eq)]
pub enum Astray {
    /// There is no such field; what was probably meant, in words.
    Unknown {
        /// The name that is not known, and those before it.
        path: String,
        /// What was meant.
        hint: String,
    },
    /// It leads into what has no fields.
    Within {
        /// The path of that.
        path: String,
        /// What it is.
        what: &'static str,
    },
    /// It ends at something else than a number.
    NoNumber {
        /// What that is, in words.
        what: String,
    },
}

impl fmt::Display for Astray {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Unknown { path, hint } => write!(f, "the request has no field `{path}`; {hint}"),
            Self::Within { path, what } => write!(f, "`{path}` is {what}, which has no fields"),
            Self::NoNumber { what } => write!(f, "must name a number, not {what}"),
        }
    }
}

impl Object {
    /// The number that is declared under a path.
    ///
    /// # Errors
    /// Why there is none.
    pub fn number_at(&'static self, path: &Path, hints: &Hints) -> Result<Number, Astray> {
        self.content_at(path, hints)?.number()
    }

    /// What is declared under a path.
    ///
    /// # Errors
    /// Why there is nothing.
    pub fn content_at(&'static self, path: &Path, hints: &Hints) -> Result<Content, Astray> {
        let mut content = Content::Object(self);
        let mut way = String::new();
        for name in path.names() {
            content = content.within(name, &way, hints)?;
            way = format!("{way}/{}", shortened(name));
        }
        Ok(content)
    }
}

impl Content {
    /// What is declared under a name within.
    fn within(self, name: &str, way: &str, hints: &Hints) -> Result<Self, Astray> {
        let unknown = |known: &[&str], within: &[(&'static str, Vec<&'static str>)]| {
            let hint = hints.unknown_field(name, known, within);
            Err(Astray::Unknown { path: format!("{way}/{}", shortened(name)), hint })
        };
        match self {
            Self::Object(object) => match object.fields().find(|field| field.name() == name) {
                Some(field) => Ok(field.content()),
                None => {
                    let within: Vec<_> = object.fields().map(|field| (field.name(), field.names_within())).collect();
                    unknown(&object.names(), &within)
                }
            },
            Self::Tagged(tagged) => match tagged.content_of(name) {
                Some(content) => Ok(content),
                None => unknown(&tagged.all_names(), &[]),
            },
            Self::Objects(object) => match name.parse::<usize>() {
                Ok(_) => Ok(Self::Object(object)),
                Err(_) => {
                    let hint = "a list has items, which are counted from 0".to_owned();
                    Err(Astray::Unknown { path: format!("{way}/{}", shortened(name)), hint })
                }
            },
            Self::OneOf(OneOf { of, .. }) => match of.iter().find_map(Alternative::object) {
                Some(object) => Self::Object(object).within(name, way, hints),
                None => Err(Astray::Within { path: way.to_owned(), what: "a number" }),
            },
            Self::Number(_) => Err(Astray::Within { path: way.to_owned(), what: "a number" }),
            Self::Other(what) => Err(Astray::Within { path: way.to_owned(), what }),
        }
    }

    /// The number that it may be.
    fn number(self) -> Result<Number, Astray> {
        let no_number = |what: String| Err(Astray::NoNumber { what });
        let fields = |names: &[&str]| format!("an object; its fields are {}", names.join(", "));
        match self {
            Self::Number(number) => Ok(number),
            Self::OneOf(OneOf { of, expected, .. }) => match of.iter().find_map(Alternative::number) {
                Some(number) => Ok(number),
                None => no_number(expected.to_owned()),
            },
            Self::Object(object) => no_number(fields(&object.names())),
            Self::Tagged(tagged) => no_number(fields(&tagged.all_names())),
            Self::Objects(_) => no_number("a list of objects".to_owned()),
            Self::Other(what) => no_number(what.to_owned()),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::{Alternative, Field, Flag, Label, Numbers, Objects};

    const METRES: Number = Number::new("m", 0.0, 1.0);
    const RADIUS: Field<Number> = Field::new("radius_m", "Radius.", METRES);
    const WHEEL: Object = Object { name: "Wheel", doc: "A wheel.", groups: &[&[&RADIUS]] };
    const WHEEL_FIELD: Field<&Object> = Field::new("wheel", "The wheel.", &WHEEL);
    const STATIONS: Field<Objects> = Field::new("stations", "Wheels.", Objects { object: &WHEEL, fewest: 0, most: 3 });
    const NAME: Field<Label> = Field::new("name", "A name.", Label);
    const RUT: Field<Flag> = Field::new("rut", "Whether.", Flag);
    const SLOPES: Field<OneOf> = Field::new(
        "slope_rad",
        "Slopes.",
        OneOf::new("a number or an array", &[Alternative::Number(METRES), Alternative::Numbers(Numbers::new(METRES, 1, 2))]),
    );
    const ROVER: Object = Object { name: "Rover", doc: "A rover.", groups: &[&[&WHEEL_FIELD, &STATIONS, &NAME, &RUT, &SLOPES]] };

    fn found(pointer: &str) -> Result<Number, String> {
        let path = Path::of_pointer(pointer).expect("a pointer");
        ROVER.number_at(&path, &Hints::NONE).map_err(|astray| astray.to_string())
    }

    #[test]
    fn a_path_leads_to_a_number() {
        for pointer in ["/wheel/radius_m", "/stations/2/radius_m", "/slope_rad"] {
            assert_eq!(found(pointer), Ok(METRES), "{pointer}");
        }
        let path = Path::of_dotted("wheel.radius_m").expect("a path");
        assert_eq!((path.pointer().as_str(), path.dotted().as_str()), ("/wheel/radius_m", "wheel.radius_m"));
        let odd = Path::of_pointer("/a~1b/~01").expect("a pointer");
        assert_eq!((odd.names(), odd.pointer().as_str()), (&["a/b".to_owned(), "~1".to_owned()][..], "/a~1b/~01"));
        assert_eq!((Path::of_pointer("wheel"), Path::of_pointer(&"/a".repeat(1_000_000))), (None, None));
    }

    #[test]
    fn what_is_no_number_is_told() {
        for (pointer, said) in [
            ("/wheel/raduis_m", "the request has no field `/wheel/raduis_m`; did you mean `radius_m`?"),
            ("/radius_m", "the request has no field `/radius_m`; `radius_m` belongs in `wheel`"),
            ("/wheel", "must name a number, not an object; its fields are radius_m"),
            ("/wheel/radius_m/x", "`/wheel/radius_m` is a number, which has no fields"),
            (
                "/stations/first/radius_m",
                "the request has no field `/stations/first`; a list has items, which are counted from 0",
            ),
            ("/stations", "must name a number, not a list of objects"),
            ("/name", "must name a number, not a word"),
            ("/rut/0", "`/rut` is true or false, which has no fields"),
        ] {
            assert_eq!(found(pointer), Err(said.to_owned()), "{pointer}");
        }
    }
}
