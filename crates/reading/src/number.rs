//! Numbers with a unit and bounds.

mod kind;
mod meant;

pub use meant::in_millimetres;

use std::borrow::Cow;
use std::fmt;

use utoipa::openapi::extensions::Extensions;
use utoipa::openapi::schema::{KnownFormat, ObjectBuilder, SchemaFormat, SchemaType, Type};

use crate::fault::{Figures, Scope};
use meant::Hint;

/// A number with a unit and bounds.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Number {
    unit: &'static str,
    symbol: &'static str,
    min: f64,
    max: f64,
    /// Whether `max` itself is too large.
    open_above: bool,
    whole: bool,
    share: bool,
    /// Whether it may follow from other fields.
    pub(crate) follows: bool,
    /// What else may be meant by a number that is out of bounds.
    hint: Option<Hint>,
    default: Option<f64>,
}

impl Number {
    /// A number from `min` to `max` in a unit, which is a UCUM code: `m`, `Pa`, `1`. UCUM has no powers that vary; a unit that has
    /// one, such as `N/m^(n+1)`, is told as an annotation, in braces, which counts as 1 there.
    #[must_use]
    pub const fn new(unit: &'static str, min: f64, max: f64) -> Self {
        Self {
            unit,
            symbol: "",
            min,
            max,
            open_above: false,
            whole: false,
            share: false,
            follows: false,
            hint: None,
            default: None,
        }
    }

    /// Any number.
    #[must_use]
    pub const fn any(unit: &'static str) -> Self {
        Self::new(unit, f64::NEG_INFINITY, f64::INFINITY)
    }

    /// The upper bound itself is excluded.
    #[must_use]
    pub const fn open_above(self) -> Self {
        Self { open_above: true, ..self }
    }

    /// With the symbol that it has in formulas, which the contract sets before its meaning.
    #[must_use]
    pub const fn symbol(self, symbol: &'static str) -> Self {
        Self { symbol, ..self }
    }

    /// Only whole numbers.
    #[must_use]
    pub const fn whole(self) -> Self {
        Self { whole: true, ..self }
    }

    /// A share of one, which some send in per cent.
    #[must_use]
    pub const fn share(self) -> Self {
        Self { share: true, ..self }
    }

    /// With what else may be meant by a number that is out of bounds, as it continues behind the fault.
    #[must_use]
    pub const fn or_meant(self, hint: fn(f64) -> String) -> Self {
        Self { hint: Some(Hint(hint)), ..self }
    }

    /// A parameter of a tagged object that may follow from fields elsewhere: the contract does not require it, and that it is absent
    /// is reported where nothing else has it.
    #[must_use]
    pub const fn may_follow(self) -> Self {
        Self { follows: true, ..self }
    }

    /// What holds where the field is left out.
    #[must_use]
    pub const fn or(self, default: f64) -> Self {
        Self { default: Some(default), ..self }
    }

    /// Without a default.
    #[must_use]
    pub(crate) const fn without_default(self) -> Self {
        Self { default: None, ..self }
    }

