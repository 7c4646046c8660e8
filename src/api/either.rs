//! Forces or a rover: what the operations take and give that ask a request of either kind many times.

use terramechanics_reading::{Field, Nested, Word};

use super::forces::ForcesCase;
use super::vehicle::{VehicleCase, rover_columns};
use crate::quantity;
use crate::request::Request;

/// Which of the two is asked.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) enum Of {
    Forces,
    Vehicle,
}

/// The requests of the two.
pub(super) const REQUESTS: Nested = Nested { requests: &[ForcesCase::OBJECT, VehicleCase::OBJECT] };

/// The field that says which.
pub(super) const fn of(meaning: &'static str) -> Field<Word<Of>> {
    Field::required("of", meaning, Word::new(&[("forces", Of::Forces), ("vehicle", Of::Vehicle)]))
}

/// The quantities that the answer may have, each once.
pub(super) fn fields() -> Vec<quantity::Field> {
    let mut fields: Vec<quantity::Field> = Vec::new();
    for about in quantity::every_point_column().map(|(about, _)| about).chain(rover_columns()) {
        if fields.iter().all(|known| known.about.name != about.name) {
            fields.push(quantity::Field { present: Some("where that operation has it"), ..quantity::Field::or_null(about) });
        }
    }
    fields
}
