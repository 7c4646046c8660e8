//! Does the caller still want the result? A rover is asked after before each wheel, and a no ends it at once.

use std::cell::Cell;

use super::VehicleError;
use crate::error::Error;

/// The caller's answer. A no is final.
pub(super) struct Consent<'a> {
    go_on: &'a dyn Fn() -> bool,
    is_withdrawn: Cell<bool>,
}

impl<'a> Consent<'a> {
    pub(super) fn new(go_on: &'a dyn Fn() -> bool) -> Self {
        Self { go_on, is_withdrawn: Cell::new(false) }
    }

    /// Asks the caller, who is not asked again after a no.
    ///
    /// # Errors
    /// Any error that ends a search; [`Consent::kept`] says what it stands for.
    pub(super) fn ask(&self) -> Result<(), Error> {
        if !self.is_withdrawn.get() && !(self.go_on)() {
            self.is_withdrawn.set(true);
        }
        if self.is_withdrawn.get() { Err(Error::NotFinite) } else { Ok(()) }
    }

    /// What was found, unless the caller said no on the way: searches pass over points without an answer, so that whatever they
    /// then found stands for nothing.
    pub(super) fn kept<T>(&self, found: Result<T, VehicleError>) -> Result<T, VehicleError> {
        if self.is_withdrawn.get() { Err(VehicleError::Stopped) } else { found }
    }
}
