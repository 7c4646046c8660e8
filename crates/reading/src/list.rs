//! Lists: of numbers, of words, of objects, and the two bounds of a range.

use utoipa::openapi::path::{Parameter, ParameterStyle};
use utoipa::openapi::schema::ArrayBuilder;
use utoipa::openapi::{RefOr, Schema};

use crate::fault::{Figures, Scope};
use crate::field::{Components, Kind, parameter, wrong_type};
use crate::node::{Item, List, Node};
use crate::number::Number;
use crate::object::Object;
use crate::path::{Astray, Way};
use crate::reader::{Defaulting, Reader};
use crate::word::Word;

/// Faults of one list that are told; the others are counted.
const MOST_FAULTS: usize = 10;

/// Reports a list of too few or too many items.
fn wrong_length<T>(place: &Scope<'_>, found: usize, (fewest, most): (usize, usize), detail: String) -> Option<T> {
    let count = |count: usize| Some(count as f64);
    let figures = Figures { value: count(found), minimum: count(fewest), maximum: count(most), ..Figures::default() };
    place.report(figures, detail);
    None
}

/// A column of numbers.
#[derive(Debug, Clone, Copy)]
pub struct Numbers {
    /// What each number may be.
    pub number: Number,
    /// Fewest numbers taken.
    pub fewest: usize,
    /// Most numbers taken.
    pub most: usize,
    /// Whether null stands for a number that is missing.
    pub gaps: bool,
    /// What to do with a longer list, for those who sent one.
    pub advice: &'static str,
}

impl Numbers {
    /// From `fewest` to `most` numbers.
    #[must_use]
    pub const fn new(number: Number, fewest: usize, most: usize) -> Self {
        Self { number, fewest, most, gaps: false, advice: "" }
    }

    /// Null stands for a number that is missing.
    #[must_use]
    pub const fn with_gaps(self) -> Self {
        Self { gaps: true, ..self }
    }

    /// The numbers, if all are within the bounds; NaN for one that is missing.
    pub(crate) fn check<'a>(&self, list: &'a List<'a>, place: Scope<'a>) -> Option<&'a [f64]> {
        let Self { number, fewest, most, gaps, advice } = self;
        if !(*fewest..=*most).contains(&list.len()) {
            let detail = format!("must have from {fewest} to {most} numbers{advice}");
            return wrong_length(&place, list.len(), (*fewest, *most), detail);
        }
        let values = list.numbers();
        let is_whole = list.others().is_empty() && values.iter().all(|&value| number.allows(value) || *gaps && value.is_nan());
        if is_whole {
            return Some(values);
        }
        let mut faults = 0;
        for (i, item) in list.items().enumerate() {
            let place = place.item(i);
            let told = faults < MOST_FAULTS;
            let is_right = match item {
                Item::Number(value) if told => number.check(&place, value).is_some(),
                Item::Number(value) => number.allows(value),
                Item::Null if *gaps => true,
                other => {
                    if told {
                        let expected = if *gaps { "a number or null" } else { "a number" };
                        place.fault(format_args!("must be {expected}, not {}", other.in_words()));
                    }
                    false
                }
            };
            faults += usize::from(!is_right);
        }
        if faults > MOST_FAULTS {
            place.fault(format_args!("has {} more such faults", faults - MOST_FAULTS));
        }
        None
    }

    pub(crate) fn array(&self) -> ArrayBuilder {
        let items = ArrayBuilder::new().items(self.number.item(self.gaps));
        items.min_items(Some(self.fewest)).max_items(Some(self.most))
    }
}

impl Kind for Numbers {
    type Value<'a> = &'a [f64];

    fn read<'a>(&self, node: &'a Node<'a>, place: Scope<'a>) -> Option<&'a [f64]> {
        match node {
            Node::List(list) => self.check(list, place),
            other => wrong_type(&place, "an array of numbers", other),
        }
    }

    fn schema(&self, meaning: &str) -> RefOr<Schema> {
        self.array().description(Some(meaning)).into()
    }

    /// None: a query has no lists.
    fn parameters(&self, _: &str, _: &str, _: bool, _: &mut Vec<Parameter>) {}

    fn what(&self) -> &'static str {
        "an array of numbers"
    }
}

/// A lower and an upper bound.
#[derive(Debug, Clone, Copy)]
pub struct Bounds(pub Number);

impl Kind for Bounds {
    type Value<'a> = [f64; 2];

    fn read<'a>(&self, node: &'a Node<'a>, place: Scope<'a>) -> Option<[f64; 2]> {
        let Node::List(list) = node else { return wrong_type(&place, "an array of a lower and an upper bound", node) };
        if list.len() != 2 {
            let detail = "must have two numbers, the lower and the upper bound".to_owned();
            return wrong_length(&place, list.len(), (2, 2), detail);
        }
        let &[lower, upper] = Numbers::new(self.0, 2, 2).check(list, place)? else { return None };
        if lower >= upper {
            place.fault("the lower bound must be below the upper bound");
            return None;
        }
        Some([lower, upper])
    }

    fn schema(&self, meaning: &str) -> RefOr<Schema> {
        Numbers::new(self.0, 2, 2).schema(meaning)
    }

    /// None: a query has no lists.
    fn parameters(&self, _: &str, _: &str, _: bool, _: &mut Vec<Parameter>) {}

    fn what(&self) -> &'static str {
        "an array of two bounds"
    }
}

/// Different words out of a list, at least one.
#[derive(Debug, Clone, Copy)]
pub struct Words<T: 'static> {
    /// The words there are.
    pub word: Word<T>,
    /// Most words taken.
    pub most: usize,
    /// How many of the words, from the first, a list names that is left out; with 0 it has no default.
    pub first_unless_given: usize,
}

