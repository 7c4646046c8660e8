//! Entries of the catalogue that a request names, and what it sends in place of their values.

use terramechanics_reading::{Field, Lookup, Number, Reader};

use crate::catalogue::{SoilRecord, Substitute, WheelRecord};
use crate::quantity::with_unit;

/// An entry of the catalogue.
pub(crate) trait Entry: Sync + 'static {
    /// Its name.
    fn id(&self) -> &str;

    /// The published value of that name.
    fn number(&self, name: &str) -> Option<f64>;

    /// What stands in for values that were never published.
    fn substitutes(&self) -> &'static [Substitute];

    /// What stands in for the value of that name.
    fn substitute(&self, name: &str) -> Option<&'static Substitute> {
        self.substitutes().iter().find(|one| one.field == name)
    }
}

/// Both kinds of records are entries alike.
macro_rules! entries {
    ($($record:ty),+) => {$(
        impl Entry for $record {
            fn id(&self) -> &str {
                &self.id
            }

            fn number(&self, name: &str) -> Option<f64> {
                self.number(name)
            }

            fn substitutes(&self) -> &'static [Substitute] {
                self.substitutes()
            }
        }
    )+};
}

entries!(WheelRecord, SoilRecord);

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

    /// What was sent, else what is published, else `otherwise`, else what may be assumed; that there is none of them is reported.
    pub(crate) fn value(&self, object: &Reader<'_>, field: &Field<Number>, otherwise: Option<f64>) -> Option<f64> {
        let value = self.optional(object, field)?.or(otherwise).or_else(|| self.assumed(object, field));
        if value.is_none() {
            self.missing(object, field);
        }
        value
    }

    /// What stands in for the value, if that may be assumed, which is then kept for the answer.
    pub(crate) fn assumed(&self, object: &Reader<'_>, field: &Field<Number>) -> Option<f64> {
        let place = object.place_of(field);
        let entry = self.entry.filter(|_| place.may_assume())?;
        let substitute = entry.substitute(field.name)?;
        place.assume(entry.id(), substitute.value, &substitute.reason);
        Some(substitute.value)
    }

    /// Reports that a field has no value, neither in the request nor published.
    pub(crate) fn missing<K>(&self, object: &Reader<'_>, field: &Field<K>) {
        self.missing_or(object, field, "");
    }

    /// The same, with what else may be given, as it continues behind the fault.
    pub(crate) fn missing_or<K>(&self, object: &Reader<'_>, field: &Field<K>, other: &str) {
        let place = object.place_of(field);
        match self.entry {
            Some(entry) => {
                let offer = entry.substitute(field.name).map_or_else(String::new, offer);
                place.fault(format_args!("is required: the catalogue has no published value for `{}`{offer}{other}", entry.id()));
            }
            None if self.is_sound => place.fault(format_args!("is required{other}")),
            None => {}
        }
    }
}

/// Says what would be taken if it might be assumed.
fn offer(Substitute { value, unit, reason, .. }: &Substitute) -> String {
    format!("; with \"assume\": true it is {}, {reason}", with_unit(*value, unit))
}
