//! What was probably meant by a number that is out of bounds.

use super::Number;

/// What else may be meant by a number, as it continues behind the fault.
#[derive(Debug, Clone, Copy)]
pub(super) struct Hint(pub(super) fn(f64) -> String);

/// The same function; two that do the same may count as different ones.
impl PartialEq for Hint {
    fn eq(&self, other: &Self) -> bool {
        std::ptr::fn_addr_eq(self.0, other.0)
    }
}

impl Number {
    /// The number that was probably meant by one that is out of bounds, in words.
    pub(super) fn meant_by(&self, value: f64) -> String {
        let also = self.hint.map_or_else(String::new, |Hint(hint)| hint(value));
        let meant = match self.unit {
            "rad" if value.abs() <= 180.0 && self.allows(value.to_radians()) => {
                format!("; it is in radians: {value}° are {:.4}", value.to_radians())
            }
            "m" if value > self.max && self.allows(value / 1000.0) => in_millimetres(value),
            _ if self.share && value.abs() <= 100.0 && self.allows(value / 100.0) => {
                format!("; it is a share: {value} % are {}", value / 100.0)
            }
            _ => String::new(),
        };
        meant + &also
    }
}

/// What a length would be in millimetres, for a message.
#[must_use]
pub fn in_millimetres(value: f64) -> String {
    format!("; it is in metres: {value} mm are {}", value / 1000.0)
}
