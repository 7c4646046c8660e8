//! The queries of the catalogue's lists.

use terramechanics_reading::{Field, Lookup, Object, Reader};

use crate::catalogue::{soil_kinds, wheel_kinds};
use crate::request::{Documented, Request};

const WHEEL_KIND: Field<Lookup<&'static str>> = Field::new(
    "kind",
    "Only wheels of this kind.",
    Lookup { name: None, words: wheel_kinds, find: |word| wheel_kinds().into_iter().find(|kind| *kind == word) },
);
const SOIL_KIND: Field<Lookup<&'static str>> = Field::new(
    "kind",
    "Only soils of this kind.",
    Lookup { name: None, words: soil_kinds, find: |word| soil_kinds().into_iter().find(|kind| *kind == word) },
);

/// The wheels to list: of this kind, or all.
pub(crate) struct WheelsCase(pub(crate) Option<&'static str>);

/// The soils to list: of this kind, or all.
pub(crate) struct SoilsCase(pub(crate) Option<&'static str>);

pub(super) type WheelsQuery = Documented<WheelsCase>;
pub(super) type SoilsQuery = Documented<SoilsCase>;

impl Request for WheelsCase {
    const OBJECT: &'static Object = &Object { name: "WheelsQuery", doc: "Which wheels to list.", groups: &[&[&WHEEL_KIND]] };

    fn read(object: &Reader<'_>) -> Option<Self> {
        object.optional(&WHEEL_KIND).map(Self)
    }
}

impl Request for SoilsCase {
    const OBJECT: &'static Object = &Object { name: "SoilsQuery", doc: "Which soils to list.", groups: &[&[&SOIL_KIND]] };

    fn read(object: &Reader<'_>) -> Option<Self> {
        object.optional(&SOIL_KIND).map(Self)
    }
}
