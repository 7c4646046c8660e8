//! The slopes of a request: one, a range or a list.

use terramechanics::Vehicle;
use terramechanics_reading::{Alternative, Either, Field, Number, Numbers, Object, OneOf, Reader};

use crate::request::axis::{FEWEST, MOST, spread};
use crate::request::laws::number;

const ANGLE: Number = number(&Vehicle::SLOPE);
const FROM: Field<Number> = Field::required("from", "First slope (rad).", ANGLE);
const TO: Field<Number> = Field::required("to", "Last slope (rad).", ANGLE);
const POINTS: Field<Number> =
    Field::required("points", "Number of slopes.", Number::new("1", FEWEST as f64, MOST as f64).whole());

const RANGE: Object =
    Object { name: "SlopeRange", doc: "Equally spaced slopes, both ends included.", groups: &[&[&FROM, &TO, &POINTS]] };

pub(super) const SLOPE: Field<OneOf> = Field::new(
    Vehicle::SLOPE.name,
    "Slope α (rad), positive uphill: one, or several as a range or a list; level unless given.",
    OneOf {
        default: Vehicle::SLOPE.default(),
        ..OneOf::new(
            "a number, an object with `from`, `to` and `points`, or an array of numbers",
            &[
                Alternative::Number(ANGLE),
                Alternative::Object(&RANGE, "Equally spaced slopes."),
                Alternative::Numbers(Numbers::new(ANGLE, 1, MOST)),
            ],
        )
    },
);

/// The slopes that are asked for.
#[derive(Debug, Clone, PartialEq)]
pub(crate) enum Slopes {
    /// One, whose answer has every wheel.
    One(f64),
    /// Several, whose answer has columns.
    Several(Vec<f64>),
}

impl Slopes {
    pub(crate) fn as_slice(&self) -> &[f64] {
        match self {
            Self::One(slope) => std::slice::from_ref(slope),
            Self::Several(slopes) => slopes,
        }
    }

    pub(crate) fn len(&self) -> usize {
        self.as_slice().len()
    }
}

/// The slopes; level ground where none is sent.
pub(super) fn read(object: &Reader<'_>) -> Option<Slopes> {
    match object.optional(&SLOPE)? {
        None => Some(Slopes::One(0.0)),
        Some(Either::Number(slope)) => Some(Slopes::One(slope)),
        Some(Either::Numbers(slopes)) => Some(Slopes::Several(slopes.to_vec())),
        Some(Either::Object(range)) => {
            let (from, to, points) = (range.required(&FROM), range.required(&TO), range.required(&POINTS));
            Some(Slopes::Several(spread(from?, to?, points?).collect()))
        }
        Some(Either::Word) => None,
    }
}
