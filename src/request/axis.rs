//! The slips of a sweep: a range or a list.

use serde::de::{IgnoredAny, MapAccess, SeqAccess};
use terramechanics::Slip;
use utoipa::openapi::path::Parameter;
use utoipa::openapi::schema::{ArrayBuilder, OneOfBuilder};
use utoipa::openapi::{RefOr, Schema};

use crate::wire::{Entry, Field, Nested, Number, Object, Scope, Spec, Wire, wire_object};

const SLIP: Number = Number::new("Slip ratio s (–).", -1.0, 1.0).share();
const FEWEST: usize = 2;
const MOST: usize = 10_001;

wire_object! {
    /// Equally spaced slips, both ends included.
    SlipRangeDto as "SlipRange" {
        from: f64 = Number::new("First slip (–).", -1.0, 1.0).share().required(),
        to: f64 = Number::new("Last slip (–).", -1.0, 1.0).share().required(),
        points: f64 = Number::new("Number of slips.", FEWEST as f64, MOST as f64).integer().required(),
    }
}

/// The slips of a sweep as they were sent.
#[derive(Debug, Clone)]
pub(crate) enum SlipAxis {
    Range(SlipRangeDto),
    List(Vec<Field<f64>>),
}

const RANGE: Nested<SlipRangeDto> = Nested::required("Equally spaced slips.");

/// A range or a list of slips.
pub(crate) struct SlipAxisSpec;

impl Spec for SlipAxisSpec {
    fn schema(&self) -> RefOr<Schema> {
        let list = ArrayBuilder::new().items(SLIP.schema()).min_items(Some(FEWEST)).max_items(Some(MOST));
        OneOfBuilder::new().description(Some("The slips: a range, or a list.")).item(RANGE.schema()).item(list).into()
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

    fn list<'de, A: SeqAccess<'de>>(mut list: A) -> Result<Option<Self>, A::Error> {
        let mut slips = Vec::new();
        while slips.len() <= MOST {
            match list.next_element()? {
                Some(slip) => slips.push(slip),
                None => return Ok(Some(Self::List(slips))),
            }
        }
        while list.next_element::<IgnoredAny>()?.is_some() {}
        Ok(Some(Self::List(slips))) // one more than allowed, which the check refuses
    }
}

impl Entry<'_, SlipAxis> {
    /// The slips.
    pub(super) fn slips(&self, object: &Scope<'_>) -> Option<Vec<Slip>> {
        let place = object.field(self.name);
        match self.required(object)? {
            SlipAxis::Range(range) => range.slips(&place),
            SlipAxis::List(list) => {
                if !(FEWEST..=MOST).contains(&list.len()) {
                    place.fault(format_args!("must have from {FEWEST} to {MOST} slips"));
                    return None;
                }
                let slips: Vec<Option<Slip>> = list.iter().enumerate().map(|(i, slip)| listed(slip, &place.item(i))).collect();
                slips.into_iter().collect()
            }
        }
    }
}

fn listed(slip: &Field<f64>, place: &Scope<'_>) -> Option<Slip> {
    match slip {
        Field::Given(value) => SLIP.check(place, *value).and_then(|value| Slip::new(value).ok()),
        Field::Wrong(found) => {
            place.fault(format_args!("must be a number, not {found}"));
            None
        }
        Field::Absent => None,
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
