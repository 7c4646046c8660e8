//! Faults of a request, collected with where they are.

use std::cell::RefCell;
use std::fmt::Display;

use serde::Serialize;
use utoipa::ToSchema;

/// One thing wrong with a request.
#[derive(Debug, Clone, PartialEq, Serialize, ToSchema)]
pub(crate) struct FieldFault {
    /// JSON pointer (RFC 6901) to the field at fault; empty for the request as a whole.
    #[schema(example = "/soil/cohesion_pa")]
    pub pointer: String,
    /// What is wrong with it.
    #[schema(example = "must be from 0 to 1e9, not -5")]
    pub detail: String,
}

/// A place in a request, to which faults are reported.
///
/// A place is a link to the one around it, so that nothing is allocated until there is a fault.
#[derive(Clone, Copy)]
pub(crate) struct Scope<'a> {
    around: Option<&'a Scope<'a>>,
    name: Name,
    faults: &'a RefCell<Vec<FieldFault>>,
}

#[derive(Clone, Copy)]
enum Name {
    Field(&'static str),
    Item(usize),
}

impl<'a> Scope<'a> {
    /// The request as a whole.
    pub(crate) fn root(faults: &'a RefCell<Vec<FieldFault>>) -> Self {
        Self { around: None, name: Name::Field(""), faults }
    }

    /// The place of a field of this object.
    pub(crate) fn field(&'a self, name: &'static str) -> Self {
        Self { around: Some(self), name: Name::Field(name), faults: self.faults }
    }

    /// The place of an item of this array.
    pub(crate) fn item(&'a self, index: usize) -> Self {
        Self { around: Some(self), name: Name::Item(index), faults: self.faults }
    }

    /// Reports a fault of this place.
    pub(crate) fn fault(&self, detail: impl Display) {
        self.faults.borrow_mut().push(FieldFault { pointer: self.pointer(), detail: detail.to_string() });
    }

    /// Reports a name that stands in a table of variants and that nothing reads: a new one must not become another.
    pub(crate) fn unread<T>(&self, name: &str) -> Option<T> {
        self.fault(format_args!("`{name}` is not computed"));
        None
    }

    /// Reports a fault of a field whose name came from the client.
    pub(crate) fn fault_of(&self, name: &str, detail: impl Display) {
        let pointer = format!("{}/{}", self.pointer(), name.replace('~', "~0").replace('/', "~1"));
        self.faults.borrow_mut().push(FieldFault { pointer, detail: detail.to_string() });
    }

    /// Reports a fault whose pointer starts from this place.
    pub(crate) fn pass_on(&self, fault: FieldFault) {
        let pointer = self.pointer() + &fault.pointer;
        self.faults.borrow_mut().push(FieldFault { pointer, ..fault });
    }

    fn pointer(&self) -> String {
        match (self.around, self.name) {
            (None, _) => String::new(),
            (Some(around), Name::Field(name)) => format!("{}/{name}", around.pointer()),
            (Some(around), Name::Item(index)) => format!("{}/{index}", around.pointer()),
        }
    }
}
