//! Columns of numbers, pairs of bounds and lists of names.

use serde::de::SeqAccess;
use utoipa::openapi::schema::{ArrayBuilder, OneOfBuilder};
use utoipa::openapi::{RefOr, Schema};

use super::list::items;
use super::{Choice, Entry, Field, Number, Scope, Spec, Wire, unknown_word};

/// A column of numbers as it was sent, with one more than any column may have at most.
#[derive(Debug, Clone, Default)]
pub(crate) struct Series(Vec<Field<f64>>);

/// What a column may hold.
#[derive(Debug)]
pub(crate) struct SeriesSpec {
    pub(crate) doc: &'static str,
    pub(crate) number: Number,
    pub(crate) fewest: usize,
    pub(crate) required: bool,
}

/// Numbers that any column has at most.
pub(crate) const MOST_NUMBERS: usize = 10_001;

/// Faults of one column that are listed; the others are counted.
const MOST_FAULTS: usize = 10;

impl SeriesSpec {
    /// Its schema, yet without a description.
    pub(crate) fn array(&self) -> ArrayBuilder {
        ArrayBuilder::new().items(self.number.schema()).min_items(Some(self.fewest)).max_items(Some(MOST_NUMBERS))
    }

    /// The numbers of a column, if all are numbers within the bounds.
    pub(crate) fn check(&self, place: &Scope<'_>, series: &Series) -> Option<Vec<f64>> {
        let Series(items) = series;
        if !(self.fewest..=MOST_NUMBERS).contains(&items.len()) {
            place.fault(format_args!("must have from {} to {MOST_NUMBERS} numbers", self.fewest));
            return None;
        }
        let mut faults = 0;
        let mut values = Vec::with_capacity(items.len());
        for (i, item) in items.iter().enumerate() {
            let listed = faults < MOST_FAULTS;
            let value = match item {
                Field::Given(value) if listed => self.number.check(&place.item(i), *value),
                Field::Given(value) => self.number.allows(*value).then_some(*value),
                Field::Wrong(found) => {
                    if listed {
                        place.item(i).fault(format_args!("must be a number, not {found}"));
                    }
                    None
                }
                Field::Absent => None,
            };
            match value {
                Some(value) => values.push(value),
                None => faults += 1,
            }
        }
        if faults > MOST_FAULTS {
            place.fault(format_args!("has {} more such faults", faults - MOST_FAULTS));
        }
        (faults == 0).then_some(values)
    }
}

impl Spec for SeriesSpec {
    fn schema(&self) -> RefOr<Schema> {
        self.array().description(Some(self.doc)).into()
    }

    fn is_required(&self) -> bool {
        self.required
    }
}

impl Wire for Series {
    type Spec = SeriesSpec;
    const EXPECTED: &'static str = "an array of numbers";

    fn list<'de, A: SeqAccess<'de>>(mut list: A) -> Result<Option<Self>, A::Error> {
        items(&mut list, MOST_NUMBERS).map(Self).map(Some)
    }
}

impl Entry<'_, Series> {
    /// The numbers, if any were sent and all are within the bounds.
    pub(crate) fn numbers(&self, object: &Scope<'_>) -> Option<Vec<f64>> {
        self.given(object).and_then(|series| self.spec.check(&object.field(self.name), series))
    }

    /// The numbers; that none were sent is reported.
    pub(crate) fn required_numbers(&self, object: &Scope<'_>) -> Option<Vec<f64>> {
        self.required(object).and_then(|series| self.spec.check(&object.field(self.name), series))
    }
}

/// One number for all of a column, or a column of its own.
#[derive(Debug, Clone)]
pub(crate) enum Each {
    One(f64),
    All(Series),
}

/// What is allowed for a number or each number of a column.
#[derive(Debug)]
pub(crate) struct EachSpec(pub(crate) SeriesSpec);

impl Spec for EachSpec {
    fn schema(&self) -> RefOr<Schema> {
        let SeriesSpec { doc, number, .. } = &self.0;
        OneOfBuilder::new().description(Some(*doc)).item(number.schema()).item(self.0.array()).into()
    }
}

impl Wire for Each {
    type Spec = EachSpec;
    const EXPECTED: &'static str = "a number or an array of numbers";

    fn number(value: f64) -> Option<Self> {
        Some(Self::One(value))
    }

    fn list<'de, A: SeqAccess<'de>>(list: A) -> Result<Option<Self>, A::Error> {
        Ok(Series::list(list)?.map(Self::All))
    }
}

