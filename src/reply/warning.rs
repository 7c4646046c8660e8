//! What a result says about itself.

use serde::Serialize;
use terramechanics::Caution;
use utoipa::ToSchema;

/// A reason to take the result with care.
#[derive(Debug, Clone, PartialEq, Serialize, ToSchema)]
pub(crate) struct Warning {
    /// Kind of the warning, for programs.
    #[schema(example = "slip_gain_extrapolated")]
    pub(crate) code: &'static str,
    /// The warning in words.
    pub(crate) detail: String,
}

impl From<Caution> for Warning {
    fn from(caution: Caution) -> Self {
        Self { code: caution.code(), detail: caution.to_string() }
    }
}

impl Warning {
    /// The wheel moves backwards.
    pub(crate) fn mirrored() -> Self {
        Self {
            code: "mirrored",
            detail: "the wheel moves backwards: angles and stresses are those of its mirror image, positive towards the direction of motion"
                .into(),
        }
    }
}

/// Rows in words: `3, 5–9 and 12`, cut where there are too many.
pub(crate) fn rows_in_words(rows: &[usize]) -> String {
    const MOST_RANGES: usize = 20;
    let mut ranges: Vec<(usize, usize)> = Vec::new();
    for &row in rows {
        match ranges.last_mut() {
            Some((_, last)) if *last + 1 == row => *last = row,
            _ => ranges.push((row, row)),
        }
    }
    let shown: Vec<String> = ranges
        .iter()
        .take(MOST_RANGES)
        .map(|&(first, last)| if first == last { first.to_string() } else { format!("{first}–{last}") })
        .collect();
    let more = if ranges.len() > MOST_RANGES { " and more" } else { "" };
    format!("{}{more}", shown.join(", "))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn neighbouring_rows_are_one_range() {
        assert_eq!(rows_in_words(&[3, 5, 6, 7, 12]), "3, 5–7, 12");
        let many: Vec<usize> = (0..100).map(|i| 2 * i).collect();
        assert!(rows_in_words(&many).ends_with("and more"));
    }
}
