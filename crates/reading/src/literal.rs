//! Numbers as JSON writes them.

/// The number, if the text is one as JSON writes it (RFC 8259, section 6); an infinite one where it is too large.
pub(crate) fn number(text: &str) -> Option<f64> {
    let digits = |text: &str| !text.is_empty() && text.bytes().all(|byte| byte.is_ascii_digit());
    let unsigned = text.strip_prefix('-').unwrap_or(text);
    let (mantissa, exponent) = unsigned.split_once(['e', 'E']).map_or((unsigned, None), |(left, right)| (left, Some(right)));
    let (whole, fraction) = mantissa.split_once('.').map_or((mantissa, None), |(left, right)| (left, Some(right)));
    let is_json = digits(whole)
        && (whole == "0" || !whole.starts_with('0'))
        && fraction.is_none_or(digits)
        && exponent.is_none_or(|exponent| digits(exponent.strip_prefix(['+', '-']).unwrap_or(exponent)));
    if is_json { text.parse().ok() } else { None }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_number_is_what_json_calls_one_with_the_same_bits() {
        for text in ["0", "-0", "0.478", "-660", "1e5", "1E+5", "1.5e-300", "123456789012345678901", "4.35e-5", "0.1e1"] {
            let json: f64 = serde_json::from_str(text).expect("a number");
            assert_eq!(number(text).map(f64::to_bits), Some(json.to_bits()), "{text}");
        }
        for text in [
            "", "-", "+1", "01", ".5", "1.", "1e", "1e+", "0x10", "NaN", "inf", "-inf", "Infinity", "1_000", " 1", "1 ", "1,5",
            "١",
        ] {
            assert!(
                number(text).is_none() && serde_json::from_str::<f64>(text.trim_matches(' ')).is_err() | text.contains(' '),
                "{text}"
            );
        }
    }
}
