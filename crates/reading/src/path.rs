//! The path to a field, and why one leads to no number.

use std::fmt;

use crate::hints::{Hints, shortened};

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

/// How far a look-up has come along a path.
#[derive(Clone, Copy)]
pub struct Way<'w> {
    path: &'w Path,
    passed: usize,
    hints: &'static Hints,
}

impl<'w> Way<'w> {
    /// The whole way of a path.
    #[must_use]
    pub fn of(path: &'w Path, hints: &'static Hints) -> Self {
        Self { path, passed: 0, hints }
    }

    /// The next name, and the way behind it; none at the end.
    #[must_use]
    pub fn step(self) -> Option<(&'w str, Self)> {
        let name = self.path.0.get(self.passed)?;
        Some((name, Self { passed: self.passed + 1, ..self }))
    }

    /// The path so far, as a JSON pointer.
    fn pointer(self) -> String {
        self.pointer_of(self.passed)
    }

    /// That of the first names.
    fn pointer_of(self, names: usize) -> String {
        self.path.0.iter().take(names).map(|name| format!("/{}", shortened(name))).collect()
    }

    /// That the name before is none of the `known` ones.
    pub(crate) fn unknown(self, name: &str, known: &[&str], within: &[(&'static str, Vec<&'static str>)]) -> Astray {
        let around = self.pointer_of(self.passed.saturating_sub(1));
        self.not_there(self.hints.unknown_pointer(&around, name, known, within))
    }

    /// That there is nothing of the name before.
    pub(crate) fn not_there(self, hint: String) -> Astray {
        Astray::Unknown { path: self.pointer(), hint }
    }

    /// That the way ends, or goes on, at something that is no number and has no fields.
    pub(crate) fn astray(self, what: &'static str) -> Astray {
        match self.step() {
            Some(_) => Astray::Within { path: self.pointer(), what },
            None => Astray::NoNumber { what: what.to_owned() },
        }
    }
}
