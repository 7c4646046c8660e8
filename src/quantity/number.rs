//! Numbers as people read them.

/// A number in four digits, as people read it; the value itself is in the data.
pub(crate) fn number(value: f64) -> String {
    let size = value.abs();
    if size != 0.0 && !(1e-3..1e6).contains(&size) {
        return format!("{value:.3e}");
    }
    let decimals = if size == 0.0 { 0 } else { (3.0 - size.log10().floor()).max(0.0) as usize };
    // Most numbers of requests have few digits, and rounding takes far longer than writing them.
    let mut buffer = zmij::Buffer::new();
    let whole = buffer.format_finite(value);
    if let Some((before, behind)) = whole.split_once('.')
        && behind.len() <= decimals
    {
        return if behind == "0" { before.to_owned() } else { whole.to_owned() };
    }
    let text = format!("{value:.decimals$}");
    if text.contains('.') { text.trim_end_matches('0').trim_end_matches('.').to_owned() } else { text }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn numbers_have_four_digits_at_most() {
        for (value, text) in [
            (0.4, "0.4"),
            (1.0 / 3.0, "0.3333"),
            (-73_673.7, "-73674"),
            (0.0, "0"),
            (1e-9, "1.000e-9"),
            (2.0, "2"),
            (12.5, "12.5"),
            (0.001, "0.001"),
        ] {
            assert_eq!(number(value), text);
        }
    }
}
