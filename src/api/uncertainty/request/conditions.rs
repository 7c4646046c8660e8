//! Conditions whose probability is asked for.

use terramechanics_reading::{Field, Label, Number, Object, Objects, Reader, Scope, unknown_word};

use crate::quantity::About;

/// Most conditions.
const MOST: usize = 16;

const QUANTITY: Field<Label> =
    Field::required("quantity", "A quantity of the answer by its name, such as longitudinal_force_n; no formula.", Label);
const BELOW: Field<Number> = Field::new("below", "The condition holds below this value.", Number::any(""));
const ABOVE: Field<Number> = Field::new("above", "It holds above this value.", Number::any(""));

const CONDITION: Object = Object {
    name: "UncertainCondition",
    doc: "A condition on a quantity of the answer: `below` or `above` a value. `climbs` of a rover is 1 or 0.",
    groups: &[&[&QUANTITY, &BELOW, &ABOVE]],
};
pub(super) const CONDITIONS: Field<Objects> =
    Field::new("conditions", "Conditions whose probability is asked for.", Objects { object: &CONDITION, fewest: 0, most: MOST });

/// On which side of a limit a condition holds.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum Side {
    Below,
    Above,
}

/// A condition on a column of an operation.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Condition {
    /// The place of the column.
    pub(crate) column: usize,
    pub(crate) side: Side,
    pub(crate) limit: f64,
}

impl Condition {
    pub(crate) fn holds(&self, value: f64) -> bool {
        match self.side {
            Side::Below => value < self.limit,
            Side::Above => value > self.limit,
        }
    }
}

/// The conditions on columns of an operation; where those are not known, the rest is checked.
pub(super) fn read(object: &Reader<'_>, columns: Option<&[&'static About]>) -> Option<Vec<Condition>> {
    let Some(items) = object.optional(&CONDITIONS)? else { return Some(Vec::new()) };
    items.each(|condition, _| {
        let quantity = condition.required(&QUANTITY);
        let (below, above) = (condition.optional(&BELOW), condition.optional(&ABOVE));
        let column = quantity.and_then(|name| column(name, columns?, &condition.place_of(&QUANTITY)));
        let (side, limit) = match (below?, above?) {
            (Some(limit), None) => (Side::Below, limit),
            (None, Some(limit)) => (Side::Above, limit),
            _ => {
                condition.place().fault(format_args!("needs either `{}` or `{}`", BELOW.name, ABOVE.name));
                return None;
            }
        };
        Some(Condition { column: column?, side, limit })
    })
}

/// The place of the column of that name; that there is none is reported.
pub(super) fn column(name: &str, columns: &[&'static About], place: &Scope<'_>) -> Option<usize> {
    let found = columns.iter().position(|about| about.name == name);
    if name.contains(|c: char| !c.is_ascii_alphanumeric() && c != '_') {
        place.fault("must be the name of one quantity of the answer; formulas are not taken here");
    } else if found.is_none() {
        let names: Vec<&str> = columns.iter().map(|about| about.name).collect();
        unknown_word(place, name, &names);
    }
    found
}
