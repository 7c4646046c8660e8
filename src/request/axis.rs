//! The slips of a sweep: a range or a list.

use serde::de::{MapAccess, SeqAccess};
use terramechanics::Slip;
use utoipa::openapi::path::Parameter;
use utoipa::openapi::schema::OneOfBuilder;
use utoipa::openapi::{RefOr, Schema};

use crate::wire::{Entry, MOST_NUMBERS, Nested, Number, Object, Scope, Series, SeriesSpec, Spec, Wire, wire_object};

const SLIP: Number = Number::new("Slip ratio s (–).", -1.0, 1.0).share();
const FEWEST: usize = 2;

wire_object! {
    /// Equally spaced slips, both ends included.
    SlipRangeDto as "SlipRange" {
        from: f64 = Number::new("First slip (–).", -1.0, 1.0).share().required(),
        to: f64 = Number::new("Last slip (–).", -1.0, 1.0).share().required(),
        points: f64 = Number::new("Number of slips.", FEWEST as f64, MOST_NUMBERS as f64).integer().required(),
    }
}

/// The slips of a sweep as they were sent.
#[derive(Debug, Clone)]
pub(crate) enum SlipAxis {
    Range(SlipRangeDto),
    List(Series),
}

const RANGE: Nested<SlipRangeDto> = Nested::required("Equally spaced slips.");

const fn list(fewest: usize) -> SeriesSpec {
    SeriesSpec { doc: "Slips.", number: SLIP, fewest, required: true }
}

/// A range or a list of slips.
pub(crate) struct SlipAxisSpec;

impl Spec for SlipAxisSpec {
    fn schema(&self) -> RefOr<Schema> {
        let either = OneOfBuilder::new().description(Some("The slips: a range, or a list."));
        either.item(RANGE.schema()).item(list(FEWEST).array()).into()
    }

    fn schemas(&self, found: &mut Vec<(String, RefOr<Schema>)>) {
        RANGE.schemas(found);
    }

    fn parameters(&self, name: &str, found: &mut Vec<Parameter>) {
        RANGE.parameters(name, found);
    }

    fn is_required(&self) -> bool {
        true
    }
}

impl Wire for SlipAxis {
    type Spec = SlipAxisSpec;
    const EXPECTED: &'static str =
        "an object with `from`, `to` and `points` (in a query `slip.from`, `slip.to` and `slip.points`), or an array of numbers";

    fn object<'de, A: MapAccess<'de>>(map: A) -> Result<Option<Self>, A::Error> {
        Ok(SlipRangeDto::object(map)?.map(Self::Range))
    }

    fn list<'de, A: SeqAccess<'de>>(list: A) -> Result<Option<Self>, A::Error> {
        Ok(Series::list(list)?.map(Self::List))
    }
}

impl SlipAxis {
    /// The slips, if there are at least `fewest`.
    fn slips(&self, place: &Scope<'_>, fewest: usize) -> Option<Vec<Slip>> {
        match self {
            Self::Range(range) => range.slips(place),
            Self::List(series) => list(fewest).check(place, series)?.into_iter().map(|slip| Slip::new(slip).ok()).collect(),
        }
    }
}

impl Entry<'_, SlipAxis> {
    /// The slips.
    pub(super) fn slips(&self, object: &Scope<'_>) -> Option<Vec<Slip>> {
        self.required(object)?.slips(&object.field(self.name), FEWEST)
    }
}

/// One slip, or the slips of a sweep, as they were sent.
#[derive(Debug, Clone)]
pub(crate) enum SlipOrAxis {
    One(f64),
    Several(SlipAxis),
}

/// A slip, or a range or a list of slips.
pub(crate) struct SlipOrAxisSpec;

impl Spec for SlipOrAxisSpec {
    fn schema(&self) -> RefOr<Schema> {
        let any = OneOfBuilder::new().description(Some("One slip, or the slips as a range or a list."));
        any.item(SLIP.schema()).item(RANGE.schema()).item(list(1).array()).into()
    }

    fn schemas(&self, found: &mut Vec<(String, RefOr<Schema>)>) {
        RANGE.schemas(found);
    }

    fn is_required(&self) -> bool {
        true
    }
}

impl Wire for SlipOrAxis {
    type Spec = SlipOrAxisSpec;
    const EXPECTED: &'static str = "a number, an object with `from`, `to` and `points`, or an array of numbers";

    fn number(value: f64) -> Option<Self> {
        Some(Self::One(value))
    }

    fn object<'de, A: MapAccess<'de>>(map: A) -> Result<Option<Self>, A::Error> {
        Ok(SlipAxis::object(map)?.map(Self::Several))
    }

    fn list<'de, A: SeqAccess<'de>>(list: A) -> Result<Option<Self>, A::Error> {
        Ok(SlipAxis::list(list)?.map(Self::Several))
    }
}

impl Entry<'_, SlipOrAxis> {
    /// The slips, of which there is at least one.
    pub(super) fn slips(&self, object: &Scope<'_>) -> Option<Vec<Slip>> {
        let place = object.field(self.name);
        match self.required(object)? {
            SlipOrAxis::One(value) => SLIP.check(&place, *value).and_then(|slip| Slip::new(slip).ok()).map(|slip| vec![slip]),
            SlipOrAxis::Several(axis) => axis.slips(&place, 1),
        }
    }
}

impl SlipRangeDto {
    fn slips(&self, place: &Scope<'_>) -> Option<Vec<Slip>> {
        self.report_oddities(place);
        let (from, to) = (self.from().required_number(place), self.to().required_number(place));
        let points = self.points().required_number(place);
        let (from, to, steps) = (from?, to?, points? - 1.0);
        (0..points? as u32).map(|i| Slip::new(equally_spaced(from, to, f64::from(i) / steps)).ok()).collect()
    }
}

/// The number at `share` of the way between two slips. Where a number of 14 decimals is as near as rounding can tell, it is
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
