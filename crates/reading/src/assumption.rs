//! Values that a reader takes for fields that were not sent, where the request allows it. The answer has to tell them.

use std::cell::RefCell;

/// A value that was taken for a field that was not sent.
#[derive(Debug, Clone, PartialEq)]
pub struct Assumption {
    /// The field with a dot between the names of objects and their fields: `soil.cohesion_pa`.
    pub field: String,
    /// The entry that lacks it.
    pub preset: String,
    /// Its value.
    pub value: f64,
    /// Why this value.
    pub reason: String,
}

/// What was assumed of a request: no list where nothing may be.
#[derive(Default)]
pub(crate) struct Assumptions(RefCell<Option<Vec<Assumption>>>);

impl Assumptions {
    pub(crate) fn allow(&self) {
        self.0.borrow_mut().get_or_insert_default();
    }

    pub(crate) fn are_allowed(&self) -> bool {
        self.0.borrow().is_some()
    }

    /// Adds an assumption. A part of a request may be read more than once, so that a field that is there already stays as it is.
    pub(crate) fn add(&self, assumption: impl FnOnce() -> Assumption) {
        if let Some(list) = self.0.borrow_mut().as_mut() {
            let assumption = assumption();
            if list.iter().all(|known| known.field != assumption.field) {
                list.push(assumption);
            }
        }
    }

    pub(crate) fn list(&self) -> Option<Vec<Assumption>> {
        self.0.borrow().clone()
    }
}

#[cfg(test)]
mod tests {
    use crate::{Faults, Hints, Scope};

    #[test]
    fn a_value_is_assumed_once_and_only_where_that_is_allowed() {
        let faults = Faults::new(&Hints::NONE);
        let root = Scope::root(&faults);
        let soil = root.field("stations").item(1);
        let soil = soil.field("soil");
        soil.field("cohesion_pa").assume("sand", 1.0, "early");
        assert_eq!(faults.assumptions(), None);
        root.allow_assumptions();
        let apart = Faults::apart(&root);
        Scope::root(&apart).field("slip").assume("sand", 0.2, "apart");
        soil.field("cohesion_pa").assume("sand", 2.0, "first");
        soil.field("cohesion_pa").assume("sand", 3.0, "again");
        root.assume_all(apart.assumptions().expect("allowed"));
        let told: Vec<_> = faults.assumptions().expect("allowed").into_iter().map(|one| (one.field, one.value)).collect();
        assert_eq!(told, [("stations.1.soil.cohesion_pa".to_owned(), 2.0), ("slip".to_owned(), 0.2)]);
    }
}
