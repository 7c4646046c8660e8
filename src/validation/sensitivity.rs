//! How much of the error of the pull hangs on the shear modulus, which few tests measured?

use terramechanics::ShearLaw;

use super::{COMPARED, Prediction, Record, root_mean_square, system};

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
    let Some(run) = record.runs().iter().find(|run| run.series == "quadrature" && run.side.is_none()) else {
        return Vec::new();
    };
    let Some(system) = system(record) else { return Vec::new() };
    let Some(ShearLaw::JanosiHanamoto(law)) = system.soil.shear() else { return Vec::new() };
    let Some(pull) = COMPARED.iter().find(|compared| compared.about.name == "drawbar_coefficient") else { return Vec::new() };
    let load = record.points().load();
    let measured = pull.measured(record.points(), &load);
    if measured.iter().all(|value| value.is_nan()) {
        return Vec::new();
    }
    let at = |factor: f64| {
        let shear_modulus = factor * law.modulus;
        let prediction = Prediction::with(record, run, Some(shear_modulus));
        let errors = pull.predicted(prediction.points(), &load).into_iter().zip(&measured);
        AtModulus {
            shear_modulus,
            drawbar_error: root_mean_square(errors.map(|(predicted, measured)| predicted - measured)),
            solved: prediction.points().flatten().count(),
        }
    };
    FACTORS.into_iter().map(at).collect()
}

/// Runs of a set that goes straight ahead, beside those of its methods.
pub(super) const RUNS: usize = FACTORS.len();
