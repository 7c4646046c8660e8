//! A quantity: the name of one, or a formula of several.

use terramechanics_optimum::{Expression, MOST_CHARACTERS};
use terramechanics_reading::{Scope, Text, shortened};

use crate::words::HINTS;

/// A formula as it is sent.
pub(super) const TEXT: Text = Text { longest: MOST_CHARACTERS };

/// A formula of variables and of what the operation gives.
#[derive(Debug, Clone)]
pub(crate) struct Formula {
    /// As it was sent.
    pub(crate) text: String,
    expression: Expression,
    /// Where the value of each of its names comes from.
    sources: Vec<Source>,
}

/// Where a named value comes from.
#[derive(Debug, Clone, Copy)]
enum Source {
    Variable(usize),
    Column(usize),
}

/// The names that a formula may have.
pub(super) struct Names<'a> {
    pub(super) variables: Vec<&'a str>,
    pub(super) columns: Vec<&'static str>,
}

impl<'a> Names<'a> {
    /// All of them. A variable may be a quantity of the answer as well, such as the slip.
    fn each_once(&self) -> Vec<&'a str> {
        let columns = self.columns.iter().copied().filter(|column| !self.variables.contains(column));
        self.variables.iter().copied().chain(columns).collect()
    }
}

/// A formula whose names are not looked up yet.
#[derive(Debug, Clone)]
pub(super) struct Unresolved {
    pub(super) text: String,
    expression: Expression,
}

/// Reads a formula; what is wrong with it is reported.
pub(super) fn read(text: &str, place: &Scope<'_>) -> Option<Unresolved> {
    match Expression::new(text) {
        Ok(expression) => Some(Unresolved { text: text.to_owned(), expression }),
        Err(fault) => {
            place.fault(fault);
            None
        }
    }
}

impl Unresolved {
    /// A formula that is known to be sound.
    pub(super) fn of(text: &str) -> Option<Self> {
        Some(Self { text: text.to_owned(), expression: Expression::new(text).ok()? })
    }

    /// The formula with its names looked up; one that is not known is reported.
    pub(super) fn resolved(self, names: &Names<'_>, place: &Scope<'_>) -> Option<Formula> {
        let Self { text, expression } = self;
        let source = |name: &String| {
            let variable = names.variables.iter().position(|known| known == name).map(Source::Variable);
            let found = variable.or_else(|| names.columns.iter().position(|known| known == name).map(Source::Column));
            if found.is_none() {
                let (known, name) = (names.each_once(), shortened(name));
                match HINTS.nearest(&name, &known) {
                    Some(near) => place.fault(format_args!("unknown name `{name}`; did you mean `{near}`?")),
                    None => place.fault(format_args!(
                        "unknown name `{name}`; known are {}. A field that does not vary stands as its number",
                        known.join(", ")
                    )),
                }
            }
            found
        };
        let sources: Vec<Option<Source>> = expression.names().iter().map(source).collect();
        let sources = sources.into_iter().collect::<Option<_>>()?;
        Some(Formula { text, expression, sources })
    }
}

impl Formula {
    /// Its value with these values of the variables and of the columns; NaN where it has none.
    pub(crate) fn value(&self, variables: &[f64], columns: &[f64]) -> f64 {
        let of = |source: &Source| match *source {
            Source::Variable(place) => variables[place],
            Source::Column(place) => columns.get(place).copied().unwrap_or(f64::NAN),
        };
        let values: Vec<f64> = self.sources.iter().map(of).collect();
        let value = self.expression.value(&values);
        if value.is_finite() { value } else { f64::NAN }
    }
}
