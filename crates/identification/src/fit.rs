//! Which parameters of soil and contact explain measured forces? A nonlinear least-squares fit, with what it cannot tell.

use std::time::Instant;

use terramechanics::Error;

use crate::consent::Consent;
use crate::error::FitError;
use crate::loss::Loss;
use crate::observations::Observations;
use crate::obstacle::Obstacle;
use crate::options::{FitOptions, MOST_STARTS};
use crate::problem::{Problem, Sought};
use crate::report::{Fit, report};
use crate::search::{Found, StopReason, from_start, further_start};
use crate::setup::Setup;

/// Rounds in which a robust loss learns the scale of the residuals from them.
const SCALE_ROUNDS: usize = 2;

/// Relative difference of the cost up to which two solutions explain the data equally well.
const SAME_COST: f64 = 1e-6;

/// The parameters `sought` of `setup` that explain `observations` best.
///
/// # Errors
/// [`FitError`], where there is nothing that could be fitted.
///
/// ```
/// use terramechanics::*;
/// use terramechanics_identification::*;
/// // The letter's own wheel and sand (its Fig. 1b), with friction and shear modulus unknown.
/// let exponent = SinkageExponent { base: 0.91, slip_gain: 0.0, skid_gain: None };
/// let setup = Setup {
///     wheel: Wheel::new(WheelParams { radius: 0.2, width: 0.1, lug_height: 0.0, lug_coefficient: 0.5 })?,
///     soil: SoilParams {
///         cohesion: 0.0,
///         friction_angle: 0.6,
///         shear: Some(ShearLaw::JanosiHanamoto(JanosiHanamoto { modulus: 0.02 })),
///         pressure_sinkage: Some(PressureSinkage::Direct(Direct { k_s: 747_530.0, exponent })),
///         ..SoilParams::BARE
///     },
///     contact: ContactParams { rule: PeakRule::Midpoint, ..ContactParams::MIDPOINT },
///     model: ForceModel::at_rim(Method::Quadrature),
///     sinkage: SinkageSource::Measured,
/// };
/// let column = |values: [f64; 4]| Some(Column { values: values.to_vec(), deviation: None });
/// // An independent integration with 401 000 points gave these torques.
/// let observations = Observations {
///     slip: [0.05, 0.5, 0.05, 0.5].into_iter().map(Slip::new).collect::<Result<_, _>>()?,
///     sinkage: column([0.01, 0.01, 0.02, 0.02]),
///     torque: column([1.2247, 2.9912, 5.0744, 8.3513]),
///     ..Observations::default()
/// };
/// let sought = [Unknown::FRICTION_ANGLE, Unknown::SHEAR_MODULUS].map(|unknown| Sought::from_setup(unknown, &setup));
/// let found = fit(&setup, &observations, &sought, &FitOptions::default())?;
/// assert!(found.converged() && found.is_identifiable());
/// assert!((found.estimates[0].value - 0.478).abs() < 1e-4 && (found.estimates[1].value - 0.005).abs() < 1e-5);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
pub fn fit(setup: &Setup, observations: &Observations, sought: &[Sought], options: &FitOptions) -> Result<Fit, FitError> {
    fit_while(setup, observations, sought, options, &|| true)
}

/// Like [`fit()`], as long as the caller wants to go on. The caller is asked about every millisecond of work, at each
/// evaluation at the latest. Only the decomposition of the derivatives inside a search step is not interrupted; for ten
/// thousand samples it takes some ten milliseconds.
///
/// # Errors
/// [`FitError::Stopped`] at the first no, and those of [`fit()`].
pub fn fit_while(
    setup: &Setup,
    observations: &Observations,
    sought: &[Sought],
    options: &FitOptions,
    go_on: &dyn Fn() -> bool,
) -> Result<Fit, FitError> {
    let consent = Consent::new(go_on);
    let found = found(setup, observations, sought, options, &consent);
    if consent.is_withdrawn() { Err(FitError::Stopped) } else { found }
}

fn found(
    setup: &Setup,
    observations: &Observations,
    sought: &[Sought],
    options: &FitOptions,
    consent: &Consent<'_>,
) -> Result<Fit, FitError> {
    let began = Instant::now();
    let mut problem = Problem::new(*setup, observations, sought, options, consent)?;
    let (mut best, mut others) = search(&problem, options.starts.clamp(1, MOST_STARTS))?;
    if options.loss != Loss::LeastSquares {
        problem.loss = options.loss;
        let rounds = if problem.has_deviations() { 1 } else { SCALE_ROUNDS };
        for _ in 0..rounds {
            if !problem.has_deviations() {
                rescale(&mut problem, &best.values);
            }
            match from_start(&problem, &best.values) {
                Ok(found) => best = Found { iterations: best.iterations + found.iterations, ..found },
                Err(_) => {
                    best.stop = StopReason::Budget;
                    break;
                }
            }
        }
        others.clear(); // solutions of another loss
    }
    // The report may take half as long again before it is ended, too.
    let until = options.until.map(|until| until + until.saturating_duration_since(began) / 2);
    report(&problem.for_the_report(until), &best, &others)
}

/// The best result of the searches from all starts, and the others that are as good.
fn search(problem: &Problem<'_>, starts: u32) -> Result<(Found, Vec<Found>), FitError> {
    let own: Vec<f64> = problem.sought.iter().map(|one| one.start).collect();
    let mut found: Vec<Found> = Vec::new();
    let mut refusal: Option<(usize, Error)> = None;
    let mut is_cut = false;
    // Where the model refuses the data at the start itself, other starts are tried even if one was asked for.
    for number in 0..MOST_STARTS {
        if number >= starts && !found.is_empty() {
            break;
        }
        let start = if number == 0 { own.clone() } else { further_start(problem, number) };
        match from_start(problem, &start) {
            Ok(end) => found.push(end),
            Err(Obstacle::Row { row, error }) => refusal = refusal.or(Some((row, error))),
            Err(Obstacle::Values) => {}
            Err(Obstacle::Budget) => {
                is_cut = true;
                break;
            }
        }
    }
    found.sort_by(|a, b| a.cost.total_cmp(&b.cost));
    let mut found = found.into_iter();
    let mut best = found.next().ok_or_else(|| {
        let (row, error) = refusal.unwrap_or((0, Error::NotFinite));
        if is_cut { FitError::OutOfBudget } else { FitError::Refused { row, error } }
    })?;
    if is_cut {
        best.stop = StopReason::Budget; // not all starts that were asked for
    }
    let level = (best.cost * (1.0 + SAME_COST)).max(f64::from(u8::MAX) * f64::EPSILON * f64::EPSILON * problem.samples() as f64);
    let others = found.filter(|end| end.stop.is_success() && end.cost <= level).collect();
    Ok((best, others))
}

/// Weights every column by the median size of its residuals: 1.4826 times it is the standard deviation of normal noise.
fn rescale(problem: &mut Problem<'_>, values: &[f64]) {
    let Ok(residuals) = problem.predictions(values).and_then(|predictions| problem.weighted(&predictions)) else { return };
    let samples = problem.samples();
    for column in 0..problem.fitted.len() {
        let rows = column * samples..(column + 1) * samples;
        let mut sizes: Vec<f64> = rows.clone().map(|row| residuals[row].abs()).collect();
        sizes.sort_unstable_by(f64::total_cmp);
        // Exact data have residuals of no size; a billionth of the column's scale is below what any sensor resolves.
        let scale = (1.4826 * sizes[samples / 2]).max(1e-9);
        problem.weights[rows].iter_mut().for_each(|weight| *weight /= scale);
    }
}
