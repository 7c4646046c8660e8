//! Reads a formula by recursive descent. The depth is counted, so that no formula exhausts the stack.

use super::{ExpressionFault, MOST_NESTING, OfOne, OfTwo, Step};

/// Functions of one argument.
const OF_ONE: [(&str, OfOne); 8] = [
    ("sqrt", f64::sqrt),
    ("exp", f64::exp),
    ("ln", f64::ln),
    ("abs", f64::abs),
    ("sin", f64::sin),
    ("cos", f64::cos),
    ("tan", f64::tan),
    ("atan", f64::atan),
];

/// Functions of two.
const OF_TWO: [(&str, OfTwo); 2] = [("min", least), ("max", most)];

/// The least of both; not a number where one is none.
fn least(a: f64, b: f64) -> f64 {
    if a.is_nan() || b.is_nan() { f64::NAN } else { a.min(b) }
}

/// The largest of both; not a number where one is none.
fn most(a: f64, b: f64) -> f64 {
    if a.is_nan() || b.is_nan() { f64::NAN } else { a.max(b) }
}

/// The circle constant by its name.
const PI: &str = "pi";

/// What a word means by itself: no value can have it as its name.
pub(super) fn own_meaning(word: &str) -> Option<&'static str> {
    let is_function = OF_ONE.iter().any(|(name, _)| *name == word) || OF_TWO.iter().any(|(name, _)| *name == word);
    match word {
        PI => Some("a constant"),
        _ if is_function => Some("a function"),
        _ => None,
    }
}

/// All functions, in words.
pub(super) fn functions() -> String {
    let names = OF_ONE.iter().map(|(name, _)| *name).chain(OF_TWO.iter().map(|(name, _)| *name));
    names.map(|name| format!("`{name}`")).collect::<Vec<_>>().join(", ")
}

type Read<T = ()> = Result<T, ExpressionFault>;

pub(super) struct Parser<'f> {
    formula: &'f str,
    /// Bytes read so far.
    at: usize,
    depth: usize,
    steps: Vec<Step>,
    names: Vec<String>,
}

impl<'f> Parser<'f> {
    pub(super) fn new(formula: &'f str) -> Self {
        Self { formula, at: 0, depth: 0, steps: Vec::new(), names: Vec::new() }
    }

    /// The steps of the whole formula, and the names in it.
    pub(super) fn whole(mut self) -> Read<(Vec<Step>, Vec<String>)> {
        self.sum()?;
        match self.peek() {
            None => Ok((self.steps, self.names)),
            Some(_) => Err(self.unexpected()),
        }
    }

    fn sum(&mut self) -> Read {
        self.product()?;
        loop {
            let operator: OfTwo = match self.peek() {
                Some('+') => |a, b| a + b,
                Some('-') => |a, b| a - b,
                _ => return Ok(()),
            };
            self.skip();
            self.product()?;
            self.steps.push(Step::Both(operator));
        }
    }

    fn product(&mut self) -> Read {
        self.signed()?;
        loop {
            let operator: OfTwo = match self.peek() {
                Some('*') => |a, b| a * b,
                Some('/') => |a, b| a / b,
                _ => return Ok(()),
            };
            self.skip();
            self.signed()?;
            self.steps.push(Step::Both(operator));
        }
    }

    fn signed(&mut self) -> Read {
        match self.peek() {
            Some('-') => {
                self.skip();
                self.within(Self::signed)?;
                self.steps.push(Step::Negative);
                Ok(())
            }
            Some('+') => {
                self.skip();
                self.within(Self::signed)
            }
            _ => self.power(),
        }
    }

    fn power(&mut self) -> Read {
        self.value()?;
        if self.peek() == Some('^') {
            self.skip();
            self.within(Self::signed)?;
            self.steps.push(Step::Both(f64::powf));
        }
        Ok(())
    }

