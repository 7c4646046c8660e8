//! Numbers in the sentences of errors.

use std::fmt;

/// A number in six digits: what a person reads; the value itself is in the error.
pub(crate) struct Digits(pub(crate) f64);

impl fmt::Display for Digits {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let size = self.0.abs();
        if size != 0.0 && !(1e-4..1e7).contains(&size) {
            return write!(f, "{:.5e}", self.0);
        }
        // As many decimals as six digits leave, without zeros at the end.
        let decimals = if size == 0.0 { 0 } else { (5.0 - size.log10().floor()).max(0.0) as usize };
        let text = format!("{:.decimals$}", self.0);
        f.write_str(if text.contains('.') { text.trim_end_matches('0').trim_end_matches('.') } else { &text })
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn numbers_are_written_in_six_digits() {
        for (value, text) in [
            (0.190_625_000_000_000_02, "0.190625"),
            (-1234.5678, "-1234.57"),
            (0.2, "0.2"),
            (1_000_000.0, "1000000"),
            (0.0, "0"),
            (1e-9, "1.00000e-9"),
            (2.5e12, "2.50000e12"),
        ] {
            assert_eq!(Digits(value).to_string(), text);
        }
    }
}
