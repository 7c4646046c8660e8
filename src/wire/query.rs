//! Requests written as a query: `wheel.preset=letter&slip=0.2` stands for `{"wheel": {"preset": "letter"}, "slip": 0.2}`.
//!
//! The query becomes the same [`Field`]s that a JSON body becomes, by the same reader, so that it meets the same checks, is
//! refused with the same pointers and gives the same bits. A value that is a JSON number is a number, `true` is that, any other is a
//! string; so NaN and inf are refused wherever a number is expected. A `+` in a number is its sign, as in `1e+5`; elsewhere it is the
//! space that forms write so.

use percent_encoding::percent_decode_str;
use serde::de::value::{Error, MapDeserializer};
use serde::de::{Deserialize, Deserializer, IntoDeserializer, Visitor};

use super::{Field, Wire};

/// Parameters that a query may have: more than any request has fields.
const MOST_PARAMETERS: usize = 100;

/// Names in a row that are taken apart at dots; no request object lies deeper.
const DEEPEST: usize = 4;

/// A query, taken apart.
#[derive(Debug, Default)]
pub(crate) struct Query {
    fields: Vec<(String, Value)>,
}

/// A query with more parameters than any request has.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) struct TooManyParameters;

impl std::fmt::Display for TooManyParameters {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        write!(f, "the query may have at most {MOST_PARAMETERS} parameters")
    }
}

/// What stands for a name: the fields below it, or a text.
#[derive(Debug)]
enum Value {
    Text(String),
    Fields(Vec<(String, Value)>),
}

impl Query {
    /// The parameters of a query string, without its question mark.
    ///
    /// # Errors
    /// Where there are more than a request could have.
    pub(crate) fn parse(text: &str) -> Result<Self, TooManyParameters> {
        let mut query = Self::default();
        for (i, parameter) in text.split('&').filter(|parameter| !parameter.is_empty()).enumerate() {
            if i == MOST_PARAMETERS {
                return Err(TooManyParameters);
            }
            let (name, value) = parameter.split_once('=').unwrap_or((parameter, ""));
            let decoded = |text: &str| {
                let text = if number(text).is_some() { text.to_owned() } else { text.replace('+', " ") };
                percent_decode_str(&text).decode_utf8_lossy().into_owned()
            };
            let name = decoded(name);
            insert(&mut query.fields, &mut name.splitn(DEEPEST, '.'), decoded(value));
        }
        Ok(query)
    }

    /// Takes the parameters of that name out: the field they make, and whether there were several.
    pub(crate) fn take<T: Wire>(&mut self, name: &str) -> (Field<T>, bool) {
        let (taken, left) = std::mem::take(&mut self.fields).into_iter().partition::<Vec<_>, _>(|(found, _)| found == name);
        self.fields = left;
        let several = taken.len() > 1;
        (taken.into_iter().next().map_or(Field::Absent, |(_, value)| read(value)), several)
    }

    /// The names of the parameters, each the first of its path.
    pub(crate) fn names(&self) -> impl Iterator<Item = &str> {
        self.fields.iter().map(|(name, _)| name.as_str())
    }

    /// The request object that the query stands for.
    pub(crate) fn read<T: Wire>(self) -> Field<T> {
        read(Value::Fields(self.fields))
    }
}

/// Puts a text under a path of names. A repeated one stands twice, which the reader of the object reports.
fn insert<'a>(fields: &mut Vec<(String, Value)>, names: &mut impl Iterator<Item = &'a str>, text: String) {
    let mut fields = fields;
    let mut names = names.peekable();
    while let Some(name) = names.next() {
        if names.peek().is_none() {
            fields.push((name.to_owned(), Value::Text(text)));
            return;
        }
        let known = fields.iter().position(|(found, value)| found == name && matches!(value, Value::Fields(_)));
        let at = known.unwrap_or_else(|| {
            fields.push((name.to_owned(), Value::Fields(Vec::new())));
            fields.len() - 1
        });
        let Value::Fields(below) = &mut fields[at].1 else { return };
        fields = below;
    }
}

