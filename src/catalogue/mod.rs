//! The catalogue of wheels, soils and gravity: published values, each with its source, compiled in from `catalogue/*.json`.
//!
//! Adding an entry is adding a record to one of those files; the tests check that it can be read and computes, or says what
//! it lacks.

mod extent;
mod gravity;
mod published;
mod record;
mod size;
mod spread;
mod substitutes;
mod table;
mod view;

pub(crate) use extent::{CATALOGUE, Outside, outside};
pub(crate) use gravity::{Gravity, gravity};
pub(crate) use record::{SoilRecord, WheelRecord};
pub(crate) use size::{is_of_exponent, size};
pub(crate) use spread::{Held, LAW, Spread};
pub(crate) use substitutes::Substitute;
pub(crate) use table::{soils_table, wheels_table};
pub(crate) use view::{SoilView, WheelView};

use std::sync::LazyLock;

static WHEELS: LazyLock<Vec<WheelRecord>> = LazyLock::new(|| compiled_in(include_str!("../../catalogue/wheels.json")));
static SOILS: LazyLock<Vec<SoilRecord>> = LazyLock::new(|| {
    let records: Vec<SoilRecord> = compiled_in(include_str!("../../catalogue/soils.json"));
    records.into_iter().map(SoilRecord::with_gravity).collect()
});

/// A word that changes with any record.
pub(crate) const VERSION: &str = env!("VERSION_OF_CATALOGUE");

fn compiled_in<T: serde::de::DeserializeOwned>(text: &str) -> Vec<T> {
    serde_json::from_str(text).expect("the catalogue is compiled in and its tests read it")
}

/// All wheels.
pub(crate) fn wheels() -> &'static [WheelRecord] {
    &WHEELS
}

/// All soils.
pub(crate) fn soils() -> &'static [SoilRecord] {
    &SOILS
}

/// The wheel of that name.
pub(crate) fn wheel(id: &str) -> Option<&'static WheelRecord> {
    wheels().iter().find(|record| record.id == id)
}

/// The soil of that name.
pub(crate) fn soil(id: &str) -> Option<&'static SoilRecord> {
    soils().iter().find(|record| record.id == id)
}

/// The names of all wheels.
pub(crate) fn wheel_ids() -> Vec<&'static str> {
    wheels().iter().map(|record| record.id.as_str()).collect()
}

/// The names of all soils.
pub(crate) fn soil_ids() -> Vec<&'static str> {
    soils().iter().map(|record| record.id.as_str()).collect()
}

/// The kinds of the wheels, each once.
pub(crate) fn wheel_kinds() -> Vec<&'static str> {
    distinct(wheels().iter().map(|record| record.kind.as_str()))
}

/// The kinds of the soils, each once.
pub(crate) fn soil_kinds() -> Vec<&'static str> {
    distinct(soils().iter().map(|record| record.kind.as_str()))
}

/// Words in the order in which they first come.
fn distinct(words: impl Iterator<Item = &'static str>) -> Vec<&'static str> {
    let mut found = Vec::new();
    for word in words {
        if !found.contains(&word) {
            found.push(word);
        }
    }
    found
}

#[cfg(test)]
mod tests;
