//! A request with fields that vary.

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
    /// The latest case that was read for a row of its own.
    latest: Option<R>,
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
    Open(Box<R>, Vec<Setter>),
}

/// The clone reads a case of its own.
impl<R> Clone for Template<R> {
    fn clone(&self) -> Self {
        let Self { tree, slots, paths, pointers, direct: _, latest: _, assumed } = self;
        Self {
            tree: tree.clone(),
            slots: slots.clone(),
            paths: paths.clone(),
            pointers: pointers.clone(),
            direct: Direct::Unknown,
            latest: None,
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
        Ok(Self { tree, slots, paths: paths.to_vec(), pointers, direct: Direct::Unknown, latest: None, assumed: None })
    }

    /// The case of a row: the request in which the varied fields have these values, in the order of the paths.
    ///
    /// # Errors
    /// The faults that the operation finds in that request, with the pointers that they have there.
    pub(crate) fn case(&mut self, values: &[f64]) -> Result<&R, Vec<FieldFault>> {
        self.case_and_assumed(values).map(|(case, _)| case)
    }

    /// The same with what was assumed of it.
    ///
    /// # Errors
    /// As [`case`](Self::case).
    pub(crate) fn case_and_assumed(&mut self, values: &[f64]) -> Result<(&R, &[Assumption]), Vec<FieldFault>> {
        let is_set = match &mut self.direct {
            Direct::Open(case, setters) => case.set_numbers(setters, values),
            Direct::Unknown | Direct::Closed => false,
        };
        if !is_set {
            self.latest = Some(self.read(values)?);
        }
        let case = match &self.direct {
            Direct::Open(case, _) if is_set => Some(&**case),
            _ => self.latest.as_ref(),
        };
        Ok((case.ok_or_else(Vec::new)?, self.assumed.as_deref().unwrap_or_default()))
    }

    /// The same by reading the request anew.
    fn read(&mut self, values: &[f64]) -> Result<R, Vec<FieldFault>> {
        for (slot, value) in self.slots.iter().zip(values) {
            self.tree.set(slot, *value);
        }
        let Accepted { case, assumed } = accepted::<R>(&self.tree)?;
        self.assumed = assumed;
        if matches!(self.direct, Direct::Unknown) {
            self.direct = self.direct_of(&case, values)?;
        }
        Ok(case)
    }

    /// The way past the tree, by the setters of a case that was read; the case is read once more for it.
    fn direct_of(&self, case: &R, values: &[f64]) -> Result<Direct<R>, Vec<FieldFault>> {
        let Some(setters) = case.setters(&self.paths, &|names| self.tree.has(names)) else { return Ok(Direct::Closed) };
        let Accepted { case: mut own, .. } = accepted::<R>(&self.tree)?;
        Ok(if own.set_numbers(&setters, values) { Direct::Open(Box::new(own), setters) } else { Direct::Closed })
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
            match self.read(row) {
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
