//! Designs evaluated by functions of which the answers are known.
#![allow(dead_code, reason = "each test file uses its own part")]

use terramechanics_uncertainty::{Bounds, Design, Distribution, Inputs, Marginal, Source};

/// One uncertain number without bounds.
pub(crate) fn free(distribution: Distribution) -> Source {
    Source::One(Marginal::new(distribution, Bounds::NONE).expect("a distribution"))
}

/// The inputs, independent.
pub(crate) fn inputs(distributions: Vec<Distribution>) -> Inputs {
    Inputs::new(distributions.into_iter().map(free).collect()).expect("inputs")
}

/// What a function makes of all rows of a design.
pub(crate) fn answers(design: &Design, function: impl Fn(&[f64]) -> f64) -> Vec<Option<f64>> {
    (0..design.rows()).map(|row| Some(function(&design.row(row).expect("a row")))).collect()
}