impl Entry<'_, Each> {
    /// A number for each of `count`, if any were sent and all are within the bounds.
    pub(crate) fn for_each_of(&self, object: &Scope<'_>, count: usize) -> Option<Vec<f64>> {
        let place = object.field(self.name);
        match self.given(object)? {
            Each::One(value) => self.spec.0.number.check(&place, *value).map(|value| vec![value; count]),
            Each::All(series) => {
                let values = self.spec.0.check(&place, series)?;
                if values.len() != count {
                    place.fault(format_args!("has {} values where the data have {count}", values.len()));
                    return None;
                }
                Some(values)
            }
        }
    }
}

/// A lower and an upper bound as they were sent.
#[derive(Debug, Clone)]
pub(crate) struct Pair(Vec<Field<f64>>);

/// What both bounds may be.
#[derive(Debug)]
pub(crate) struct PairSpec(pub(crate) Number);

impl Spec for PairSpec {
    fn schema(&self) -> RefOr<Schema> {
        ArrayBuilder::new()
            .description(Some("The lower and the upper bound."))
            .items(self.0.schema())
            .min_items(Some(2))
            .max_items(Some(2))
            .into()
    }
}

impl Wire for Pair {
    type Spec = PairSpec;
    const EXPECTED: &'static str = "an array of a lower and an upper bound";

    fn list<'de, A: SeqAccess<'de>>(mut list: A) -> Result<Option<Self>, A::Error> {
        items(&mut list, 2).map(Self).map(Some)
    }
}

impl Entry<'_, Pair> {
    /// Both bounds, if they were sent, the lower below the upper.
    pub(crate) fn bounds(&self, object: &Scope<'_>) -> Option<[f64; 2]> {
        let place = object.field(self.name);
        let Pair(items) = self.given(object)?;
        let [lower, upper] = items.as_slice() else {
            place.fault("must have two numbers, the lower and the upper bound");
            return None;
        };
        let number = |item: &Field<f64>, i: usize| match item {
            Field::Given(value) => self.spec.0.check(&place.item(i), *value),
            Field::Wrong(found) => {
                place.item(i).fault(format_args!("must be a number, not {found}"));
                None
            }
            Field::Absent => None,
        };
        let (lower, upper) = (number(lower, 0), number(upper, 1));
        let (lower, upper) = (lower?, upper?);
        if lower >= upper {
            place.fault("the lower bound must be below the upper bound");
            return None;
        }
        Some([lower, upper])
    }
}

/// Names as they were sent.
#[derive(Debug, Clone)]
pub(crate) struct Names(Vec<Field<String>>);

/// Different words out of a closed list, at least one.
#[derive(Debug)]
pub(crate) struct NamesSpec {
    pub(crate) doc: &'static str,
    pub(crate) word: Choice,
    pub(crate) most: usize,
    /// Whether a list that is left out names all the words; else it has to be there.
    pub(crate) all_unless_given: bool,
}

/// Names that any list has at most.
const MOST_NAMES: usize = 64;

impl Spec for NamesSpec {
    fn schema(&self) -> RefOr<Schema> {
        ArrayBuilder::new()
            .description(Some(self.doc))
            .items(self.word.schema())
            .min_items(Some(1))
            .max_items(Some(self.most))
            .unique_items(true)
            .default(self.all_unless_given.then(|| (self.word.words)().into()))
            .into()
    }

    fn is_required(&self) -> bool {
        !self.all_unless_given
    }
}

impl Wire for Names {
    type Spec = NamesSpec;
    const EXPECTED: &'static str = "an array of names";

    fn list<'de, A: SeqAccess<'de>>(mut list: A) -> Result<Option<Self>, A::Error> {
        items(&mut list, MOST_NAMES).map(Self).map(Some)
    }
}

impl Entry<'_, Names> {
    /// What `lookup` makes of the names, with their places in the list, known and all different.
    pub(crate) fn looked_up<T: PartialEq>(&self, object: &Scope<'_>, lookup: impl Fn(&str) -> Option<T>) -> Option<Vec<T>> {
        if !self.is_present() && self.spec.all_unless_given {
            return (self.spec.word.words)().into_iter().map(lookup).collect();
        }
        let Names(names) = self.required(object)?;
        let list = object.field(self.name);
        if !(1..=self.spec.most).contains(&names.len()) {
            list.fault(format_args!("must have from 1 to {} names", self.spec.most));
            return None;
        }
        let mut found: Vec<T> = Vec::new();
        for (i, name) in names.iter().enumerate() {
            let item = list.item(i);
            match name {
                Field::Given(name) => match lookup(name) {
                    Some(known) if found.contains(&known) => item.fault("is named more than once"),
                    Some(known) => found.push(known),
                    None => unknown_word(&item, name, &(self.spec.word.words)()),
                },
                Field::Wrong(kind) => item.fault(format_args!("must be a string, not {kind}")),
                Field::Absent => {}
            }
        }
        (found.len() == names.len()).then_some(found)
    }
}
