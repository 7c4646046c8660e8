//! Faults of a request, collected with where they are.

use std::borrow::Cow;
use std::cell::{Cell, RefCell};
use std::fmt::Display;

use serde::Serialize;
use utoipa::openapi::schema::{ObjectBuilder, Type};
use utoipa::openapi::{RefOr, Schema};
use utoipa::{PartialSchema, ToSchema};

use crate::assumption::{Assumption, Assumptions};
use crate::hints::{Hints, shortened};

/// One thing wrong with a request.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct FieldFault {
    /// JSON pointer (RFC 6901) to the field at fault; empty for the request as a whole.
    pub pointer: String,
    /// What is wrong with it.
    pub detail: String,
    /// The number that was refused and those that are taken, where they are known; they stand beside the others.
    #[serde(flatten)]
    pub figures: Option<Box<Figures>>,
}

/// The number that was refused, and those that are taken.
#[derive(Debug, Clone, Default, PartialEq, Serialize, ToSchema)]
pub struct Figures {
    /// The number that was refused; for a list, its number of items.
    #[serde(skip_serializing_if = "Option::is_none")]
    #[schema(nullable = false, example = -5)]
    pub value: Option<f64>,
    /// The smallest number that is accepted.
    #[serde(skip_serializing_if = "Option::is_none")]
    #[schema(nullable = false, example = 0)]
    pub minimum: Option<f64>,
    /// The largest number that is accepted.
    #[serde(skip_serializing_if = "Option::is_none")]
    #[schema(nullable = false, example = 1e8)]
    pub maximum: Option<f64>,
    /// In place of `maximum`: a number that the value has to be below.
    #[serde(skip_serializing_if = "Option::is_none")]
    #[schema(nullable = false)]
    pub exclusive_maximum: Option<f64>,
    /// Field that sets `maximum`, as a JSON pointer, where another field does.
    #[serde(skip_serializing_if = "Option::is_none")]
    #[schema(nullable = false, example = "/wheel/radius_m")]
    pub maximum_from: Option<&'static str>,
    /// Unit of these numbers as a UCUM code; `1` for numbers without one.
    #[serde(skip_serializing_if = "Option::is_none")]
    #[schema(nullable = false, example = "Pa")]
    pub unit: Option<Cow<'static, str>>,
}

impl PartialSchema for FieldFault {
    fn schema() -> RefOr<Schema> {
        let text = |meaning: &str, example: &str| {
            ObjectBuilder::new().schema_type(Type::String).description(Some(meaning)).examples([example])
        };
        let pointer = "JSON pointer (RFC 6901) to the field at fault; empty for the request as a whole.";
        let fault = ObjectBuilder::new()
            .description(Some("One thing wrong with a request."))
            .property("pointer", text(pointer, "/soil/cohesion_pa"))
            .required("pointer")
            .property("detail", text("What is wrong with it.", "must be from 0 to 1e8, not -5"))
            .required("detail");
        let mut fault = fault.build();
        if let RefOr::T(Schema::Object(figures)) = Figures::schema() {
            fault.properties.extend(figures.properties);
        }
        fault.into()
    }
}

impl ToSchema for FieldFault {}

impl FieldFault {
    /// A fault without numbers.
    #[must_use]
    pub fn new(pointer: impl Into<String>, detail: impl Display) -> Self {
        Self { pointer: pointer.into(), detail: detail.to_string(), figures: None }
    }

    /// The fault with its numbers.
    #[must_use]
    pub fn with(self, figures: Figures) -> Self {
        // JSON has no infinity, which a query can send.
        let value = figures.value.filter(|value| value.is_finite());
        Self { figures: Some(Box::new(Figures { value, ..figures })), ..self }
    }
}

/// Faults that are kept of one request; the others are counted.
const MOST_FAULTS: usize = 100;

/// The faults of a request, what was assumed of it, and the words by which its reader tells what was meant.
pub struct Faults {
    list: RefCell<Vec<FieldFault>>,
    more: Cell<usize>,
    hints: &'static Hints,
    assumptions: Assumptions,
}

impl Faults {
    /// None so far.
    #[must_use]
    pub fn new(hints: &'static Hints) -> Self {
        Self { list: RefCell::default(), more: Cell::new(0), hints, assumptions: Assumptions::default() }
    }

    /// None so far of a part that is read by itself; it may be assumed of it what may be assumed of `place`.
    #[must_use]
    pub fn apart(place: &Scope<'_>) -> Self {
        let faults = Self::new(place.hints());
        if place.may_assume() {
            faults.assumptions.allow();
        }
        faults
    }

    /// What was assumed; none where nothing may be.
    #[must_use]
    pub fn assumptions(&self) -> Option<Vec<Assumption>> {
        self.assumptions.list()
    }

    /// The faults in the order in which they were found; those beyond what is kept are one fault of the whole.
    #[must_use]
    pub fn into_list(self) -> Vec<FieldFault> {
        let mut list = self.list.into_inner();
        if self.more.get() > 0 {
            list.push(FieldFault::new("", format_args!("has {} more faults", self.more.get())));
        }
        list
    }

    fn push(&self, fault: impl FnOnce() -> FieldFault) {
        let mut list = self.list.borrow_mut();
        if list.len() < MOST_FAULTS {
            list.push(fault());
        } else {
            self.more.set(self.more.get().saturating_add(1));
        }
    }
}

