//! Objects: groups of fields, and nothing beside them.

use utoipa::openapi::path::Parameter;
use utoipa::openapi::schema::{AdditionalProperties, ObjectBuilder, Ref};
use utoipa::openapi::{RefOr, Schema};

use crate::assumption::Assumption;
use crate::fault::{Faults, FieldFault, Scope};
use crate::field::{Components, Declared, Field, Group, Kind, wrong_type};
use crate::hints::{Hints, shortened};
use crate::node::{Fields, Node, is_same};
use crate::number::Number;
use crate::path::{Astray, Path, Way};
use crate::reader::Reader;

/// An object, as it is declared.
#[derive(Clone, Copy)]
pub struct Object {
    /// Its name in the contract.
    pub name: &'static str,
    /// What it is.
    pub doc: &'static str,
    /// Its fields.
    pub groups: &'static [Group],
}

impl std::fmt::Debug for Object {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        f.debug_struct("Object").field("name", &self.name).finish_non_exhaustive()
    }
}

/// What becomes of fields that are not declared.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Unknown {
    /// They are reported.
    Refused,
    /// They are left out.
    Ignored,
}

/// Unknown and repeated names that are told of one object.
const MOST_ODDITIES: usize = 20;

/// Reports the names that `known` has not, and those that are there more than once.
pub(crate) fn report_oddities(
    fields: &Fields<'_>,
    place: &Scope<'_>,
    unknown: Unknown,
    mut known: impl FnMut(&str) -> Option<&'static str>,
    hint: impl Fn(&str) -> String,
) {
    let mut told = 0;
    for (i, (name, _)) in fields.0.iter().enumerate() {
        match known(name) {
            Some(known) if fields.0[..i].iter().any(|(earlier, _)| is_same(earlier, known)) => {
                place.field(known).fault("is given more than once");
            }
            None if unknown == Unknown::Refused => {
                place.fault_of(&shortened(name), format_args!("unknown field; {}", hint(name)))
            }
            _ => continue,
        }
        told += 1;
        if told == MOST_ODDITIES {
            return;
        }
    }
}

impl Object {
    /// Its fields.
    pub fn fields(&self) -> impl Iterator<Item = &'static dyn Declared> + use<> {
        self.groups.iter().flat_map(|group| group.iter().copied())
    }

    /// The names of its fields.
    #[must_use]
    pub fn names(&self) -> Vec<&'static str> {
        self.fields().map(Declared::name).collect()
    }

    /// A reader of the fields that stand at `place`.
    pub(crate) fn open<'a>(&self, fields: &'a Fields<'a>, place: Scope<'a>, unknown: Unknown) -> Reader<'a> {
        let known = |name: &str| {
            for group in self.groups {
                for field in *group {
                    let known = field.name();
                    if is_same(known, name) {
                        return Some(known);
                    }
                }
            }
            None
        };
        let hint = |name: &str| {
            let within: Vec<_> = self.fields().map(|field| (field.name(), field.names_within())).collect();
            place.hints().unknown_field(name, &self.names(), &within)
        };
        report_oddities(fields, &place, unknown, known, hint);
        Reader::new(fields, place)
    }

    /// A reader of an object that stands at `place`.
    pub(crate) fn read<'a>(&self, node: &'a Node<'a>, place: Scope<'a>) -> Option<Reader<'a>> {
        match node {
            Node::Object(fields) => Some(self.open(fields, place, Unknown::Refused)),
            other => wrong_type(&place, "an object", other),
        }
    }

    /// The number that is declared under a path.
    ///
    /// # Errors
    /// Why there is none.
    pub fn number_at(&self, path: &Path, hints: &'static Hints) -> Result<Number, Astray> {
        self.number_within(Way::of(path, hints))
    }

    /// The number at the end of a way that leads here.
    pub(crate) fn number_within(&self, way: Way<'_>) -> Result<Number, Astray> {
        let Some((name, behind)) = way.step() else {
            return Err(Astray::NoNumber { what: format!("an object; its fields are {}", self.names().join(", ")) });
        };
        match self.fields().find(|field| field.name() == name) {
            Some(field) => field.number_at(behind),
            None => {
                let within: Vec<_> = self.fields().map(|field| (field.name(), field.names_within())).collect();
                Err(behind.unknown(name, &self.names(), &within))
            }
        }
    }

    /// Its schema, which refuses fields that are not declared.
    #[must_use]
    pub fn schema(&self) -> RefOr<Schema> {
        let mut object =
            ObjectBuilder::new().description(Some(self.doc)).additional_properties(Some(AdditionalProperties::FreeForm(false)));
        for field in self.fields() {
            object = object.property(field.name(), field.schema());
            if field.is_required() {
                object = object.required(field.name());
            }
        }
        object.into()
    }

    /// Adds the named schemas of its fields.
    pub fn components(&self, found: &mut Components) {
        self.fields().for_each(|field| field.components(found));
    }

    /// Adds its own named schema and those of its fields.
    pub(crate) fn component(&self, found: &mut Components) {
        found.push((self.name.to_owned(), self.schema()));
        self.components(found);
    }

    /// Adds the query parameters that stand for its fields, where `around` is its own name with a dot, or nothing.
    pub fn parameters(&self, around: &str, found: &mut Vec<Parameter>) {
        self.fields().for_each(|field| field.parameters(around, found));
    }

    /// A reference to its schema.
    pub(crate) fn reference(&self, meaning: &str) -> RefOr<Schema> {
        reference(self.name, meaning)
    }
}

