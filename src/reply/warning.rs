//! What a result says about itself.

use serde::Serialize;
use terramechanics::{Caution, CautionKind, SoilParams, TestedRange, Wheel};
use utoipa::ToSchema;

use super::identify::words::number;
use crate::catalogue::{self, Extent, Outside};

/// A reason to take the result with care.
#[derive(Debug, Clone, PartialEq, Serialize, ToSchema)]
pub(crate) struct Warning {
    /// Kind of the warning, for programs.
    #[schema(example = "small_wheel")]
    pub(crate) code: &'static str,
    /// The warning in words.
    pub(crate) detail: String,
    /// The quantity that leaves its range, if it is one.
    #[serde(skip_serializing_if = "Option::is_none")]
    #[schema(nullable = false)]
    pub(crate) range: Option<Range>,
}

/// A quantity outside the range in which its model was tested.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, ToSchema)]
pub(crate) struct Range {
    /// The quantity, with its unit.
    quantity: &'static str,
    /// Its value.
    value: f64,
    /// Lower end of the range, if it has one.
    lower: Option<f64>,
    /// Upper end of the range, if it has one.
    upper: Option<f64>,
    /// Where the range comes from.
    source: &'static str,
}

impl From<Caution> for Warning {
    fn from(caution: Caution) -> Self {
        let CautionKind { code, ref range, .. } = *caution.kind;
        let of_value = |&TestedRange { quantity, lower, upper, source }: &TestedRange| Range {
            quantity,
            value: caution.value,
            lower,
            upper,
            source,
        };
        Self { code, detail: caution.to_string(), range: range.as_ref().map(of_value) }
    }
}

impl From<Outside> for Warning {
    fn from(Outside { extent: &Extent { quantity, lower, upper, .. }, value }: Outside) -> Self {
        let (side, extreme) = match lower {
            Some(lower) if value < lower => ("below the least", lower),
            _ => ("above the largest", upper),
        };
        let detail =
            format!("{quantity} is {}, far {side} of the catalogue, {}: is the unit right?", number(value), number(extreme));
        let range = Range { quantity, value, lower, upper: Some(upper), source: "the catalogue of this service" };
        Self { code: "outside_catalogue", detail, range: Some(range) }
    }
}

/// The warnings that a wheel and a soil carry wherever they are: of values far beyond all that the catalogue has.
pub(in crate::reply) fn system_warnings(wheel: &Wheel, soil: &SoilParams) -> impl Iterator<Item = Warning> + use<> {
    catalogue::outside(wheel, soil).map(Warning::from)
}

impl Warning {
    /// A warning that is not about a range.
    pub(crate) fn new(code: &'static str, detail: impl Into<String>) -> Self {
        Self { code, detail: detail.into(), range: None }
    }

    /// What every linear estimate of the strength carries; the figures are those of `benches/linear_bias.py`.
    pub(crate) fn linearised_stresses() -> Self {
        Self::new(
            "linearised_stresses",
            "the linear estimator takes stresses for linear that are not, and its errors are those of noise alone: from noise-free \
             forces of the quadrature on the wheels and soils of the catalogue it found a cohesion of up to 2.9 times the true one \
             (median 1.9) or none, and a friction angle up to 4.5° too small (median 1.2°); in 28 of 663 cases both intervals of \
             95 % held the truth",
        )
    }

    /// The wheel moves backwards.
    pub(crate) fn mirrored() -> Self {
        Self::new(
            "mirrored",
            "the wheel moves backwards: angles, stresses and slip are those of its mirror image; forces along x and the torque \
             keep the axes of the rover, x forward, and so have changed sign",
        )
    }
}

/// The cautions of several rows: per kind the one that is furthest out, with the rows that carry it.
#[derive(Debug, Clone, Default)]
pub(crate) struct RowCautions(Vec<(Caution, Vec<usize>)>);

impl RowCautions {
    /// Takes those of a row.
    pub(crate) fn add(&mut self, row: usize, cautions: impl Iterator<Item = Caution>) {
        for caution in cautions {
            match self.0.iter_mut().find(|(known, _)| known.kind == caution.kind) {
                Some((worst, rows)) => {
                    rows.push(row);
                    if caution.excess() > worst.excess() {
                        *worst = caution;
                    }
                }
                None => self.0.push((caution, vec![row])),
            }
        }
    }

    /// One warning per kind, for a table of `count` rows.
    pub(crate) fn into_warnings(self, count: usize) -> impl Iterator<Item = Warning> {
        self.0.into_iter().map(move |(worst, rows)| at_rows(worst, &rows, count))
    }
}

fn at_rows(worst: Caution, rows: &[usize], count: usize) -> Warning {
    let warning = Warning::from(worst);
    let detail = if rows.len() == count {
        warning.detail
    } else {
        format!("at indices {}; furthest out: {}", rows_in_words(rows), warning.detail)
    };
    Warning { detail, ..warning }
}

/// The cautions of several runs over the same `count` rows: one warning per kind where the rows agree, with the value that is
/// furthest out, and the names of the runs unless it is all of them.
pub(crate) fn shared_warnings(runs: Vec<(&'static str, RowCautions)>, count: usize) -> Vec<Warning> {
    let all = runs.len();
    let mut found: Vec<(Caution, Vec<usize>, Vec<&str>)> = Vec::new();
    for (name, RowCautions(cautions)) in runs {
        for (caution, rows) in cautions {
            match found.iter_mut().find(|(known, at, _)| known.kind == caution.kind && *at == rows) {
                Some((worst, _, names)) => {
                    names.push(name);
                    if caution.excess() > worst.excess() {
                        *worst = caution;
                    }
                }
                None => found.push((caution, rows, vec![name])),
            }
        }
    }
    let warnings = found.into_iter().map(|(worst, rows, names)| {
        let warning = at_rows(worst, &rows, count);
        if names.len() == all {
            warning
        } else {
            Warning { detail: format!("{}: {}", names.join(", "), warning.detail), ..warning }
        }
    });
    warnings.collect()
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
