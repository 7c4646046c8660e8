//! The value that a request has for a field, about which a relative distribution lies.

use terramechanics_reading::{Assumption, Node, Path};

use crate::catalogue::{self, Substitute};
use crate::request::assume::ASSUME;

/// The value that a request has for a field: its own, that of the preset of the object around it, or, where the request allows it, the
/// substitute of one that was never published, which is then assumed.
pub(super) fn nominal(tree: &Node<'_>, path: &Path) -> Option<(f64, Option<Assumption>)> {
    let names = path.names();
    match tree.under(names) {
        Some(Node::Number(value)) => return Some((*value, None)),
        Some(Node::Null) | None => {}
        Some(_) => return None,
    }
    let name = names.last()?;
    let (at, preset) = (1..names.len()).rev().find_map(|at| {
        let around = tree.under(&names[..at])?;
        Some((at, around.under(&["preset".to_owned()])?.text()?))
    })?;
    // Of a law that was sent the preset has nothing.
    if names[at..names.len() - 1].iter().enumerate().any(|(i, _)| tree.under(&names[..=at + i]).is_some()) {
        return None;
    }
    let (published, substitutes): (_, &[Substitute]) = match names[at - 1].as_str() {
        "soil" => catalogue::soil(preset).map(|record| (record.number(name), record.substitutes()))?,
        "wheel" => catalogue::wheel(preset).map(|record| (record.number(name), record.substitutes()))?,
        _ => return None,
    };
    if let Some(value) = published {
        return Some((value, None));
    }
    let may_assume = matches!(tree.under(&[ASSUME.name.to_owned()]), Some(Node::Flag(true)));
    let field = names[at..].join(".");
    let substitute = substitutes.iter().find(|substitute| may_assume && substitute.field == field)?;
    let assumed = Assumption {
        field: path.dotted(),
        preset: preset.to_owned(),
        value: substitute.value,
        reason: substitute.reason.clone(),
    };
    Some((substitute.value, Some(assumed)))
}
