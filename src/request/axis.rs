//! The slips of a sweep: a range or a list.

use terramechanics::Slip;
use terramechanics_reading::{Alternative, Either, Field, Number, Numbers, Object, OneOf, Reader};

use super::motion::RATIO;

/// Points of a range.
pub(crate) const FEWEST: usize = 2;
pub(crate) const MOST: usize = 10_001;

const FROM: Field<Number> = Field::required("from", "First slip (–).", RATIO);
const TO: Field<Number> = Field::required("to", "Last slip (–).", RATIO);
const POINTS: Field<Number> = Field::required("points", "Number of slips.", Number::new("1", FEWEST as f64, MOST as f64).whole());

const RANGE: Object =
    Object { name: "SlipRange", doc: "Equally spaced slips, both ends included.", groups: &[&[&FROM, &TO, &POINTS]] };

/// The slips of a sweep.
pub(crate) const SLIPS: Field<OneOf> = Field::required(
    "slip",
    "The slips: a range, or a list.",
    OneOf::new(
        "an object with `from`, `to` and `points` (in a query `slip.from`, `slip.to` and `slip.points`), or an array of numbers",
        &[Alternative::Object(&RANGE, "Equally spaced slips."), Alternative::Numbers(Numbers::new(RATIO, FEWEST, MOST))],
    ),
);

/// One slip, or those of a sweep.
pub(crate) const SLIP_OR_SLIPS: Field<OneOf> = Field::required(
    "slip",
    "One slip, or the slips as a range or a list.",
    OneOf::new(
        "a number, an object with `from`, `to` and `points`, or an array of numbers",
        &[
            Alternative::Number(RATIO),
            Alternative::Object(&RANGE, "Equally spaced slips."),
            Alternative::Numbers(Numbers::new(RATIO, 1, MOST)),
        ],
    ),
);

/// The slips, of which there is at least one.
pub(crate) fn read(object: &Reader<'_>, field: &Field<OneOf>) -> Option<Vec<Slip>> {
    match object.required(field)? {
        Either::Number(slip) => Some(vec![Slip::new(slip).ok()?]),
        Either::Numbers(slips) => slips.iter().map(|&slip| Slip::new(slip).ok()).collect(),
        Either::Object(range) => spaced(&range),
        Either::Word => None,
    }
}

fn spaced(range: &Reader<'_>) -> Option<Vec<Slip>> {
    let (from, to, points) = (range.required(&FROM), range.required(&TO), range.required(&POINTS));
    let (from, to, points) = (from?, to?, points?);
    spread(from, to, points).map(|slip| Slip::new(slip).ok()).collect()
}

/// So many equally spaced numbers, both ends included.
pub(crate) fn spread(from: f64, to: f64, points: f64) -> impl Iterator<Item = f64> {
    (0..points as u32).map(move |i| spread_at(from, to, points, i))
}

/// The number of that place among so many, from 0.
pub(crate) fn spread_at(from: f64, to: f64, points: f64, i: u32) -> f64 {
    equally_spaced(from, to, f64::from(i) / (points - 1.0))
}

/// The number at `share` of the way between two others. Where a number of 14 decimals is as near as rounding can tell, it is
/// that one: a tenth of a range is then the number that people write, and rolling is 0 and not the dust of a rounding.
fn equally_spaced(from: f64, to: f64, share: f64) -> f64 {
    const DECIMALS: f64 = 1e14;
    if share == 0.0 || share == 1.0 {
        return if share == 0.0 { from } else { to };
    }
    let between = from + (to - from) * share;
    let written = (between * DECIMALS).round() / DECIMALS;
    let rounding = 2.0 * f64::EPSILON * from.abs().max(to.abs());
    let slip = if (written - between).abs() <= rounding { written } else { between };
    // Rounding carries none beyond the ends; adding 0 turns −0 into 0.
    slip.clamp(from.min(to), from.max(to)) + 0.0
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn equally_spaced_slips_are_the_numbers_that_people_write() {
        let slips = |from, to, steps: u32| (0..=steps).map(move |i| equally_spaced(from, to, f64::from(i) / f64::from(steps)));
        let braking_to_spinning: Vec<f64> = slips(-0.5, 1.0, 150).collect();
        assert_eq!(braking_to_spinning[50], 0.0);
        assert!(braking_to_spinning[50].is_sign_positive());
        for (i, slip) in braking_to_spinning.iter().enumerate() {
            let written: f64 = format!("{:.2}", (i as f64 - 50.0) / 100.0).parse().expect("a number");
            assert_eq!(*slip, written, "row {i}");
        }
    }

    #[test]
    fn a_narrow_range_keeps_its_steps() {
        let slips: Vec<f64> = (0..=10).map(|i| equally_spaced(0.0, 1e-13, f64::from(i) / 10.0)).collect();
        for (i, slip) in slips.iter().enumerate() {
            assert!((slip - i as f64 * 1e-14).abs() <= 2e-29, "row {i}: {slip}");
        }
    }
}
