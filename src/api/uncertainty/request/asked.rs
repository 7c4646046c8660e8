//! The request whose fields are uncertain; its soil may have the published spread of its kind.

use terramechanics_reading::{Components, Kind, Nested, Node, Object, Path, Scope, unknown_word};
use utoipa::openapi::schema::{AdditionalProperties, AnyOfBuilder, ObjectBuilder, Type};
use utoipa::openapi::{RefOr, Schema};

use crate::catalogue::{self, LAW, SoilRecord, Spread};

/// One of several requests, whose soil may have a spread beside its preset.
#[derive(Debug, Clone, Copy)]
pub(super) struct Asked {
    pub(super) requests: &'static [&'static Object],
}

/// A request as the operation takes it, apart from the spread of its soil.
pub(super) struct Spreading {
    pub(super) tree: Node<'static>,
    /// The soil of the catalogue whose kind spreads.
    pub(super) soil: Option<&'static SoilRecord>,
}

const SOIL: &str = "soil";
const SPREAD: &str = "spread";
const CATALOGUE: &str = "catalogue";

impl Kind for Asked {
    type Value<'a> = Spreading;

    fn read<'a>(&self, node: &'a Node<'a>, place: Scope<'a>) -> Option<Spreading> {
        let mut tree = Nested { requests: self.requests }.read(node, place)?.detached();
        let of_soil = match &mut tree {
            Node::Object(fields) => fields.named_mut(SOIL),
            _ => None,
        };
        let Some(Node::Object(soil)) = of_soil else { return Some(Spreading { tree, soil: None }) };
        let word = match soil.take(SPREAD) {
            None | Some(Node::Null) => return Some(Spreading { tree, soil: None }),
            Some(word) => word,
        };
        let (of_soil, preset) = (place.field(SOIL), soil.named("preset").and_then(Node::text));
        let of_spread = of_soil.field(SPREAD);
        match word.text() {
            Some(CATALOGUE) => {}
            Some(other) => {
                unknown_word(&of_spread, other, &[CATALOGUE]);
                return None;
            }
            None => {
                of_spread.fault(format_args!("must be a string, not {}", word.in_words()));
                return None;
            }
        }
        let record = preset.and_then(catalogue::soil);
        if preset.is_none() {
            of_spread.fault("is the spread of the kind of a `preset`, and the soil has none");
            return None;
        }
        Some(Spreading { tree, soil: record })
    }

    fn schema(&self, meaning: &str) -> RefOr<Schema> {
        let any = AnyOfBuilder::new().description(Some(meaning));
        let any = self.requests.iter().fold(any, |any, request| any.item(request.reference("")));
        let word = ObjectBuilder::new().schema_type(Type::String).enum_values(Some([CATALOGUE])).description(Some(
            "catalogue: cohesion, friction angle, shear modulus and pressure–sinkage law spread over what is published of soils of the kind of the preset.",
        ));
        let soil = ObjectBuilder::new()
            .property("preset", ObjectBuilder::new().schema_type(Type::String))
            .property(SPREAD, word)
            .required("preset")
            .required(SPREAD)
            .additional_properties(Some(AdditionalProperties::FreeForm(true)));
        let spreading = ObjectBuilder::new()
            .description(Some("The same with a spread in its soil."))
            .property(SOIL, soil)
            .required(SOIL)
            .additional_properties(Some(AdditionalProperties::FreeForm(true)));
        any.item(spreading).into()
    }

    fn components(&self, found: &mut Components) {
        Nested { requests: self.requests }.components(found);
    }

    fn what(&self) -> &'static str {
        "a request"
    }
}

impl Spreading {
    /// What spreads of the soil: all but the fields that it has itself and those among `taken`, which the client knows better.
    pub(super) fn spread(&self, taken: &[Path]) -> Option<Spread> {
        let mut spread = self.soil?.spread();
        let soil = self.tree.under(&[SOIL.to_owned()])?;
        let has = |field: &str| {
            let sent = soil.under(&[field.to_owned()]).is_some_and(|node| !matches!(node, Node::Null));
            sent || taken.iter().any(|path| path.names().starts_with(&[SOIL.to_owned(), field.to_owned()]))
        };
        spread.values.retain(|value| !has(value.field));
        spread.held.retain(|held| !has(held.field));
        spread.law = spread.law.filter(|_| !has(LAW));
        Some(spread)
    }
}

/// The path of a field of the soil.
pub(super) fn of_soil(field: &str) -> Option<Path> {
    Path::of_pointer(&format!("/{SOIL}/{field}"))
}

/// Reports a fault of the spread.
pub(super) fn fault_of_spread(request: &Scope<'_>, detail: &str) {
    request.field(SOIL).field(SPREAD).fault(detail);
}
