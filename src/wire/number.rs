//! Numbers and their bounds.

use std::fmt;

use terramechanics::Parameter;
use utoipa::openapi::schema::{KnownFormat, ObjectBuilder, OneOfBuilder, SchemaFormat, Type};
use utoipa::openapi::{RefOr, Schema};

use super::{Choice, Entry, Scope, Spec, Wire};

/// A number with bounds.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Number {
    doc: &'static str,
    min: f64,
    max: f64,
    /// Whether `max` itself is too large.
    open_above: bool,
    integer: bool,
    required: bool,
    default: Option<f64>,
    often_mistaken: Option<Mistake>,
}

/// A unit in which a number is often sent instead of its own.
#[derive(Debug, Clone, Copy)]
enum Mistake {
    /// Degrees instead of radians.
    Degrees,
    /// Hundredths instead of a share.
    Percent,
    /// Millimetres instead of metres.
    Millimetres,
}

impl Number {
    /// A number from `min` to `max`; the description names its unit.
    pub(crate) const fn new(doc: &'static str, min: f64, max: f64) -> Self {
        Self { doc, min, max, open_above: false, integer: false, required: false, default: None, often_mistaken: None }
    }

    /// A number with the bounds of the model's parameter.
    pub(crate) const fn within(parameter: &Parameter, doc: &'static str) -> Self {
        Self { open_above: parameter.is_open_above(), ..Self::new(doc, parameter.least, parameter.most) }
    }

    /// The same with the parameter's default.
    pub(crate) const fn of(parameter: &Parameter, doc: &'static str) -> Self {
        Self { default: parameter.default(), ..Self::within(parameter, doc) }
    }

    /// Only whole numbers.
    pub(crate) const fn integer(self) -> Self {
        Self { integer: true, ..self }
    }

    /// An angle in radians, which some send in degrees.
    pub(crate) const fn angle(self) -> Self {
        Self { often_mistaken: Some(Mistake::Degrees), ..self }
    }

    /// A share, which some send in per cent.
    pub(crate) const fn share(self) -> Self {
        Self { often_mistaken: Some(Mistake::Percent), ..self }
    }

    /// A length in metres, which some send in millimetres.
    pub(crate) const fn length(self) -> Self {
        Self { often_mistaken: Some(Mistake::Millimetres), ..self }
    }

    /// The object is refused without it.
    pub(crate) const fn required(self) -> Self {
        Self { required: true, ..self }
    }

    /// What holds where the field is left out.
    pub(crate) const fn or(self, default: f64) -> Self {
        Self { default: Some(default), ..self }
    }

    /// Whether the value is within the bounds.
    pub(crate) fn allows(&self, value: f64) -> bool {
        let below_top = if self.open_above { value < self.max } else { value <= self.max };
        value >= self.min && below_top && (!self.integer || value.fract() == 0.0)
    }

    /// The value, if it is within the bounds; else the fault is reported.
    pub(crate) fn check(&self, place: &Scope<'_>, value: f64) -> Option<f64> {
        if self.allows(value) {
            Some(value)
        } else {
            place.fault(format_args!("must be {self}, not {}{}", Plain(value), self.probably_meant(value)));
            None
        }
    }

    /// The number that was probably meant by one that is out of bounds, in words.
    fn probably_meant(&self, value: f64) -> String {
        match self.often_mistaken {
            Some(Mistake::Degrees) if value.abs() <= 180.0 && self.allows(value.to_radians()) => {
                format!("; it is in radians: {value}° are {:.4}", value.to_radians())
            }
            Some(Mistake::Percent) if value.abs() <= 100.0 && self.allows(value / 100.0) => {
                format!("; it is a share: {value} % are {}", value / 100.0)
            }
            Some(Mistake::Millimetres) if value > self.max && self.allows(value / 1000.0) => in_millimetres(value),
            _ => String::new(),
        }
    }
}

/// What a length would be in millimetres.
pub(crate) fn in_millimetres(value: f64) -> String {
    format!("; it is in metres: {value} mm are {}", value / 1000.0)
}

/// A number as people write it: with an exponent only where zeros would have to be counted.
struct Plain(f64);

impl fmt::Display for Plain {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let size = self.0.abs();
        if size != 0.0 && !(1e-4..1e6).contains(&size) { write!(f, "{:e}", self.0) } else { write!(f, "{}", self.0) }
    }
}