fn read<T: Wire>(value: Value) -> Field<T> {
    // Nothing in a query can fail to be read: what has the wrong type becomes `Field::Wrong`.
    Field::deserialize(value).unwrap_or(Field::Wrong("unreadable".into()))
}

impl<'de> IntoDeserializer<'de, Error> for Value {
    type Deserializer = Self;

    fn into_deserializer(self) -> Self {
        self
    }
}

impl<'de> Deserializer<'de> for Value {
    type Error = Error;

    fn deserialize_any<V: Visitor<'de>>(self, visitor: V) -> Result<V::Value, Error> {
        match self {
            Self::Text(text) => match number(&text) {
                Some(number) => visitor.visit_f64(number),
                None if text == "true" => visitor.visit_bool(true),
                None => visitor.visit_bytes(text.as_bytes()),
            },
            Self::Fields(fields) => visitor.visit_map(MapDeserializer::new(fields.into_iter())),
        }
    }

    serde::forward_to_deserialize_any! {
        bool i8 i16 i32 i64 i128 u8 u16 u32 u64 u128 f32 f64 char str string bytes byte_buf option unit unit_struct
        newtype_struct seq tuple tuple_struct map struct enum identifier ignored_any
    }
}

/// The number, if the text is one as JSON writes it (RFC 8259, section 6).
pub(crate) fn number(text: &str) -> Option<f64> {
    let digits = |text: &str| !text.is_empty() && text.bytes().all(|byte| byte.is_ascii_digit());
    let unsigned = text.strip_prefix('-').unwrap_or(text);
    let (mantissa, exponent) = unsigned.split_once(['e', 'E']).map_or((unsigned, None), |(left, right)| (left, Some(right)));
    let (whole, fraction) = mantissa.split_once('.').map_or((mantissa, None), |(left, right)| (left, Some(right)));
    let is_json = digits(whole)
        && (whole == "0" || !whole.starts_with('0'))
        && fraction.is_none_or(digits)
        && exponent.is_none_or(|exponent| digits(exponent.strip_prefix(['+', '-']).unwrap_or(exponent)));
    if is_json { text.parse().ok() } else { None }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_number_is_what_json_calls_one_with_the_same_bits() {
        for text in ["0", "-0", "0.478", "-660", "1e5", "1E+5", "1.5e-300", "123456789012345678901", "4.35e-5", "0.1e1"] {
            let json: f64 = serde_json::from_str(text).expect("a number");
            assert_eq!(number(text).map(f64::to_bits), Some(json.to_bits()), "{text}");
        }
        for text in [
            "", "-", "+1", "01", ".5", "1.", "1e", "1e+", "0x10", "NaN", "inf", "-inf", "Infinity", "1_000", " 1", "1 ", "1,5",
            "١",
        ] {
            assert!(
                number(text).is_none() && serde_json::from_str::<f64>(text.trim_matches(' ')).is_err() | text.contains(' '),
                "{text}"
            );
        }
    }

    #[test]
    fn names_are_taken_apart_at_dots_to_a_bounded_depth() {
        let query = Query::parse("a.b.c.d.e.f=1&a.b.x=2&%61.y=%C3%A4&&z").expect("few parameters");
        let text = format!("{query:?}");
        for part in ["\"d.e.f\", Text(\"1\")", "\"x\", Text(\"2\")", "\"y\", Text(\"ä\")", "\"z\", Text(\"\")"] {
            assert!(text.contains(part), "{part} in {text}");
        }
        assert_eq!(text.matches("\"a\"").count(), 1, "{text}");
    }

    #[test]
    fn a_plus_is_a_space_except_in_a_number() {
        let text = format!("{:?}", Query::parse("kind=lunar+simulant&x=1e+5&y=a%2Bb").expect("few parameters"));
        for part in ["\"lunar simulant\"", "\"1e+5\"", "\"a+b\""] {
            assert!(text.contains(part), "{part} in {text}");
        }
    }

    #[test]
    fn a_query_of_too_many_parameters_is_refused() {
        let text = |count: usize| vec!["a=1"; count].join("&");
        assert!(Query::parse(&text(MOST_PARAMETERS)).is_ok());
        assert_eq!(Query::parse(&text(MOST_PARAMETERS + 1)).err(), Some(TooManyParameters));
    }
}
