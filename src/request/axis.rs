//! The slips of a sweep: a range or a list.

use serde::de::{IgnoredAny, MapAccess, SeqAccess};
use terramechanics::Slip;
use utoipa::openapi::schema::{ArrayBuilder, OneOfBuilder};
use utoipa::openapi::{RefOr, Schema};

use crate::wire::{Entry, Field, Nested, Number, Object, Scope, Spec, Wire, wire_object};

const SLIP: Number = Number::new("Slip ratio s (–).", -1.0, 1.0);
const FEWEST: usize = 2;
const MOST: usize = 10_001;

wire_object! {
    /// Equally spaced slips, both ends included.
    SlipRangeDto as "SlipRange" {
        from: f64 = Number::new("First slip (–).", -1.0, 1.0),
        to: f64 = Number::new("Last slip (–).", -1.0, 1.0),
        points: f64 = Number::new("Number of slips.", FEWEST as f64, MOST as f64).integer(),
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

    fn is_required(&self) -> bool {
        true
    }
}

impl Wire for SlipAxis {
    type Spec = SlipAxisSpec;
    const EXPECTED: &'static str = "an object with `from`, `to` and `points`, or an array of numbers";

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
        let slip = |i: f64| {
            let share = i / steps;
            // Both ends exactly, and rounding carries none beyond them.
            if i == steps { to } else { (from * (1.0 - share) + to * share).clamp(from.min(to), from.max(to)) }
        };
        (0..points? as u32).map(|i| Slip::new(slip(f64::from(i))).ok()).collect()
    }
}
