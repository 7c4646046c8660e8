//! The numbers that can be fitted, by name, with what may be sent for each: a start, and bounds.

use terramechanics_identification::{Range, Unknown};
use terramechanics_reading::{Bounds, Field, Kind, Number, Object, Reader, Word, group};

use crate::request::laws::own_field;
use crate::request::soil::COHESION;

/// Every unknown with the field that it has elsewhere in a request: a fitted value is sent back where it can be used.
static UNKNOWNS: [(Unknown, Field<Number>); Unknown::ALL.len()] = {
    let mut fields = [(Unknown::COHESION, COHESION); Unknown::ALL.len()];
    let mut i = 0;
    while i < fields.len() {
        fields[i] = (Unknown::ALL[i], own_field(Unknown::ALL[i].parameter()));
        i += 1;
    }
    fields
};

const TABLE: [(&str, Unknown); UNKNOWNS.len()] = {
    let mut names = [("", Unknown::COHESION); UNKNOWNS.len()];
    let mut i = 0;
    while i < names.len() {
        names[i] = (UNKNOWNS[i].1.name, UNKNOWNS[i].0);
        i += 1;
    }
    names
};
/// The names of all unknowns.
pub(crate) const NAMES: Word<Unknown> = Word::new(&TABLE);

/// The starts, each with the bounds of its unknown.
static STARTS: [Field<Number>; UNKNOWNS.len()] = {
    let mut fields = [COHESION; UNKNOWNS.len()];
    let mut i = 0;
    while i < fields.len() {
        fields[i] = UNKNOWNS[i].1;
        i += 1;
    }
    fields
};
static BOUNDS: [Field<Bounds>; UNKNOWNS.len()] = {
    let mut fields = [Field::new("", "The lower and the upper bound.", Bounds(COHESION.kind)); UNKNOWNS.len()];
    let mut i = 0;
    while i < fields.len() {
        fields[i] = Field::new(STARTS[i].name, "The lower and the upper bound.", Bounds(STARTS[i].kind));
        i += 1;
    }
    fields
};

const FIT_START: Object = Object {
    name: "FitStart",
    doc: "Where the search begins, by parameter; else at the soil's value if it has one, else at a usual one.",
    groups: &[&group(&STARTS)],
};
const FIT_BOUNDS: Object = Object {
    name: "FitBounds",
    doc: "Lower and upper bound of a parameter; without them, the range of all soils.",
    groups: &[&group(&BOUNDS)],
};
pub(crate) const START: Field<&Object> = Field::new("start", "Where the search begins.", &FIT_START);
pub(crate) const BOUNDS_FIELD: Field<&Object> = Field::new("bounds", "Bounds of the parameters.", &FIT_BOUNDS);

/// Values by unknown.
pub(crate) type By<T> = Vec<(Unknown, T)>;

/// The value of an unknown.
pub(crate) fn of<T: Copy>(values: &[(Unknown, T)], unknown: Unknown) -> Option<T> {
    values.iter().find(|(known, _)| *known == unknown).map(|(_, value)| *value)
}

/// The starts that were sent; one of a parameter that is not fitted is reported.
pub(crate) fn starts(object: &Reader<'_>, fitted: Option<&[Unknown]>) -> By<f64> {
    by_unknown(object, &START, &STARTS, fitted, |start| start)
}

/// The bounds that were sent; those of a parameter that is not fitted are reported.
pub(crate) fn bounds(object: &Reader<'_>, fitted: Option<&[Unknown]>) -> By<Range> {
    by_unknown(object, &BOUNDS_FIELD, &BOUNDS, fitted, |[lower, upper]| Range::new(lower, upper))
}

fn by_unknown<K: for<'a> Kind<Value<'a> = V>, V, T>(
    object: &Reader<'_>,
    field: &Field<&'static Object>,
    fields: &'static [Field<K>],
    fitted: Option<&[Unknown]>,
    make: impl Fn(V) -> T,
) -> By<T> {
    let Some(Some(values)) = object.optional(field) else { return Vec::new() };
    let read = |(field, (unknown, _)): (&'static Field<K>, &(Unknown, Field<Number>))| {
        // It would have no effect.
        if values.has(field) && fitted.is_some_and(|fitted| !fitted.contains(unknown)) {
            values.place_of(field).fault("is not among the parameters of `fit`");
        }
        values.optional(field).flatten().map(|value| (*unknown, make(value)))
    };
    fields.iter().zip(&UNKNOWNS).filter_map(read).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_unknown_has_a_name_of_its_own() {
        for unknown in Unknown::ALL {
            assert_eq!(NAMES.words.iter().filter(|(known, _)| *known == unknown.name()).count(), 1, "{unknown:?}");
        }
    }
}
