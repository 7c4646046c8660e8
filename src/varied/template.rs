//! A request with fields that vary.

use std::marker::PhantomData;

use terramechanics_reading::{Assumption, FieldFault, Node, Path, Slot};

use super::faults::{RowFault, shared};
use crate::request::{Accepted, Request, accepted};

/// A request whose varied fields are written anew for each row. Its clones are independent of each other, one for each thread.
#[derive(Debug)]
pub(crate) struct Template<R> {
    tree: Node<'static>,
    slots: Vec<Slot>,
    pointers: Vec<String>,
    /// What was assumed of the last good row: the same for all, for it depends on the fields that are there.
    assumed: Option<Vec<Assumption>>,
    case: PhantomData<fn() -> R>,
}

impl<R> Clone for Template<R> {
    fn clone(&self) -> Self {
        let Self { tree, slots, pointers, assumed, case } = self;
        Self { tree: tree.clone(), slots: slots.clone(), pointers: pointers.clone(), assumed: assumed.clone(), case: *case }
    }
}

impl<R: Request> Template<R> {
    /// The template of `request`, in which the fields under `paths` vary, whether or not they stand in it. The paths are those of
    /// [`varied_field`](super::varied_field).
    ///
    /// # Errors
    /// That a field is there twice, or that something else stands in its way.
    pub(crate) fn new(request: &Node<'_>, paths: &[Path]) -> Result<Self, Vec<RowFault>> {
        let mut tree = request.detached();
        let (mut slots, mut faults) = (Vec::with_capacity(paths.len()), Vec::new());
        for (i, path) in paths.iter().enumerate() {
            let mut refuse =
                |detail: String| faults.push(RowFault { field: Some(i), fault: FieldFault::new(path.pointer(), detail) });
            if paths[..i].contains(path) {
                refuse(format!("`{}` is varied twice", path.pointer()));
                continue;
            }
            match tree.slot(path) {
                Ok(slot) => slots.push(slot),
                Err(blocked) => refuse(format!(
                    "leads nowhere: `{}` of the request is {}",
                    if blocked.pointer.is_empty() { "the whole" } else { &blocked.pointer },
                    blocked.found
                )),
            }
        }
        let pointers = paths.iter().map(Path::pointer).collect();
        if faults.is_empty() { Ok(Self { tree, slots, pointers, assumed: None, case: PhantomData }) } else { Err(faults) }
    }

    /// The case of a row: the request in which the varied fields have these values, in the order of the paths.
    ///
    /// # Errors
    /// The faults that the operation finds in that request, with the pointers that they have there.
    pub(crate) fn case(&mut self, values: &[f64]) -> Result<R, Vec<FieldFault>> {
        for (slot, value) in self.slots.iter().zip(values) {
            self.tree.set(slot, *value);
        }
        let Accepted { case, assumed } = accepted::<R>(&self.tree)?;
        self.assumed = assumed;
        Ok(case)
    }

    /// The first case of some `rows`, to tell what all cases have in common, such as the method.
    ///
    /// # Errors
    /// Where none of the rows makes a case and they share faults that no value mends: a field that is missing, a word that is not
    /// known, fields that exclude each other. Give it rows that differ in all varied fields, such as the corners of a grid; of a
    /// single row every fault counts but numbers out of bounds.
    pub(crate) fn first_case<'r>(&mut self, rows: impl Iterator<Item = &'r [f64]>) -> Result<Option<R>, Vec<RowFault>> {
        let mut of_rows = Vec::new();
        for row in rows {
            match self.case(row) {
                Ok(case) => return Ok(Some(case)),
                Err(faults) => of_rows.push(faults),
            }
        }
        let shared = shared(&of_rows, &self.pointers);
        if shared.is_empty() { Ok(None) } else { Err(shared) }
    }

    /// What was assumed of the request; no list where nothing may be.
    pub(crate) fn assumed(&self) -> Option<&[Assumption]> {
        self.assumed.as_deref()
    }
}