/// A reference to a named schema.
pub(crate) fn reference(name: &str, meaning: &str) -> RefOr<Schema> {
    let mut reference = Ref::from_schema_name(name);
    reference.description = meaning.to_owned();
    RefOr::Ref(reference)
}

/// Adds what `inner` adds, the parameters of an object of that name.
pub(crate) fn parameters_within(
    name: &str,
    required: bool,
    found: &mut Vec<Parameter>,
    inner: impl FnOnce(&str, &mut Vec<Parameter>),
) {
    let outside = found.len();
    inner(&format!("{name}."), found);
    if !required {
        found[outside..].iter_mut().for_each(|parameter| default_in_words(parameter, name));
    }
}

/// Says in words what holds for a field once the object `around` is there. As the default of a parameter it would be wrong: a
/// client that sends it has named the object, and is then asked for the rest of it.
fn default_in_words(parameter: &mut Parameter, around: &str) {
    let default = match &mut parameter.schema {
        Some(RefOr::T(Schema::Object(object))) => object.default.take(),
        Some(RefOr::T(Schema::OneOf(one_of))) => one_of.default.take(),
        _ => None,
    };
    if let (Some(default), Some(description)) = (default, &mut parameter.description) {
        description.push_str(&format!(" With the rest of `{around}`, {default} unless given."));
    }
}

impl Kind for &'static Object {
    type Value<'a> = Reader<'a>;

    fn read<'a>(&self, node: &'a Node<'a>, place: Scope<'a>) -> Option<Reader<'a>> {
        Object::read(self, node, place)
    }

    fn schema(&self, meaning: &str) -> RefOr<Schema> {
        self.reference(meaning)
    }

    fn components(&self, found: &mut Components) {
        self.component(found);
    }

    fn parameters(&self, name: &str, _: &str, required: bool, found: &mut Vec<Parameter>) {
        parameters_within(name, required, found, |around, found| Object::parameters(self, around, found));
    }

    fn names_within(&self) -> Vec<&'static str> {
        self.names()
    }

    fn number_at(&self, way: Way<'_>) -> Result<Number, Astray> {
        Object::number_within(self, way)
    }
}

impl<'a> Reader<'a> {
    /// The object of a field, if it was sent, whose unknown fields are refused or ignored.
    #[must_use]
    pub fn opened<'r>(&'r self, field: &Field<&'static Object>, unknown: Unknown) -> Option<Option<Reader<'r>>> {
        let Some((node, place)) = self.raw(field) else { return Some(None) };
        match node {
            Node::Object(fields) => Some(Some(field.kind.open(fields, place, unknown))),
            other => wrong_type(&place, "an object", other),
        }
    }

    /// The object of a field; one without fields where it was not sent.
    #[must_use]
    pub fn or_empty<'r>(&'r self, field: &Field<&'static Object>) -> Option<Reader<'r>> {
        let given = self.optional(field)?;
        Some(given.unwrap_or_else(|| Reader::empty(self.place_of(field))))
    }
}

/// What `check` makes of a request, or all the faults that were found.
///
/// # Errors
/// The faults: those of the names first, then those that `check` reports.
pub fn read<T>(
    node: &Node<'_>,
    object: &Object,
    hints: &'static Hints,
    check: impl FnOnce(&Reader<'_>) -> Option<T>,
) -> Result<T, Vec<FieldFault>> {
    read_assuming(node, object, hints, check).map(|(value, _)| value)
}

/// The same, with what was assumed; no list where `check` allowed nothing to be.
///
/// # Errors
/// The faults.
pub fn read_assuming<T>(
    node: &Node<'_>,
    object: &Object,
    hints: &'static Hints,
    check: impl FnOnce(&Reader<'_>) -> Option<T>,
) -> Result<(T, Option<Vec<Assumption>>), Vec<FieldFault>> {
    let faults = Faults::new(hints);
    let root = Scope::root(&faults);
    let checked = match node {
        Node::Object(fields) => check(&object.open(fields, root, Unknown::Refused)),
        other => {
            root.fault(format_args!("the body must be a JSON object, not {}", other.in_words()));
            None
        }
    };
    let assumed = faults.assumptions();
    sound(checked, faults).map(|checked| (checked, assumed))
}

/// What `check` makes of a request, or all the faults that it reports.
///
/// # Errors
/// The faults.
pub fn collected<T>(hints: &'static Hints, check: impl FnOnce(&Scope<'_>) -> Option<T>) -> Result<T, Vec<FieldFault>> {
    let faults = Faults::new(hints);
    let checked = check(&Scope::root(&faults));
    sound(checked, faults)
}

/// What was checked, if nothing is wrong.
fn sound<T>(checked: Option<T>, faults: Faults) -> Result<T, Vec<FieldFault>> {
    let faults = faults.into_list();
    match checked {
        Some(checked) if faults.is_empty() => Ok(checked),
        _ => Err(faults),
    }
}
