//! Entries of the catalogue that a request names, and what it sends in place of their values.

use terramechanics_reading::{Field, Lookup, Number, Reader, Scope};

use crate::catalogue::{SoilRecord, WheelRecord};

/// An entry of the catalogue.
pub(crate) trait Entry: Sync + 'static {
    /// Its name.
    fn id(&self) -> &str;

    /// The published value of that name.
    fn number(&self, name: &str) -> Option<f64>;
}

impl Entry for WheelRecord {
    fn id(&self) -> &str {
        &self.id
    }

    fn number(&self, name: &str) -> Option<f64> {
        self.number(name)
    }
}

impl Entry for SoilRecord {
    fn id(&self) -> &str {
        &self.id
    }

    fn number(&self, name: &str) -> Option<f64> {
        self.number(name)
    }
}

/// The entry that a request names, if it names one.
#[derive(Clone, Copy)]
pub(crate) struct Preset<E: 'static> {
    pub(crate) entry: Option<&'static E>,
    /// False where a name was sent that is none, which was reported: nothing is missing then.
    pub(crate) is_sound: bool,
}

impl<E: Entry> Preset<E> {
    pub(crate) fn read(object: &Reader<'_>, field: &Field<Lookup<&'static E>>) -> Self {
        let named = object.optional(field);
        Self { entry: named.flatten(), is_sound: named.is_some() }
    }

    /// What was sent, else what is published; no answer at all where what was sent is wrong.
    pub(crate) fn optional(&self, object: &Reader<'_>, field: &Field<Number>) -> Option<Option<f64>> {
        Some(object.optional(field)?.or_else(|| self.entry.and_then(|entry| entry.number(field.name))))
    }

    /// What was sent, else what is published, else `otherwise`; that there is none of them is reported.
    pub(crate) fn value(&self, object: &Reader<'_>, field: &Field<Number>, otherwise: Option<f64>) -> Option<f64> {
        let value = self.optional(object, field)?.or(otherwise);
        if value.is_none() {
            self.missing(&object.place_of(field));
        }
        value
    }

    /// Reports that there is no value, neither in the request nor published.
    pub(crate) fn missing(&self, place: &Scope<'_>) {
        match self.entry {
            Some(entry) => {
                place.fault(format_args!("is required: the catalogue has no published value for `{}`", entry.id()));
            }
            None if self.is_sound => place.fault("is required"),
            None => {}
        }
    }
}