/// A place in a request, to which faults are reported.
///
/// A place is a link to the one around it, so that nothing is allocated until there is a fault.
#[derive(Clone, Copy)]
pub struct Scope<'a> {
    around: Option<&'a Scope<'a>>,
    name: &'static str,
    item: Option<usize>,
    faults: &'a Faults,
}

impl<'a> Scope<'a> {
    /// The request as a whole.
    #[must_use]
    pub fn root(faults: &'a Faults) -> Self {
        Self { around: None, name: "", item: None, faults }
    }

    /// The place of a field of this object.
    #[must_use]
    pub fn field(&'a self, name: &'static str) -> Self {
        Self { around: Some(self), name, item: None, faults: self.faults }
    }

    /// The place of an item of this array, which holds no further arrays.
    #[must_use]
    pub fn item(self, index: usize) -> Self {
        Self { item: Some(index), ..self }
    }

    /// Reports a fault of this place.
    pub fn fault(&self, detail: impl Display) {
        self.faults.push(|| FieldFault::new(self.pointer(), detail));
    }

    /// Reports a fault of this place with its numbers.
    pub fn report(&self, figures: Figures, detail: impl Display) {
        self.faults.push(|| FieldFault::new(self.pointer(), detail).with(figures));
    }

    /// Reports a fault of a field whose name came from the client.
    pub fn fault_of(&self, name: &str, detail: impl Display) {
        let pointer = || format!("/{}", name.replace('~', "~0").replace('/', "~1"));
        self.faults.push(|| FieldFault::new(self.pointer() + &pointer(), detail));
    }

    /// Reports a fault whose pointer starts from this place.
    pub fn pass_on(&self, fault: FieldFault) {
        self.faults.push(|| FieldFault { pointer: self.pointer() + &fault.pointer, ..fault });
    }

    /// Lets values be assumed that were not sent.
    pub fn allow_assumptions(&self) {
        self.faults.assumptions.allow();
    }

    /// Whether values may be assumed that were not sent.
    #[must_use]
    pub fn may_assume(&self) -> bool {
        self.faults.assumptions.are_allowed()
    }

    /// Keeps that this field, which `preset` lacks, was not sent and is taken to have a value.
    pub fn assume(&self, preset: &str, value: f64, reason: &str) {
        self.faults.assumptions.add(|| Assumption {
            field: self.pointer().trim_start_matches('/').replace('/', "."),
            preset: preset.to_owned(),
            value,
            reason: reason.to_owned(),
        });
    }

    /// Keeps what was assumed of a part that was read by itself.
    pub fn assume_all(&self, assumptions: Vec<Assumption>) {
        assumptions.into_iter().for_each(|assumption| self.faults.assumptions.add(|| assumption));
    }

    /// The words by which is told what was meant.
    #[must_use]
    pub fn hints(&self) -> &'static Hints {
        self.faults.hints
    }

    /// Its JSON pointer.
    #[must_use]
    pub fn pointer(&self) -> String {
        let Some(around) = self.around else { return String::new() };
        let (around, name) = (around.pointer(), self.name);
        match self.item {
            None => format!("{around}/{name}"),
            Some(index) => format!("{around}/{name}/{index}"),
        }
    }
}

/// Reports a word that is not known.
pub fn unknown_word(place: &Scope<'_>, word: &str, known: &[&str]) {
    let word = shortened(word);
    match place.hints().nearest(&word, known) {
        Some(near) => place.fault(format_args!("unknown name `{word}`; did you mean `{near}`?")),
        None => place.fault(format_args!("unknown name `{word}`; known are {}", known.join(", "))),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_place_knows_its_pointer() {
        let faults = Faults::new(&Hints::NONE);
        let root = Scope::root(&faults);
        let (soil, plates) = (root.field("soil"), root.field("plates").item(2));
        soil.field("cohesion_pa").fault("a");
        plates.field("width_m").fault("b");
        root.fault_of("a/b~c", "c");
        root.fault("d");
        let pointers: Vec<_> = faults.into_list().into_iter().map(|fault| fault.pointer).collect();
        assert_eq!(pointers, ["/soil/cohesion_pa", "/plates/2/width_m", "/a~1b~0c", ""]);
    }

    #[test]
    fn faults_beyond_measure_are_counted() {
        let faults = Faults::new(&Hints::NONE);
        let root = Scope::root(&faults);
        (0..1_000_000).for_each(|_| root.fault("wrong"));
        let list = faults.into_list();
        assert_eq!(list.len(), MOST_FAULTS + 1);
        assert_eq!(list.last().map(|fault| fault.detail.as_str()), Some("has 999900 more faults"));
    }

    #[test]
    fn numbers_are_written_where_they_are_known() {
        let figures = Figures { value: Some(-5.0), minimum: Some(0.0), unit: Some("Pa".into()), ..Figures::default() };
        let fault = FieldFault::new("/a", "wrong").with(figures);
        let text = serde_json::to_string(&fault).expect("JSON");
        assert_eq!(text, r#"{"pointer":"/a","detail":"wrong","value":-5.0,"minimum":0.0,"unit":"Pa"}"#);
        assert_eq!(serde_json::to_string(&FieldFault::new("", "x")).expect("JSON"), r#"{"pointer":"","detail":"x"}"#);
    }
}
