//! How much of the error of the pull hangs on the shear modulus, which few tests measured?

use terramechanics::{JanosiHanamoto, ShearLaw};

use super::{Prediction, Record, root_mean_square, system};

/// The share of the pull's error at one shear modulus.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct AtModulus {
    /// K (m).
    pub(crate) shear_modulus: f64,
    /// Error of the pull, at each point over its load (–); none where no point was measured and has a solution.
    pub(crate) drawbar_error: Option<f64>,
    /// Points with a solution.
    pub(crate) solved: usize,
}

/// Multiples of the shear modulus of a set at which it is run: guesses differ by about so much.
const FACTORS: [f64; 3] = [0.5, 1.0, 2.0];

/// The errors of the quadrature at half, at one and at two times the shear modulus of a set that goes straight ahead.
pub(crate) fn of_shear_modulus(record: &Record) -> Vec<AtModulus> {
    let Some(run) = record.quadrature() else { return Vec::new() };
    let Some(system) = system(record) else { return Vec::new() };
    let Some(ShearLaw::JanosiHanamoto(law)) = system.soil.shear() else { return Vec::new() };
    if !record.has_pull() {
        return Vec::new();
    }
    let at = |factor: f64| {
        let shear_modulus = factor * law.modulus;
        let prediction = Prediction::with(record, run, &[(JanosiHanamoto::MODULUS.name, shear_modulus)]);
        AtModulus {
            shear_modulus,
            drawbar_error: root_mean_square(prediction.pull_errors(record).into_iter()),
            solved: prediction.points().flatten().count(),
        }
    };
    FACTORS.into_iter().map(at).collect()
}

/// Runs of a set that goes straight ahead, beside those of its methods.
pub(super) const RUNS: usize = FACTORS.len();
