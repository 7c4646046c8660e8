//! Does the caller still want the result? A fit asks about every millisecond, and a no ends it at once.

use std::cell::Cell;
use std::fmt;

/// Points of a curve, or rows of a matrix, between two questions: some tens to hundreds of microseconds of work.
pub(crate) const POINTS_PER_QUESTION: usize = 1024;

/// The caller's answer. A no is final.
pub(crate) struct Consent<'a> {
    go_on: &'a dyn Fn() -> bool,
    is_withdrawn: Cell<bool>,
}

/// The caller does not want the result any more.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) struct Stopped;

impl<'a> Consent<'a> {
    pub(crate) fn new(go_on: &'a dyn Fn() -> bool) -> Self {
        Self { go_on, is_withdrawn: Cell::new(false) }
    }

    /// Asks the caller, who is not asked again after a no.
    pub(crate) fn ask(&self) -> Result<(), Stopped> {
        if !self.is_withdrawn.get() && !(self.go_on)() {
            self.is_withdrawn.set(true);
        }
        if self.is_withdrawn.get() { Err(Stopped) } else { Ok(()) }
    }

    /// Whether the caller has said no. It does not ask again.
    pub(crate) fn is_withdrawn(&self) -> bool {
        self.is_withdrawn.get()
    }
}

impl fmt::Debug for Consent<'_> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.debug_struct("Consent").field("is_withdrawn", &self.is_withdrawn).finish_non_exhaustive()
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_no_is_final_and_not_asked_for_twice() {
        let asked = Cell::new(0);
        let go_on = || {
            asked.set(asked.get() + 1);
            asked.get() != 2 // a caller who changes its mind
        };
        let consent = Consent::new(&go_on);
        assert_eq!(consent.ask(), Ok(()));
        assert!(!consent.is_withdrawn());
        assert_eq!((consent.ask(), consent.ask()), (Err(Stopped), Err(Stopped)));
        assert!(consent.is_withdrawn());
        assert_eq!(asked.get(), 2);
    }
}
