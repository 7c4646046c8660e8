//! What is declared of a field: its name, its kind, whether it has to be there, and what it means.

use utoipa::openapi::path::{Parameter, ParameterBuilder, ParameterIn};
use utoipa::openapi::{RefOr, Required, Schema};

use crate::fault::Scope;
use crate::node::Node;
use crate::number::Number;
use crate::path::{Astray, Way};

/// A field of an object, as it is declared.
#[derive(Debug, Clone, Copy)]
pub struct Field<K> {
    /// Its name.
    pub name: &'static str,
    /// What it means, for the contract.
    pub meaning: &'static str,
    /// What it may hold.
    pub kind: K,
    /// Whether a request without it is refused whatever else it has. For any other field null is as good as nothing.
    pub required: bool,
}

impl<K> Field<K> {
    /// A field that may be absent.
    pub const fn new(name: &'static str, meaning: &'static str, kind: K) -> Self {
        Self { name, meaning, kind, required: false }
    }

    /// A field that has to be there.
    pub const fn required(name: &'static str, meaning: &'static str, kind: K) -> Self {
        Self { name, meaning, kind, required: true }
    }
}

/// Schemas that are referred to by their names.
pub type Components = Vec<(String, RefOr<Schema>)>;

/// What a field may hold.
pub trait Kind: Sync {
    /// What is made of it.
    type Value<'a>;

    /// Reads a value; none where it is wrong, which is reported to `place`.
    fn read<'a>(&self, node: &'a Node<'a>, place: Scope<'a>) -> Option<Self::Value<'a>>;

    /// Reports that the field is absent, though it is needed.
    fn absent(&self, place: &Scope<'_>) {
        place.fault("is required");
    }

    /// The schema of a field with that meaning.
    fn schema(&self, meaning: &str) -> RefOr<Schema>;

    /// Adds the named schemas that the schema refers to.
    fn components(&self, _found: &mut Components) {}

    /// Adds the query parameters that stand for a field of that name.
    fn parameters(&self, name: &str, meaning: &str, _required: bool, found: &mut Vec<Parameter>) {
        found.push(parameter(name, meaning, self.schema(meaning)));
    }

    /// The names of the fields of an object; none of anything else.
    fn names_within(&self) -> Vec<&'static str> {
        Vec::new()
    }

    /// The number at the end of a way that leads here.
    ///
    /// # Errors
    /// Why there is none.
    fn number_at(&self, way: Way<'_>) -> Result<Number, Astray> {
        Err(way.astray(self.what()))
    }

    /// What it holds, in words: of what is no number and has no fields.
    fn what(&self) -> &'static str {
        "a word"
    }
}

/// A query parameter, whose meaning is said once, where readers of the document look for it.
pub(crate) fn parameter(name: &str, meaning: &str, mut schema: RefOr<Schema>) -> Parameter {
    match &mut schema {
        RefOr::T(Schema::Object(object)) => object.description = None,
        RefOr::T(Schema::OneOf(one_of)) => one_of.description = None,
        RefOr::T(Schema::Array(list)) => list.description = None,
        RefOr::Ref(reference) => reference.description.clear(),
        RefOr::T(_) => {}
    }
    let parameter = ParameterBuilder::new().name(name).parameter_in(ParameterIn::Query).required(Required::False);
    parameter.description(Some(meaning)).schema(Some(schema)).build()
}

/// The name of a component of a contract, of words with a capital letter each.
#[must_use]
pub fn component_name<'a>(words: impl Iterator<Item = &'a str>) -> String {
    words.flat_map(|word| word.chars().take(1).flat_map(char::to_uppercase).chain(word.chars().skip(1))).collect()
}

/// Reports a value of another type.
pub(crate) fn wrong_type<T>(place: &Scope<'_>, expected: &str, node: &Node<'_>) -> Option<T> {
    place.fault(format_args!("must be {expected}, not {}", node.in_words()));
    None
}

/// What can be told of a field of whatever kind.
pub trait Declared: Sync {
    /// Its name.
    fn name(&self) -> &'static str;

    /// Whether a request without it is refused whatever else it has.
    fn is_required(&self) -> bool;

    /// Its schema.
    fn schema(&self) -> RefOr<Schema>;

    /// Adds the named schemas that the schema refers to.
    fn components(&self, found: &mut Components);

    /// Adds the query parameters that stand for it, where `around` is the name of the object with a dot, or nothing.
    fn parameters(&self, around: &str, found: &mut Vec<Parameter>);

    /// The names of the fields of an object; none of anything else.
    fn names_within(&self) -> Vec<&'static str>;

    /// The number at the end of a way that leads here.
    ///
    /// # Errors
    /// Why there is none.
    fn number_at(&self, way: Way<'_>) -> Result<Number, Astray>;
}

impl<K: Kind> Declared for Field<K> {
    fn name(&self) -> &'static str {
        self.name
    }

    fn is_required(&self) -> bool {
        self.required
    }

    fn schema(&self) -> RefOr<Schema> {
        self.kind.schema(self.meaning)
    }

    fn components(&self, found: &mut Components) {
        self.kind.components(found);
    }

    fn parameters(&self, around: &str, found: &mut Vec<Parameter>) {
        self.kind.parameters(&format!("{around}{}", self.name), self.meaning, self.required, found);
    }

    fn names_within(&self) -> Vec<&'static str> {
        self.kind.names_within()
    }

    fn number_at(&self, way: Way<'_>) -> Result<Number, Astray> {
        self.kind.number_at(way)
    }
}

/// Fields that are read together and stand in more than one object.
pub type Group = &'static [&'static dyn Declared];

/// The group of some fields of one kind.
pub const fn group<K: Kind, const N: usize>(fields: &'static [Field<K>; N]) -> [&'static dyn Declared; N] {
    let mut group: [&'static dyn Declared; N] = [&fields[0]; N];
    let mut i = 0;
    while i < N {
        group[i] = &fields[i];
        i += 1;
    }
    group
}
