//! A part of the contract: the operations of some tags, and the components that they use.

use std::collections::BTreeSet;

use serde_json::{Map, Value};
use terramechanics_reading::{Field, Object, Reader, Word, Words};

use crate::request::Request;

/// The tags of the operations, each with what it is about.
pub(super) const TAGS: [(&str, &str); 4] = [
    ("forces", "Forces and stresses of a wheel"),
    ("identification", "Parameters of soil and contact from measurements"),
    ("catalogue", "Wheels, soils, measurements and equations, with their sources"),
    ("operations", "For operators and tools"),
];

const NAMES: &[(&str, &str)] = &[(TAGS[0].0, TAGS[0].0), (TAGS[1].0, TAGS[1].0), (TAGS[2].0, TAGS[2].0), (TAGS[3].0, TAGS[3].0)];

const ASKED: Field<Words<&'static str>> = Field::new(
    "tags",
    "Only the operations of these tags, separated by commas, and the components that they use.",
    Words { word: Word::new(NAMES), most: NAMES.len(), first_unless_given: 0 },
);

/// The tags whose operations are wanted, or all.
pub(crate) struct ContractCase(pub(super) Option<Vec<&'static str>>);

impl Request for ContractCase {
    const OBJECT: &'static Object = &Object { name: "ContractQuery", doc: "Which part of the contract.", groups: &[&[&ASKED]] };

    fn read(object: &Reader<'_>) -> Option<Self> {
        object.optional(&ASKED).map(Self)
    }
}

/// Keeps what the operations of these tags need.
pub(super) fn keep(document: &mut Value, tags: &[&str]) {
    let is_wanted = |tag: &Value| tag.as_str().is_some_and(|tag| tags.contains(&tag));
    if let Some(paths) = document["paths"].as_object_mut() {
        for item in paths.values_mut().filter_map(Value::as_object_mut) {
            item.retain(|_, operation| operation["tags"].as_array().is_some_and(|tags| tags.iter().any(is_wanted)));
        }
        paths.retain(|_, item| item.as_object().is_some_and(|item| !item.is_empty()));
    }
    if let Some(all) = document["tags"].as_array_mut() {
        all.retain(|tag| is_wanted(&tag["name"]));
    }
    let used = used_components(document);
    for (kind, components) in document["components"].as_object_mut().into_iter().flatten() {
        if let Some(components) = components.as_object_mut() {
            components.retain(|name, _| used.contains(&format!("#/components/{kind}/{name}")));
        }
    }
    if let Some(components) = document["components"].as_object_mut() {
        components.retain(|_, of_kind| of_kind.as_object().is_some_and(|of_kind| !of_kind.is_empty()));
    }
}

/// The components that the paths refer to, themselves or through others.
fn used_components(document: &Value) -> BTreeSet<String> {
    let mut used = BTreeSet::new();
    let mut open = vec![&document["paths"]];
    while let Some(value) = open.pop() {
        match value {
            Value::Object(fields) => {
                if let Some(target) = reference(fields)
                    && used.insert(target.to_owned())
                {
                    open.extend(document.pointer(target.trim_start_matches('#')));
                }
                open.extend(fields.values());
            }
            Value::Array(items) => open.extend(items),
            _ => {}
        }
    }
    used
}

fn reference(fields: &Map<String, Value>) -> Option<&str> {
    fields.get("$ref")?.as_str()
}
