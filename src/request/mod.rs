//! Requests as a client writes them, and what they become: the only place where input is checked and converted.
//!
//! A part of a request (the wheel, the motion, the sinkage) is declared, read and turned into its domain value in one file here. The
//! request of an operation, which stands in its room, names its groups of fields and calls their readers.

pub(crate) mod assume;
pub(crate) mod axis;
pub(crate) mod circles;
mod contact;
mod documented;
pub(crate) mod fitted_law;
pub(crate) mod laws;
pub(crate) mod method;
pub(crate) mod motion;
pub(crate) mod operation;
pub(crate) mod preset;
pub(crate) mod pull;
mod refusal;
pub(crate) mod side_slip;
pub(crate) mod sinkage;
pub(crate) mod soil;
pub(crate) mod system;
pub(crate) mod unknowns;
pub(crate) mod unused;
mod weights;
pub(crate) mod wheel;

pub(crate) use assume::{Accepted, accepted};
pub(crate) use documented::{Described, Documented, Shape};
pub(crate) use refusal::{error_fault, error_pointer, sinkage_figures};

use terramechanics_reading::{FieldFault, Node, Object, Reader};

/// A checked request: valid domain values in SI units.
pub(crate) trait Request: Sized + Send + 'static {
    /// What a client may write.
    const OBJECT: &'static Object;

    /// Checks everything and reports every fault; none only where something was reported.
    fn read(object: &Reader<'_>) -> Option<Self>;
}

/// The request in a body or a query, or all its faults.
pub(crate) fn checked<R: Request>(node: &Node<'_>) -> Result<R, Vec<FieldFault>> {
    accepted(node).map(|accepted| accepted.case)
}
