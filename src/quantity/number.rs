//! Numbers as people read them.

/// A number in four digits, as people read it; the value itself is in the data.
pub(crate) fn number(value: f64) -> String {
    let size = value.abs();
    if size != 0.0 && !(1e-3..1e6).contains(&size) {
        return format!("{value:.3e}");
    }
    let decimals = if size == 0.0 { 0 } else { (3.0 - size.log10().floor()).max(0.0) as usize };
    let text = format!("{value:.decimals$}");
    if text.contains('.') { text.trim_end_matches('0').trim_end_matches('.').to_owned() } else { text }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn numbers_have_four_digits_at_most() {
        for (value, text) in
            [(0.4, "0.4"), (1.0 / 3.0, "0.3333"), (-73_673.7, "-73674"), (0.0, "0"), (1e-9, "1.000e-9"), (2.0, "2")]
        {
            assert_eq!(number(value), text);
        }
    }
}
