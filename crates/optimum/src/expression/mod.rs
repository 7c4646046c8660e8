//! A formula in words of a user: `2700 * 0.002 * 2 * pi * radius_m * width_m`.
//!
//! Sums, products, powers, brackets, a few functions and named values, read as an engineer writes them: a power binds before a
//! sign and from the right, so that `-2^2` is -4 and `2^3^2` is 512, and numbers may have an exponent (`2e-3`).

mod parser;

use std::fmt;

use parser::Parser;

/// Most characters of a formula.
pub const MOST_CHARACTERS: usize = 500;

/// Most brackets, signs and powers within each other.
pub const MOST_NESTING: usize = 16;

/// A formula.
#[derive(Debug, Clone)]
pub struct Expression {
    /// In the order in which they are worked off, each on the results of those before.
    steps: Vec<Step>,
    names: Vec<String>,
}

/// What is wrong with a formula.
#[derive(Debug, Clone, PartialEq, Eq)]
pub enum ExpressionFault {
    /// It is longer than [`MOST_CHARACTERS`].
    TooLong,
    /// It has more than [`MOST_NESTING`] brackets, signs or powers within each other.
    TooDeep,
    /// It ends where a value is due.
    EndsEarly,
    /// Something is there that does not belong there.
    Unexpected {
        /// What is there.
        found: String,
        /// Characters before it.
        at: usize,
    },
    /// A function of that name is not known.
    NoFunction(String),
    /// A function has another number of arguments.
    Arguments {
        /// The function.
        function: &'static str,
        /// How many it has.
        takes: usize,
    },
}

/// A function of one argument.
type OfOne = fn(f64) -> f64;

/// An operator, or a function of two arguments.
type OfTwo = fn(f64, f64) -> f64;

/// One step of the work.
#[derive(Debug, Clone, Copy)]
enum Step {
    Number(f64),
    /// A named value, by its place.
    Value(usize),
    Negative,
    Of(OfOne),
    Both(OfTwo),
}

impl Expression {
    /// Reads a formula.
    ///
    /// # Errors
    /// The first fault.
    ///
    /// ```
    /// # use terramechanics_optimum::Expression;
    /// let mass = Expression::new("2 * radius_m^2 - 1")?;
    /// assert_eq!(mass.names(), ["radius_m"]);
    /// assert_eq!(mass.value(&[3.0]), 17.0);
    /// # Ok::<(), terramechanics_optimum::ExpressionFault>(())
    /// ```
    pub fn new(formula: &str) -> Result<Self, ExpressionFault> {
        if formula.chars().count() > MOST_CHARACTERS {
            return Err(ExpressionFault::TooLong);
        }
        let (steps, names) = Parser::new(formula).whole()?;
        Ok(Self { steps, names })
    }

    /// What a word means in every formula, such as `a constant` for `pi`: no value can have it as its name.
    ///
    /// ```
    /// # use terramechanics_optimum::Expression;
    /// assert_eq!(Expression::own_meaning("sqrt"), Some("a function"));
    /// assert_eq!(Expression::own_meaning("radius_m"), None);
    /// ```
    #[must_use]
    pub fn own_meaning(word: &str) -> Option<&'static str> {
        parser::own_meaning(word)
    }

    /// The names of its values, each once, as they appear.
    #[must_use]
    pub fn names(&self) -> &[String] {
        &self.names
    }

    /// Its value where the named values are these, in the order of the names; NaN where one is missing, infinite or NaN where the
    /// formula has no value.
    #[must_use]
    pub fn value(&self, values: &[f64]) -> f64 {
        let mut results: Vec<f64> = Vec::with_capacity(self.steps.len());
        let missing = f64::NAN;
        for step in &self.steps {
            let result = match *step {
                Step::Number(number) => number,
                Step::Value(place) => values.get(place).copied().unwrap_or(missing),
                Step::Negative => -results.pop().unwrap_or(missing),
                Step::Of(function) => function(results.pop().unwrap_or(missing)),
                Step::Both(function) => {
                    let second = results.pop().unwrap_or(missing);
                    function(results.pop().unwrap_or(missing), second)
                }
            };
            results.push(result);
        }
        results.pop().unwrap_or(missing)
    }
}

impl fmt::Display for ExpressionFault {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::TooLong => write!(f, "must have at most {MOST_CHARACTERS} characters"),
            Self::TooDeep => write!(f, "must have at most {MOST_NESTING} brackets, signs and powers within each other"),
            Self::EndsEarly => f.write_str("ends where a value is due"),
            Self::Unexpected { found, at } => write!(f, "has `{found}` at character {} where it does not belong", at + 1),
            Self::NoFunction(name) => write!(f, "has `{name}`, which is no function; there are {}", parser::functions()),
            Self::Arguments { function, takes: 1 } => write!(f, "gives `{function}` other than one argument"),
            Self::Arguments { function, takes } => write!(f, "gives `{function}` other than {takes} arguments"),
        }
    }
}

impl std::error::Error for ExpressionFault {}

#[cfg(test)]
mod tests;