/// The word that an item of a list is, else what it is.
fn word_of<'n>(item: Item<'n, '_>) -> Result<&'n str, String> {
    let word = match item {
        Item::Other(node) => node.text(),
        _ => None,
    };
    word.ok_or_else(|| item.in_words().to_string())
}

impl<T> Words<T> {
    fn wrong_count<V>(&self, place: &Scope<'_>, found: usize) -> Option<V> {
        let most = self.most.min(List::MOST_OTHERS);
        wrong_length(place, found, (1, most), format!("must have from 1 to {most} names"))
    }
}

impl<T: Copy + PartialEq + Sync> Kind for Words<T> {
    type Value<'a> = Vec<T>;

    fn read<'a>(&self, node: &'a Node<'a>, place: Scope<'a>) -> Option<Vec<T>> {
        let words: Vec<Result<&str, String>> = match node {
            Node::List(list) if list.len() > List::MOST_OTHERS => return self.wrong_count(&place, list.len()),
            Node::List(list) => list.items().map(word_of).collect(),
            // A query writes the names in one parameter, with commas between.
            Node::Parameter(text) => text.split(',').take(List::MOST_OTHERS + 1).map(Ok).collect(),
            other => return wrong_type(&place, "an array of names", other),
        };
        if !(1..=self.most.min(List::MOST_OTHERS)).contains(&words.len()) {
            return self.wrong_count(&place, words.len());
        }
        let mut found: Vec<T> = Vec::with_capacity(words.len());
        for (i, word) in words.iter().enumerate() {
            let place = place.item(i);
            match word {
                Ok(word) => match self.word.look_up(word, &place) {
                    Some(known) if found.contains(&known) => place.fault("is named more than once"),
                    Some(known) => found.push(known),
                    None => {}
                },
                Err(sent) => place.fault(format_args!("must be a string, not {sent}")),
            }
        }
        (found.len() == words.len()).then_some(found)
    }

    fn schema(&self, meaning: &str) -> RefOr<Schema> {
        ArrayBuilder::new()
            .description(Some(meaning))
            .items(crate::word::words(self.word.names()))
            .min_items(Some(1))
            .max_items(Some(self.most))
            .unique_items(true)
            .default((self.first_unless_given > 0).then(|| self.word.names().into_iter().take(self.first_unless_given).collect()))
            .into()
    }

    fn parameters(&self, name: &str, meaning: &str, _: bool, found: &mut Vec<Parameter>) {
        let mut list = parameter(name, meaning, self.schema(meaning));
        list.style = Some(ParameterStyle::Form);
        list.explode = Some(false);
        found.push(list);
    }

    fn what(&self) -> &'static str {
        "an array of words"
    }
}

impl<T: Copy + PartialEq + Sync> Defaulting for Words<T> {
    fn default(&self) -> Option<Vec<T>> {
        let first = self.word.words.iter().take(self.first_unless_given).map(|(_, value)| *value);
        (self.first_unless_given > 0).then(|| first.collect())
    }
}

/// Objects of one form.
#[derive(Debug, Clone, Copy)]
pub struct Objects {
    /// What each is.
    pub object: &'static Object,
    /// Fewest objects taken.
    pub fewest: usize,
    /// Most objects taken.
    pub most: usize,
}

/// Objects as they were sent; none where the list was not.
#[derive(Default)]
pub struct Items<'a>(Option<(&'static Object, &'a List<'a>, Scope<'a>)>);

impl Items<'_> {
    /// What `read` makes of every object; none where one is wrong, yet all are read.
    pub fn each<T>(&self, mut read: impl FnMut(&Reader<'_>, usize) -> Option<T>) -> Option<Vec<T>> {
        let Some((object, list, place)) = self.0 else { return Some(Vec::new()) };
        let read = |(i, item): (usize, Item<'_, '_>)| match item {
            Item::Other(node) => read(&object.read(node, place.item(i))?, i),
            other => {
                place.item(i).fault(format_args!("must be an object, not {}", other.in_words()));
                None
            }
        };
        let read: Vec<Option<T>> = list.items().enumerate().map(read).collect();
        read.into_iter().collect()
    }
}

impl Kind for Objects {
    type Value<'a> = Items<'a>;

    fn read<'a>(&self, node: &'a Node<'a>, place: Scope<'a>) -> Option<Items<'a>> {
        let Node::List(list) = node else { return wrong_type(&place, "an array of objects", node) };
        let (fewest, most) = (self.fewest, self.most.min(List::MOST_OTHERS));
        if !(fewest..=most).contains(&list.len()) {
            return wrong_length(&place, list.len(), (fewest, most), format!("must have from {fewest} to {most} items"));
        }
        Some(Items(Some((self.object, list, place))))
    }

    fn schema(&self, meaning: &str) -> RefOr<Schema> {
        ArrayBuilder::new()
            .description(Some(meaning))
            .items(self.object.reference("One of the list."))
            .min_items((self.fewest > 0).then_some(self.fewest))
            .max_items(Some(self.most))
            .into()
    }

    fn components(&self, found: &mut Components) {
        self.object.component(found);
    }

    /// None: a query has no lists.
    fn parameters(&self, _: &str, _: &str, _: bool, _: &mut Vec<Parameter>) {}

    fn number_at(&self, way: Way<'_>) -> Result<Number, Astray> {
        match way.step() {
            None => Err(way.astray("a list of objects")),
            Some((name, behind)) if name.parse::<usize>().is_ok() => self.object.number_within(behind),
            Some((_, behind)) => Err(behind.not_there("a list has items, which are counted from 0".to_owned())),
        }
    }
}
