//! Columns of an answer: named as the table has them, null where there is no value.

use std::borrow::Cow;
use std::marker::PhantomData;

use serde::ser::{SerializeMap, SerializeSeq};
use serde::{Serialize, Serializer};
use utoipa::openapi::{RefOr, Schema};
use utoipa::{PartialSchema, ToSchema};

use super::About;
use super::schema::{Field, object_of};

/// The values of a column.
#[derive(Debug, Clone, PartialEq)]
pub(crate) enum Values {
    /// Numbers; NaN in memory, null on the wire, where there is none.
    Numbers(Vec<f64>),
    Words(Vec<&'static str>),
}

impl Values {
    /// The numbers; of words there are none.
    pub(crate) fn numbers(&self) -> &[f64] {
        match self {
            Self::Numbers(values) => values,
            Self::Words(_) => &[],
        }
    }
}

impl Serialize for Values {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        match self {
            Self::Words(words) => words.serialize(serializer),
            Self::Numbers(values) => {
                let mut list = serializer.serialize_seq(Some(values.len()))?;
                for &value in values {
                    list.serialize_element(&value.is_finite().then_some(value))?;
                }
                list.end()
            }
        }
    }
}

/// Which columns an answer has, for the contract.
pub(crate) trait Shape {
    /// Name of the schema.
    const NAME: &'static str;
    /// What holds for all columns.
    const DOC: &'static str;

    /// The columns that there may be.
    fn fields() -> Vec<Field>;
}

/// Columns of one length in the shape `S`.
#[derive(Debug, Clone)]
pub(crate) struct Columns<S> {
    list: Vec<(&'static About, Values)>,
    shape: PhantomData<fn() -> S>,
}

impl<S> Columns<S> {
    pub(crate) fn new(list: Vec<(&'static About, Values)>) -> Self {
        Self { list, shape: PhantomData }
    }

    /// Columns of numbers, each under the row of `about` in its place.
    pub(crate) fn of_numbers<const N: usize>(about: &'static [About; N], columns: [Vec<f64>; N]) -> Self {
        Self::new(about.iter().zip(columns.map(Values::Numbers)).collect())
    }

    /// The numbers under each name.
    pub(crate) fn named(&self) -> impl Iterator<Item = (&'static str, &[f64])> {
        self.list.iter().map(|(about, values)| (about.name, values.numbers()))
    }

    /// The same as an answer's columns.
    pub(crate) fn as_table(&self) -> Vec<(Cow<'static, str>, &[f64])> {
        self.named().map(|(name, values)| (name.into(), values)).collect()
    }

    /// The column of that name, if it is there.
    pub(crate) fn get(&self, name: &str) -> Option<&[f64]> {
        self.named().find(|(known, _)| *known == name).map(|(_, values)| values)
    }
}

impl<S> Serialize for Columns<S> {
    fn serialize<R: Serializer>(&self, serializer: R) -> Result<R::Ok, R::Error> {
        let mut map = serializer.serialize_map(Some(self.list.len()))?;
        for (about, values) in &self.list {
            map.serialize_entry(about.name, values)?;
        }
        map.end()
    }
}

impl<S: Shape> PartialSchema for Columns<S> {
    fn schema() -> RefOr<Schema> {
        object_of(S::DOC, &S::fields(), Field::column).into()
    }
}

impl<S: Shape> ToSchema for Columns<S> {
    fn name() -> Cow<'static, str> {
        S::NAME.into()
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn no_value_is_null() {
        static ABOUT: [About; 2] = [About::new("slip", "s", "1", "slip ratio"), About::new("torque_n_m", "T", "N.m", "torque")];
        let columns = Columns::<()>::of_numbers(&ABOUT, [vec![0.0, 1.0], vec![f64::NAN, f64::INFINITY]]);
        assert_eq!(serde_json::to_string(&columns).expect("JSON"), "{\"slip\":[0.0,1.0],\"torque_n_m\":[null,null]}");
        assert_eq!(columns.get("slip"), Some(&[0.0, 1.0][..]));
    }
}