    fn value(&mut self) -> Read {
        match self.peek() {
            None => Err(ExpressionFault::EndsEarly),
            Some('(') => {
                self.skip();
                self.within(Self::sum)?;
                self.expect(')')
            }
            Some(c) if c.is_ascii_digit() || c == '.' => self.number(),
            Some(c) if is_of_name(c) => {
                let name = self.take(|c| is_of_name(c) || c.is_ascii_digit());
                if self.peek() == Some('(') {
                    self.skip();
                    return self.function(name);
                }
                if name == PI {
                    self.steps.push(Step::Number(std::f64::consts::PI));
                    return Ok(());
                }
                let known = self.names.iter().position(|known| known == name);
                let place = known.unwrap_or_else(|| {
                    self.names.push(name.to_owned());
                    self.names.len() - 1
                });
                self.steps.push(Step::Value(place));
                Ok(())
            }
            Some(_) => Err(self.unexpected()),
        }
    }

    fn number(&mut self) -> Read {
        let start = self.at;
        self.take(|c| c.is_ascii_digit() || c == '.');
        let mut ahead = self.rest().chars().peekable();
        if ahead.next_if(|c| matches!(c, 'e' | 'E')).is_some() {
            let sign = usize::from(ahead.next_if(|c| matches!(c, '+' | '-')).is_some());
            if ahead.next_if(char::is_ascii_digit).is_some() {
                self.at += 1 + sign;
                self.take(|c| c.is_ascii_digit());
            }
        }
        let text = &self.formula[start..self.at];
        match text.parse::<f64>() {
            Ok(number) if number.is_finite() => {
                self.steps.push(Step::Number(number));
                Ok(())
            }
            _ => Err(ExpressionFault::Unexpected { found: text.chars().take(20).collect(), at: self.characters(start) }),
        }
    }

    /// The arguments of a function and its bracket.
    fn function(&mut self, name: &str) -> Read {
        if let Some(&(_, function)) = OF_ONE.iter().find(|(known, _)| *known == name) {
            self.within(Self::sum)?;
            self.close(name, 1)?;
            self.steps.push(Step::Of(function));
        } else if let Some(&(known, function)) = OF_TWO.iter().find(|(known, _)| *known == name) {
            self.within(Self::sum)?;
            if self.peek() != Some(',') {
                return Err(ExpressionFault::Arguments { function: known, takes: 2 });
            }
            self.skip();
            self.within(Self::sum)?;
            self.close(name, 2)?;
            self.steps.push(Step::Both(function));
        } else {
            return Err(ExpressionFault::NoFunction(name.chars().take(40).collect()));
        }
        Ok(())
    }

    /// The bracket that closes the arguments.
    fn close(&mut self, name: &str, takes: usize) -> Read {
        let known =
            OF_ONE.iter().map(|(known, _)| *known).chain(OF_TWO.iter().map(|(known, _)| *known)).find(|known| *known == name);
        match (self.peek(), known) {
            (Some(','), Some(function)) => Err(ExpressionFault::Arguments { function, takes }),
            _ => self.expect(')'),
        }
    }

    fn within(&mut self, read: fn(&mut Self) -> Read) -> Read {
        if self.depth == MOST_NESTING {
            return Err(ExpressionFault::TooDeep);
        }
        self.depth += 1;
        read(self)?;
        self.depth -= 1;
        Ok(())
    }

    fn expect(&mut self, due: char) -> Read {
        match self.peek() {
            Some(c) if c == due => {
                self.skip();
                Ok(())
            }
            Some(_) => Err(self.unexpected()),
            None => Err(ExpressionFault::EndsEarly),
        }
    }

    /// The next character behind blanks.
    fn peek(&mut self) -> Option<char> {
        self.take(char::is_whitespace);
        self.rest().chars().next()
    }

    fn skip(&mut self) {
        self.at += self.rest().chars().next().map_or(0, char::len_utf8);
    }

    fn take(&mut self, belongs: impl Fn(char) -> bool) -> &'f str {
        let rest = self.rest();
        let taken = &rest[..rest.find(|c| !belongs(c)).unwrap_or(rest.len())];
        self.at += taken.len();
        taken
    }

    fn rest(&self) -> &'f str {
        &self.formula[self.at..]
    }

    fn characters(&self, bytes: usize) -> usize {
        self.formula[..bytes].chars().count()
    }

    fn unexpected(&self) -> ExpressionFault {
        ExpressionFault::Unexpected { found: self.rest().chars().take(1).collect(), at: self.characters(self.at) }
    }
}

fn is_of_name(c: char) -> bool {
    c.is_ascii_alphabetic() || c == '_'
}
