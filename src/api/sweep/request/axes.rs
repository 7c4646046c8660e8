//! The axes of a sweep: which field varies, and the values that it takes.

use terramechanics_reading::{Field, Label, Number, Numbers, Object, Objects, Path, Reader, Scope, Word};

use crate::request::axis::spread_at;
use crate::varied::varied_field;

/// Most points of a sweep.
pub(crate) const MOST_POINTS: usize = 1_000_000;
/// Most values of a list.
const MOST_VALUES: usize = 100_000;
/// Most axes.
pub(crate) const MOST_AXES: usize = 3;

const FIELD: Field<Label> = Field::required(
    "field",
    "The field that varies: the JSON pointer of any numeric field of the request, such as /wheel/radius_m or /soil/pressure_sinkage/n0, whether or not the request has it.",
    Label,
);
const FROM: Field<Number> =
    Field::new("from", "First value; with `to` and `points`, or `values` in their place.", Number::any(""));
const TO: Field<Number> = Field::new("to", "Last value.", Number::any(""));
const POINTS: Field<Number> = Field::new("points", "Number of values.", Number::new("1", 2.0, MOST_POINTS as f64).whole());
const SPACING: Field<Word<Spacing>> = Field::new(
    "spacing",
    "linear: equal steps; log: equal ratios, for two ends of one sign that are not 0. Both ends are included.",
    Word::new(&[("linear", Spacing::Linear), ("log", Spacing::Log)]).or(Spacing::Linear),
);
const VALUES: Field<Numbers> =
    Field::new("values", "The values themselves, in the order of the rows.", Numbers::new(Number::any(""), 1, MOST_VALUES));

const AXIS: Object = Object {
    name: "SweepAxis",
    doc: "A field and its values: `from`, `to` and `points`, or `values`.",
    groups: &[&[&FIELD, &FROM, &TO, &POINTS, &SPACING, &VALUES]],
};

pub(super) const AXES: Field<Objects> = Field::required(
    "axes",
    "The fields that vary. The rows are all combinations of their values, the last axis fastest.",
    Objects { object: &AXIS, fewest: 1, most: MOST_AXES },
);

/// How the values of an axis lie between its ends.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) enum Spacing {
    Linear,
    Log,
}

/// A field with its values.
#[derive(Debug, Clone)]
pub(crate) struct Axis {
    pub(crate) path: Path,
    pub(crate) steps: Steps,
}

/// The values of an axis. Those between two ends are computed where they are needed: a short request may ask for many.
#[derive(Debug, Clone)]
pub(crate) enum Steps {
    /// As they were sent.
    List(Vec<f64>),
    /// So many between two ends, which are included.
    Between { from: f64, to: f64, points: u32, spacing: Spacing },
}

impl Steps {
    /// Number of values, at least one.
    pub(crate) fn len(&self) -> usize {
        match self {
            Self::List(values) => values.len(),
            Self::Between { points, .. } => *points as usize,
        }
    }

    /// The value of that place, which is below their number.
    pub(crate) fn at(&self, i: usize) -> f64 {
        match *self {
            Self::List(ref values) => values.get(i).copied().unwrap_or(f64::NAN),
            Self::Between { from, to, points, spacing: Spacing::Linear } => spread_at(from, to, f64::from(points), i as u32),
            Self::Between { from, to, points, spacing: Spacing::Log } => in_ratio(from, to, points, i as u32),
        }
    }
}

/// The axes, each of a field that `request` declares.
pub(super) fn read(object: &Reader<'_>, request: &'static Object) -> Option<Vec<Axis>> {
    let items = object.required(&AXES)?;
    let axes = items.each(|axis, _| {
        let field = axis.required(&FIELD).and_then(|pointer| varied_field(request, pointer, &axis.place_of(&FIELD)));
        let steps = steps(axis, field.as_ref().map(|(_, number)| number));
        Some(Axis { path: field?.0, steps: steps? })
    })?;
    let points = axes.iter().fold(1.0, |points, axis| points * axis.steps.len() as f64);
    if points > MOST_POINTS as f64 {
        object.place_of(&AXES).fault(format_args!("make {points} points; at most {MOST_POINTS} are computed"));
        return None;
    }
    Some(axes)
}

