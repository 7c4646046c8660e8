//! Values that were never published, taken where a request allows it.

use terramechanics_reading::{Assumption, Field, FieldFault, Flag, Node, Object, Reader, read_assuming};

use super::Request;
use crate::words::HINTS;

pub(crate) const ASSUME: Field<Flag> = Field::new(
    "assume",
    "true: where the catalogue has no published value for a preset, its substitute is taken, see `assumed` in /v1/soils and /v1/wheels; the answer lists what was assumed. Else such a value is required.",
    Flag,
);

/// A checked request, and what was assumed of it.
pub(crate) struct Accepted<R> {
    pub(crate) case: R,
    /// No list where nothing may be assumed.
    pub(crate) assumed: Option<Vec<Assumption>>,
}

/// The request in a body or a query with what was assumed of it, or all its faults.
pub(crate) fn accepted<R: Request>(node: &Node<'_>) -> Result<Accepted<R>, Vec<FieldFault>> {
    accepted_by(node, R::OBJECT, R::read)
}

/// What `check` makes of a request with the fields of `object`, and what it assumed.
pub(crate) fn accepted_by<T>(
    node: &Node<'_>,
    object: &Object,
    check: impl FnOnce(&Reader<'_>) -> Option<T>,
) -> Result<Accepted<T>, Vec<FieldFault>> {
    let (case, assumed) = read_assuming(node, object, &HINTS, |object| {
        let assume = object.optional(&ASSUME);
        if assume == Some(Some(true)) {
            object.place().allow_assumptions();
        }
        let case = check(object);
        assume.and(case)
    })?;
    Ok(Accepted { case, assumed })
}
