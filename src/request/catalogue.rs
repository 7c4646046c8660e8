//! The queries of the catalogue's lists.

use super::Request;
use crate::catalogue;
use crate::wire::{Choice, Entry, Scope, shortened, wire_object};

wire_object! {
    /// Which wheels to list.
    WheelsDto as "WheelsQuery" {
        kind: String = Choice { doc: "Only wheels of this kind.", words: catalogue::wheel_kinds, default: None },
    }
}

wire_object! {
    /// Which soils to list.
    SoilsDto as "SoilsQuery" {
        kind: String = Choice { doc: "Only soils of this kind.", words: catalogue::soil_kinds, default: None },
    }
}

impl Request for WheelsDto {
    type Query = Option<&'static str>;

    fn check(&self, place: &Scope<'_>) -> Option<Self::Query> {
        kind_of(&self.kind(), place)
    }
}

impl Request for SoilsDto {
    type Query = Option<&'static str>;

    fn check(&self, place: &Scope<'_>) -> Option<Self::Query> {
        kind_of(&self.kind(), place)
    }
}

/// The kind that is asked for, if one is; one that is not known is reported with all that are.
fn kind_of(entry: &Entry<'_, String>, place: &Scope<'_>) -> Option<Option<&'static str>> {
    if !entry.is_present() {
        return Some(None);
    }
    let word = entry.given(place)?;
    let kinds = (entry.spec.words)();
    let found = kinds.iter().copied().find(|kind| kind == word);
    if found.is_none() {
        place.field(entry.name).fault(format_args!("unknown name `{}`; known are {}", shortened(word), kinds.join(", ")));
    }
    found.map(Some)
}