/// The place of the field of an axis.
pub(super) fn fault_of_field(object: &Reader<'_>, axis: usize, detail: &str) {
    object.place_of(&AXES).item(axis).field(FIELD.name).fault(detail);
}

/// The values of an axis, each within the bounds of its field where that is known.
fn steps(axis: &Reader<'_>, number: Option<&Number>) -> Option<Steps> {
    let (from, to, points) = (axis.optional(&FROM), axis.optional(&TO), axis.optional(&POINTS));
    let (spacing, list) = (axis.or_default(&SPACING), axis.optional(&VALUES));
    let is_within = |place: &Scope<'_>, value: f64| number.is_none_or(|number| number.check(place, value).is_some());
    if axis.has(&VALUES) {
        for name in [axis.has(&FROM).then_some(FROM.name), axis.has(&TO).then_some(TO.name)].into_iter().flatten() {
            axis.place().field(name).fault("give either `values` or `from`, `to` and `points`");
        }
        for name in [axis.has(&POINTS).then_some(POINTS.name), axis.has(&SPACING).then_some(SPACING.name)].into_iter().flatten() {
            axis.place().field(name).fault("belongs to `from` and `to`; `values` are taken as they are");
        }
        let place = axis.place_of(&VALUES);
        let list = list.flatten()?;
        let wrong = list.iter().enumerate().filter(|(_, value)| number.is_some_and(|number| !number.allows(**value)));
        let mut is_sound = true;
        for (i, value) in wrong.take(10) {
            is_sound &= is_within(&place.item(i), *value);
        }
        return is_sound.then(|| Steps::List(list.to_vec()));
    }
    for field in [&FROM, &TO, &POINTS].into_iter().filter(|field| !axis.has(field)) {
        axis.place_of(field).fault("is required, or `values` in place of `from`, `to` and `points`");
    }
    let (from, to) = (from.flatten(), to.flatten());
    let ends = [(&FROM, from), (&TO, to)].map(|(field, end)| end.filter(|end| is_within(&axis.place_of(field), *end)));
    let (Some(from), Some(to)) = (from, to) else { return None };
    if from == to {
        axis.place_of(&TO).fault("must differ from `from`; a single value can stand in `values`");
        return None;
    }
    let spacing = spacing?;
    if spacing == Spacing::Log && (from == 0.0 || to == 0.0 || (from < 0.0) != (to < 0.0)) {
        let place = axis.place_of(if from == 0.0 { &FROM } else { &TO });
        place.fault("must not be 0 and must have the sign of the other end, because the values have equal ratios");
        return None;
    }
    let ([Some(_), Some(_)], points) = (ends, points.flatten()?) else { return None };
    Some(Steps::Between { from, to, points: points as u32, spacing })
}

/// The number of that place among so many with equal ratios, from 0.
fn in_ratio(from: f64, to: f64, points: u32, i: u32) -> f64 {
    let last = points - 1;
    match i {
        0 => from,
        i if i == last => to,
        // Powers of each end by itself do not overflow where the ratio would.
        i => {
            let share = f64::from(i) / f64::from(last);
            from.signum() * from.abs().powf(1.0 - share) * to.abs().powf(share)
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn ratios_are_equal_and_ends_exact() {
        let decades: Vec<f64> = (0..7).map(|i| in_ratio(1e-300, 1e300, 7, i)).collect();
        assert_eq!((decades.len(), decades[0], decades[6]), (7, 1e-300, 1e300));
        for pair in decades.windows(2) {
            assert!((pair[1] / pair[0] / 1e100 - 1.0).abs() < 1e-12, "{pair:?}");
        }
        assert!((in_ratio(-1.0, -4.0, 3, 1) + 2.0).abs() < 1e-15);
    }
}