    /// Its unit.
    #[must_use]
    pub const fn unit(&self) -> &'static str {
        self.unit
    }

    /// The smallest and the largest number that is allowed; infinite where there is no bound.
    #[must_use]
    pub const fn range(&self) -> [f64; 2] {
        [self.min, self.max]
    }

    /// Whether only whole numbers are allowed.
    #[must_use]
    pub const fn is_whole(&self) -> bool {
        self.whole
    }

    /// What holds where the field is left out.
    #[must_use]
    pub const fn default_value(&self) -> Option<f64> {
        self.default
    }

    /// The number that allows what this or `other` does; without a unit where theirs differ.
    #[must_use]
    pub(crate) fn or_as(self, other: Self) -> Self {
        let (max, open_above) = match self.max.total_cmp(&other.max) {
            std::cmp::Ordering::Less => (other.max, other.open_above),
            std::cmp::Ordering::Equal => (self.max, self.open_above && other.open_above),
            std::cmp::Ordering::Greater => (self.max, self.open_above),
        };
        let unit = if self.unit == other.unit { self.unit } else { "" };
        Self { min: self.min.min(other.min), max, open_above, unit, ..self }
    }

    /// Whether the value is within the bounds.
    #[must_use]
    pub fn allows(&self, value: f64) -> bool {
        let below_top = if self.open_above { value < self.max } else { value <= self.max };
        value >= self.min && below_top && (!self.whole || value.fract() == 0.0)
    }

    /// The value, if it is within the bounds; else the fault is reported.
    #[must_use]
    pub fn check(&self, place: &Scope<'_>, value: f64) -> Option<f64> {
        if self.allows(value) {
            Some(value)
        } else {
            place.report(self.figures(value), format_args!("must be {self}, not {}{}", Plain(value), self.meant_by(value)));
            None
        }
    }

    /// The numbers of a fault of a value that is out of bounds.
    #[must_use]
    pub fn figures(&self, value: f64) -> Figures {
        let top = Some(self.max).filter(|max| max.is_finite());
        Figures {
            value: Some(value),
            minimum: Some(self.min).filter(|min| min.is_finite()),
            maximum: top.filter(|_| !self.open_above),
            exclusive_maximum: top.filter(|_| self.open_above),
            maximum_from: None,
            unit: self.ucum(),
        }
    }

    /// Its unit as a UCUM code; none where one number stands for several of different units.
    fn ucum(&self) -> Option<Cow<'static, str>> {
        match self.unit {
            "" => None,
            unit if unit.contains('^') => Some(Cow::Owned(format!("{{{unit}}}"))),
            unit => Some(Cow::Borrowed(unit)),
        }
    }

    /// The meaning, behind symbol and unit where it has a symbol.
    pub(crate) fn told<'a>(&self, meaning: &'a str) -> Cow<'a, str> {
        match (self.symbol, self.unit) {
            ("", _) => Cow::Borrowed(meaning),
            (symbol, "1") => Cow::Owned(format!("{symbol} (–): {meaning}")),
            (symbol, unit) => Cow::Owned(format!("{symbol} ({unit}): {meaning}")),
        }
    }

    /// The schema, with or without a meaning.
    pub(crate) fn described(&self, meaning: Option<&str>) -> ObjectBuilder {
        let finite = |bound: f64| Some(bound).filter(|bound| bound.is_finite());
        let unit = self.ucum();
        let object = ObjectBuilder::new()
            .description(meaning)
            .minimum(finite(self.min))
            .default(self.default.map(|value| if self.whole { (value as i64).into() } else { value.into() }))
            .extensions(unit.map(|unit| Extensions::from_iter([("x-unit", unit.into_owned())])));
        let object = match self.open_above {
            true => object.exclusive_maximum(finite(self.max)),
            false => object.maximum(finite(self.max)),
        };
        match self.whole {
            true => object.schema_type(Type::Integer),
            false => object.schema_type(Type::Number).format(Some(SchemaFormat::KnownFormat(KnownFormat::Double))),
        }
    }

    /// The schema of an item of a list, which may be null where the list may have gaps.
    pub(crate) fn item(&self, gaps: bool) -> ObjectBuilder {
        let item = self.described(None);
        if gaps { item.schema_type(SchemaType::from_iter([Type::Number, Type::Null])).format(None) } else { item }
    }
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
        let whole = if self.whole { "a whole number " } else { "" };
        if self.open_above {
            write!(f, "{whole}at least {} and less than {}", Plain(self.min), Plain(self.max))
        } else {
            write!(f, "{whole}from {} to {}", Plain(self.min), Plain(self.max))
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::fault::{Faults, FieldFault};
    use crate::hints::Hints;

    fn fault(number: Number, value: f64) -> FieldFault {
        let faults = Faults::new(&Hints::NONE);
        assert_eq!(number.check(&Scope::root(&faults), value), None);
        faults.into_list().remove(0)
    }

    #[test]
    fn a_number_in_another_unit_is_told_what_was_probably_meant() {
        let said = |number: Number, value: f64| fault(number, value).detail;
        let angle = Number::new("rad", 0.0, std::f64::consts::FRAC_PI_2).open_above();
        assert!(said(angle, 30.0).ends_with(", not 30; it is in radians: 30° are 0.5236"));
        assert!(said(angle, 120.0).ends_with(", not 120"));
        let share = Number::new("1", -1.0, 1.0).share();
        assert!(said(share, 20.0).ends_with(", not 20; it is a share: 20 % are 0.2"));
        assert!(said(share, -35.0).ends_with("-35 % are -0.35"));
        assert!(said(share, 100.0).ends_with(", not 100; it is a share: 100 % are 1"));
        assert!(said(share, 2e3).ends_with(", not 2000"));
        let length = Number::new("m", 1e-3, 100.0);
        assert!(said(length, 125.0).ends_with(", not 125; it is in metres: 125 mm are 0.125"));
        assert!(said(length, 1e-4).ends_with(", not 0.0001"));
    }

    #[test]
    fn a_number_out_of_bounds_comes_with_the_bounds() {
        let of = |number| *fault(number, 7.5).figures.expect("figures");
        let bounds =
            |figures: Figures| (figures.value, figures.minimum, figures.maximum, figures.exclusive_maximum, figures.unit);
        assert_eq!(bounds(of(Number::new("Pa", 0.0, 5.0))), (Some(7.5), Some(0.0), Some(5.0), None, Some("Pa".into())));
        let open = Number::new("1", 0.0, 7.5).open_above();
        assert_eq!(bounds(of(open)), (Some(7.5), Some(0.0), None, Some(7.5), Some("1".into())));
        assert_eq!(of(Number::new("N/m^(n+1)", 0.0, 5.0)).unit.as_deref(), Some("{N/m^(n+1)}"));
        assert!(fault(Number::new("1", 1.0, 9.0).whole(), 7.5).detail.starts_with("must be a whole number from 1 to 9, not 7.5"));
        let infinite = fault(Number::new("m", 0.0, 1.0), f64::INFINITY);
        assert_eq!(infinite.figures.and_then(|figures| figures.value), None, "JSON has no infinity");
    }

    #[test]
    fn no_number_is_not_within_bounds() {
        assert!(!Number::any("1").allows(f64::NAN));
        assert!(Number::any("1").allows(f64::MAX));
    }
}
