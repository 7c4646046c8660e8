//! A field together with its name and what is allowed for it.

use super::{Field, Scope, Wire};

/// One field of a request object, ready to be checked.
pub(crate) struct Entry<'a, T: Wire> {
    pub(crate) name: &'static str,
    pub(crate) field: &'a Field<T>,
    pub(crate) spec: &'static T::Spec,
}

impl<'a, T: Wire> Entry<'a, T> {
    /// The value if one was sent; a value of a wrong type is reported to `object`, the scope of the object that has the field.
    pub(crate) fn given(&self, object: &Scope<'_>) -> Option<&'a T> {
        match self.field {
            Field::Absent => None,
            Field::Given(value) => Some(value),
            Field::Wrong(found) => {
                object.field(self.name).fault(format_args!("must be {}, not {found}", T::EXPECTED));
                None
            }
        }
    }

    /// The value; that none was sent is reported.
    pub(crate) fn required(&self, object: &Scope<'_>) -> Option<&'a T> {
        if matches!(self.field, Field::Absent) {
            object.field(self.name).fault("is required");
        }
        self.given(object)
    }

    /// What was sent, right or wrong, else what `other` has.
    pub(crate) fn or(&self, other: &Field<T>) -> Field<T>
    where
        T: Clone,
    {
        if self.is_present() { self.field.clone() } else { other.clone() }
    }

    /// Whether something was sent, right or wrong.
    pub(crate) fn is_present(&self) -> bool {
        !matches!(self.field, Field::Absent)
    }
}
