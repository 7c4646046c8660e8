//! The function as the searches see it: on shares of the bounds, counted, within the budget, and ended where its caller has had
//! enough.

use std::cell::{Cell, RefCell};
use std::fmt;

use crate::archive::{Archive, Seen};
use crate::task::Task;

/// Why a function has no outputs.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Refusal {
    /// There is no answer at this point.
    NoAnswer,
    /// Its caller does not want the result any more.
    Stop,
}

/// A function of the variables: its outputs, or why there are none.
pub type Function<'f> = dyn FnMut(&[f64]) -> Result<Vec<f64>, Refusal> + 'f;

/// The caller did not want the result any more.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Stopped;

impl fmt::Display for Stopped {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str("stopped by the caller")
    }
}

impl std::error::Error for Stopped {}

/// Why a point was not evaluated.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum Ended {
    Budget,
    Stopped,
}

/// The function, with what it has told so far.
pub(crate) struct Ledger<'a> {
    task: &'a Task,
    function: RefCell<&'a mut Function<'a>>,
    archive: RefCell<Archive>,
    left: Cell<u32>,
    unanswered: Cell<u32>,
    is_stopped: Cell<bool>,
}

impl<'a> Ledger<'a> {
    pub(crate) fn new(task: &'a Task, function: &'a mut Function<'a>) -> Self {
        Self {
            task,
            function: RefCell::new(function),
            archive: RefCell::default(),
            left: Cell::new(task.params().evaluations),
            unanswered: Cell::new(0),
            is_stopped: Cell::new(false),
        }
    }

    /// What the function gives at these shares; nothing where it has no answer.
    pub(crate) fn at(&self, shares: &[f64]) -> Result<Option<Seen>, Ended> {
        if self.is_stopped.get() {
            return Err(Ended::Stopped);
        }
        let Some(left) = self.left.get().checked_sub(1) else { return Err(Ended::Budget) };
        let values = self.values(shares);
        match (self.function.borrow_mut())(&values) {
            Err(Refusal::Stop) => {
                self.is_stopped.set(true);
                Err(Ended::Stopped)
            }
            Ok(outputs) if outputs.len() == self.task.params().outputs && outputs.iter().all(|output| output.is_finite()) => {
                self.left.set(left);
                let seen = Seen { shares: shares.to_vec(), outputs };
                self.archive.borrow_mut().push(seen.clone());
                Ok(Some(seen))
            }
            Ok(_) | Err(Refusal::NoAnswer) => {
                self.left.set(left);
                self.unanswered.set(self.unanswered.get() + 1);
                Ok(None)
            }
        }
    }

    /// The values of the variables at these shares.
    pub(crate) fn values(&self, shares: &[f64]) -> Vec<f64> {
        self.task.params().variables.iter().zip(shares).map(|(variable, &share)| variable.at(share)).collect()
    }

    pub(crate) fn task(&self) -> &'a Task {
        self.task
    }

    /// All points with an answer so far.
    pub(crate) fn archive(&self) -> std::cell::Ref<'_, Archive> {
        self.archive.borrow()
    }

    /// Evaluations that are left.
    pub(crate) fn left(&self) -> u32 {
        self.left.get()
    }

    /// Evaluations so far.
    pub(crate) fn spent(&self) -> u32 {
        self.task.params().evaluations - self.left.get()
    }

    /// Evaluations that had no answer.
    pub(crate) fn unanswered(&self) -> u32 {
        self.unanswered.get()
    }

    /// # Errors
    /// That the caller has had enough.
    pub(crate) fn goes_on(&self) -> Result<(), Stopped> {
        if self.is_stopped.get() { Err(Stopped) } else { Ok(()) }
    }
}
