//! Requests written as a query: `wheel.radius_m=0.2&slip=0.2` stands for `{"wheel": {"radius_m": 0.2}, "slip": 0.2}`.
//!
//! The query becomes the same tree that a JSON body becomes, so that it meets the same checks, is refused with the same pointers
//! and gives the same bits. A value that is a JSON number is a number, `true` is that, any other is a text; so NaN and inf are
//! refused wherever a number is expected. A `+` in a number is its sign, as in `1e+5`; elsewhere it is the space that forms write
//! so.

use std::borrow::Cow;
use std::fmt;

use percent_encoding::percent_decode_str;

use crate::literal::number;
use crate::node::{Fields, Node};

/// Parameters that a query may have: more than any request has fields.
const MOST_PARAMETERS: usize = 100;

/// Names in a row that are taken apart at dots; no request object lies deeper.
const DEEPEST: usize = 4;

/// A query, taken apart.
#[derive(Debug, Default)]
pub struct Query<'a>(Fields<'a>);

/// A query with more parameters than any request has.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct TooManyParameters;

impl fmt::Display for TooManyParameters {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "the query may have at most {MOST_PARAMETERS} parameters")
    }
}

impl std::error::Error for TooManyParameters {}

impl<'a> Query<'a> {
    /// The parameters of a query string, without its question mark.
    ///
    /// # Errors
    /// Where there are more than a request could have.
    pub fn parse(text: &'a str) -> Result<Self, TooManyParameters> {
        let mut query = Self::default();
        for (i, parameter) in text.split('&').filter(|parameter| !parameter.is_empty()).enumerate() {
            if i == MOST_PARAMETERS {
                return Err(TooManyParameters);
            }
            let (name, value) = parameter.split_once('=').unwrap_or((parameter, ""));
            let value = match number(value) {
                Some(number) => Node::Number(number),
                None => value_of(decoded(value)),
            };
            insert(&mut query.0, decoded(name), value);
        }
        Ok(query)
    }

    /// Takes the parameters of that name out: the first, and whether there were several.
    pub fn take(&mut self, name: &str) -> (Option<Node<'a>>, bool) {
        let (taken, left): (Vec<_>, Vec<_>) = std::mem::take(&mut self.0.0).into_iter().partition(|(found, _)| found == name);
        self.0.0 = left;
        let several = taken.len() > 1;
        (taken.into_iter().next().map(|(_, value)| value), several)
    }

    /// The names of the parameters, each the first of its path.
    pub fn names(&self) -> impl Iterator<Item = &str> {
        self.0.iter().map(|(name, _)| name)
    }

    /// The object that the query stands for.
    #[must_use]
    pub fn into_node(self) -> Node<'a> {
        Node::Object(self.0)
    }
}

impl<'a> Node<'a> {
    /// What a text stands for where all values are texts, as in a query or a table: a number as JSON writes it, `true`, or itself.
    #[must_use]
    pub fn of_text(text: Cow<'a, str>) -> Self {
        value_of(text)
    }
}

fn value_of(text: Cow<'_, str>) -> Node<'_> {
    match number(&text) {
        Some(number) => Node::Number(number),
        None if text == "true" => Node::Flag(true),
        None => Node::Parameter(text),
    }
}

fn decoded(text: &str) -> Cow<'_, str> {
    match text.contains('+') {
        true => Cow::Owned(percent_decode_str(&text.replace('+', " ")).decode_utf8_lossy().into_owned()),
        false => percent_decode_str(text).decode_utf8_lossy(),
    }
}

/// Puts a value under a path of names. A repeated one stands twice, which the reader of the object reports.
fn insert<'a>(fields: &mut Fields<'a>, path: Cow<'a, str>, value: Node<'a>) {
    let names: Vec<Cow<'a, str>> = match path {
        Cow::Borrowed(path) => path.splitn(DEEPEST, '.').map(Cow::Borrowed).collect(),
        Cow::Owned(path) => path.splitn(DEEPEST, '.').map(|name| Cow::Owned(name.to_owned())).collect(),
    };
    let last = names.len().saturating_sub(1);
    let mut fields = fields;
    let mut value = Some(value);
    for (i, name) in names.into_iter().enumerate() {
        if i == last {
            fields.0.extend(value.take().map(|value| (name, value)));
            return;
        }
        let known = fields.0.iter().position(|(found, value)| *found == name && matches!(value, Node::Object(_)));
        let at = known.unwrap_or_else(|| {
            fields.0.push((name, Node::Object(Fields::default())));
            fields.0.len() - 1
        });
        let Some((_, Node::Object(below))) = fields.0.get_mut(at) else { return };
        fields = below;
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn names_are_taken_apart_at_dots_to_a_bounded_depth() {
        let query = Query::parse("a.b.c.d.e.f=1&a.b.x=u&%61.y=%C3%A4&&z").expect("few parameters");
        let text = format!("{query:?}");
        for part in ["\"d.e.f\", Number(1.0)", "\"x\", Parameter(\"u\")", "\"y\", Parameter(\"ä\")", "\"z\", Parameter(\"\")"] {
            assert!(text.contains(part), "{part} in {text}");
        }
        assert_eq!(text.matches("\"a\"").count(), 1, "{text}");
    }

    #[test]
    fn a_plus_is_a_space_except_in_a_number() {
        let text = format!("{:?}", Query::parse("kind=lunar+simulant&x=1e+5&y=a%2Bb&z=1e%2B5").expect("few parameters"));
        for part in ["\"lunar simulant\"", "\"x\", Number(100000.0)", "\"a+b\"", "\"z\", Number(100000.0)"] {
            assert!(text.contains(part), "{part} in {text}");
        }
    }

    #[test]
    fn a_query_of_too_many_parameters_is_refused() {
        let text = |count: usize| vec!["a=1"; count].join("&");
        assert!(Query::parse(&text(MOST_PARAMETERS)).is_ok());
        assert_eq!(Query::parse(&text(MOST_PARAMETERS + 1)).err(), Some(TooManyParameters));
    }

    #[test]
    fn a_parameter_is_taken_out_with_its_repetitions() {
        let mut query = Query::parse("format=csv&slip=0.2&format=json").expect("few parameters");
        assert_eq!(query.take("format"), (Some(Node::Parameter("csv".into())), true));
        assert_eq!(query.names().collect::<Vec<_>>(), ["slip"]);
        assert_eq!(query.take("format"), (None, false));
    }

    #[test]
    fn nothing_that_is_sent_panics() {
        for odd in ["=", "&&&", "..=..", "%=%", "%ff=%fe", "a.=1&.a=2", "?slip=1", "a=1&a.b=2&a=3", ".", "....=", "=.="] {
            assert!(matches!(Query::parse(odd).expect("few parameters").into_node(), Node::Object(_)), "{odd}");
        }
    }
}