impl fmt::Display for Number {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let whole = if self.integer { "a whole number " } else { "" };
        if self.open_above {
            write!(f, "{whole}at least {} and less than {}", Plain(self.min), Plain(self.max))
        } else {
            write!(f, "{whole}from {} to {}", Plain(self.min), Plain(self.max))
        }
    }
}

impl Spec for Number {
    fn schema(&self) -> RefOr<Schema> {
        let object = ObjectBuilder::new()
            .description(Some(self.doc))
            .minimum(Some(self.min))
            .default(self.default.map(|value| if self.integer { (value as i64).into() } else { value.into() }));
        let object = if self.open_above { object.exclusive_maximum(Some(self.max)) } else { object.maximum(Some(self.max)) };
        if self.integer {
            object.schema_type(Type::Integer).into()
        } else {
            object.schema_type(Type::Number).format(Some(SchemaFormat::KnownFormat(KnownFormat::Double))).into()
        }
    }

    fn is_required(&self) -> bool {
        self.required
    }
}

impl Wire for f64 {
    type Spec = Number;
    const EXPECTED: &'static str = "a number";

    fn number(value: f64) -> Option<Self> {
        Some(value)
    }
}

impl Entry<'_, f64> {
    /// The value if one was sent and is within the bounds.
    pub(crate) fn checked(&self, object: &Scope<'_>) -> Option<f64> {
        let value = *self.given(object)?;
        self.spec.check(&object.field(self.name), value)
    }

    /// The value, or what holds where the field is left out; none where what was sent is wrong.
    pub(crate) fn or_default(&self, object: &Scope<'_>) -> Option<f64> {
        if self.is_present() { self.checked(object) } else { self.spec.default }
    }

    /// The value; that none was sent is reported.
    pub(crate) fn required_number(&self, object: &Scope<'_>) -> Option<f64> {
        self.required(object).and_then(|&value| self.spec.check(&object.field(self.name), value))
    }
}

/// A fitting constant: a number or a word.
#[derive(Debug, Clone)]
pub(crate) enum Lambda {
    Number(f64),
    Word(String),
}

impl Wire for Lambda {
    type Spec = LambdaSpec;
    const EXPECTED: &'static str = "a number or \"exact\"";

    fn number(value: f64) -> Option<Self> {
        Some(Self::Number(value))
    }

    fn text(value: &str) -> Option<Self> {
        Some(Self::Word(value.to_owned()))
    }
}

/// A number with bounds, or one of some words.
#[derive(Debug)]
pub(crate) struct LambdaSpec {
    pub(crate) number: Number,
    pub(crate) word: Choice,
}

impl Spec for LambdaSpec {
    fn schema(&self) -> RefOr<Schema> {
        let default = self.number.default.map(serde_json::Value::from);
        OneOfBuilder::new()
            .item(self.number.schema())
            .item(self.word.schema())
            .description(Some(self.number.doc))
            .default(default)
            .into()
    }
}

#[cfg(test)]
mod tests {
    use std::cell::RefCell;

    use super::*;

    fn said(number: Number, value: f64) -> String {
        let faults = RefCell::default();
        assert_eq!(number.check(&Scope::root(&faults), value), None);
        faults.into_inner().remove(0).detail
    }

    #[test]
    fn a_number_in_another_unit_is_told_what_was_probably_meant() {
        let angle = Number::within(&terramechanics::Soil::FRICTION_ANGLE, "").angle();
        assert!(said(angle, 30.0).ends_with(", not 30; it is in radians: 30° are 0.5236"));
        assert!(said(angle, 120.0).ends_with(", not 120"));
        let share = Number::new("", -1.0, 1.0).share();
        assert!(said(share, 20.0).ends_with(", not 20; it is a share: 20 % are 0.2"));
        assert!(said(share, -35.0).ends_with("-35 % are -0.35"));
        assert!(said(share, 100.0).ends_with(", not 100; it is a share: 100 % are 1"));
        assert!(said(share, 2e3).ends_with(", not 2000"));
        let length = Number::new("", 1e-3, 100.0).length();
        assert!(said(length, 125.0).ends_with(", not 125; it is in metres: 125 mm are 0.125"));
        assert!(said(length, 1e-4).ends_with(", not 0.0001"));
    }
}
