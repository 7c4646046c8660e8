//! Which inputs decide?
//!
//! The first-order index of an input is the share of the variance that would go if the input alone were known. The total index is
//! the share that would stay if all others were known. Their difference is what the input does together with others.
//!
//! For numbers f of the sets A, B and A with a group from B (see [`design`](crate::design)), with N samples, the variance V of A and
//! B together, and c their mean:
//!
//! - first order: Σ (f_B − c)(f_AB − f_A) / (N V), Saltelli et al. (2010), Table 2 (b). The constant c changes nothing in the mean
//!   and makes the scatter small where the numbers are far from 0.
//! - total: Σ (f_A − f_AB)² / (2 N V), Jansen (1999), Computer Physics Communications 117, 35–43; Table 2 (f) of Saltelli et al.

use crate::design::Design;
use crate::estimate::{Estimate, ROUNDING, Ratio, scale};

/// How far a group of inputs decides.
#[derive(Debug, Clone, PartialEq)]
pub struct Sensitivity {
    /// The sources of the group: one, unless they are correlated.
    pub group: Vec<usize>,
    /// Share of the variance by the group alone.
    pub first: Estimate,
    /// Share of the variance by the group alone and together with others.
    pub total: Estimate,
    /// How many samples were left out because one of the rows that they need has no answer.
    pub left_out: usize,
}

/// The indices of every group from the answers to all rows of a design, in their order. A group without enough answers has none, nor
/// has any where the answers do not vary.
///
/// Empty unless the design has sensitivities and there is an answer or none for each of its rows.
pub fn sensitivities(design: &Design, answers: &[Option<f64>]) -> Vec<Option<Sensitivity>> {
    let count = design.samples();
    let mut sets = answers.chunks_exact(count);
    let (true, Some(a), Some(b)) = (answers.len() == design.rows(), sets.next(), sets.next()) else { return Vec::new() };
    let known = || a.iter().chain(b).flatten().copied();
    let scale = scale(known());
    let centre = known().map(|answer| answer / scale).sum::<f64>() / known().count().max(1) as f64;
    let about = |answer: Option<f64>| Some(answer? / scale - centre);
    design.inputs().groups().iter().zip(sets).map(|(group, exchanged)| of_group(group, [a, b, exchanged], about)).collect()
}

/// The fewest samples that an index is made of.
const LEAST: usize = crate::design::LEAST_SAMPLES / 2;

fn of_group(
    group: &[usize],
    [a, b, exchanged]: [&[Option<f64>]; 3],
    about: impl Fn(Option<f64>) -> Option<f64>,
) -> Option<Sensitivity> {
    let whole = |sample: usize| Some((sample, [about(a[sample])?, about(b[sample])?, about(exchanged[sample])?]));
    let rows: Vec<(usize, [f64; 3])> = (0..a.len()).filter_map(whole).collect();
    let variance = |[a, b, _]: [f64; 3]| 0.5 * (a * a + b * b);
    let varies = rows.iter().map(|(_, row)| variance(*row)).sum::<f64>() > ROUNDING * rows.len() as f64;
    if rows.len() < LEAST || !varies {
        return None;
    }
    let ratio = |numerator: fn([f64; 3]) -> f64| {
        Ratio::of(rows.iter().map(|(sample, row)| (*sample, [numerator(*row), variance(*row)]))).estimate()
    };
    Some(Sensitivity {
        group: group.to_vec(),
        first: ratio(|[a, b, exchanged]| b * (exchanged - a))?,
        total: ratio(|[a, _, exchanged]| 0.5 * (a - exchanged).powi(2))?,
        left_out: a.len() - rows.len(),
    })
}
