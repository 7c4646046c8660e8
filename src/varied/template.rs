//! A request with fields that vary.

use std::sync::Arc;

use terramechanics_reading::{Assumption, FieldFault, Node, Path, Slot};

use super::faults::{RowFault, shared};
use super::row::Varied;
use super::setter::Setter;
use crate::request::{Accepted, accepted};

/// A request whose varied fields are written anew for each row. Its clones are independent of each other, one for each thread.
#[derive(Debug)]
pub(crate) struct Template<R> {
    tree: Node<'static>,
    slots: Vec<Slot>,
    paths: Vec<Path>,
    pointers: Vec<String>,
    /// A case that was read, in which numbers can be replaced, once there is one.
    direct: Direct<R>,
    /// What was assumed of the last good row: the same for all, for it depends on the fields that are there.
    assumed: Option<Vec<Assumption>>,
}

/// The way to a case past the tree.
#[derive(Debug)]
enum Direct<R> {
    /// No case was read so far.
    Unknown,
    /// There is none.
    Closed,
    Open(Arc<R>, Vec<Setter>),
}

impl<R> Clone for Direct<R> {
    fn clone(&self) -> Self {
        match self {
            Self::Unknown => Self::Unknown,
            Self::Closed => Self::Closed,
            Self::Open(case, setters) => Self::Open(case.clone(), setters.clone()),
        }
    }
}

impl<R> Clone for Template<R> {
    fn clone(&self) -> Self {
        let Self { tree, slots, paths, pointers, direct, assumed } = self;
        Self {
            tree: tree.clone(),
            slots: slots.clone(),
            paths: paths.clone(),
            pointers: pointers.clone(),
            direct: direct.clone(),
            assumed: assumed.clone(),
        }
    }
}

impl<R: Varied> Template<R> {
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
        if !faults.is_empty() {
            return Err(faults);
        }
        Ok(Self { tree, slots, paths: paths.to_vec(), pointers, direct: Direct::Unknown, assumed: None })
    }

    /// The case of a row: the request in which the varied fields have these values, in the order of the paths.
    ///
    /// # Errors
    /// The faults that the operation finds in that request, with the pointers that they have there.
    pub(crate) fn case(&mut self, values: &[f64]) -> Result<R, Vec<FieldFault>> {
        if let Direct::Open(case, setters) = &self.direct
            && let Some(case) = case.with_numbers(setters, values)
        {
            return Ok(case);
        }
        self.read(values)
    }

    /// The same by reading the request anew.
    fn read(&mut self, values: &[f64]) -> Result<R, Vec<FieldFault>> {
        for (slot, value) in self.slots.iter().zip(values) {
            self.tree.set(slot, *value);
        }
        let Accepted { case, assumed } = accepted::<R>(&self.tree)?;
        self.assumed = assumed;
        if matches!(self.direct, Direct::Unknown) {
            self.direct = self.direct_of(&case, values).unwrap_or(Direct::Closed);
        }
        Ok(case)
    }

    /// The way past the tree from a case that was read.
    fn direct_of(&self, case: &R, values: &[f64]) -> Option<Direct<R>> {
        let setters = case.setters(&self.paths, &|names| self.tree.has(names))?;
        let same = case.with_numbers(&setters, values)?;
        Some(Direct::Open(Arc::new(same), setters))
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

    /// Takes over what was assumed of a clone.
    pub(crate) fn assume(&mut self, assumed: Option<&[Assumption]>) {
        self.assumed = assumed.map(<[Assumption]>::to_vec);
    }

    /// What was assumed of the request; no list where nothing may be.
    pub(crate) fn assumed(&self) -> Option<&[Assumption]> {
        self.assumed.as_deref()
    }
}

#[cfg(test)]
mod tests;
