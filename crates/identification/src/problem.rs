//! Residuals and their derivatives: the model against the measurements, as least squares see them.
//!
//! Derivatives. At a given sinkage the forces are linear in c, tan φ and the sinkage modulus and smooth in the rest, so
//! central differences on the scaled unknowns keep ten digits. Where the sinkage carries a load, differences through the
//! solver would cost two solves per unknown and lose digits to its tolerance; there the derivative is the exact one of the
//! implicit function: with G(p, z) = F_z(p, z) − W = 0, dY/dp = ∂Y/∂p − ∂Y/∂z (∂G/∂p)/(∂G/∂z), all taken at the solved
//! sinkage without solving again.

use std::cell::Cell;
use std::time::Instant;

use nalgebra::{DMatrix, DVector};
use terramechanics::{Error, InvalidInput, Sinkage, Slip};

use crate::error::FitError;
use crate::fit::FitOptions;
use crate::loss::Loss;
use crate::observations::{Observations, Quantity};
use crate::setup::{Prediction, Setup, SinkageSource};
use crate::unknown::{Range, Scale, Unknown};

/// One unknown with its bounds and its start.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Sought {
    /// What is sought.
    pub unknown: Unknown,
    /// Bounds of the value.
    pub bounds: Range,
    /// Where the search begins.
    pub start: f64,
}

impl Sought {
    /// An unknown within its usual bounds, from the value that the setup has.
    #[must_use]
    pub fn from_setup(unknown: Unknown, setup: &Setup) -> Self {
        let bounds = unknown.bounds();
        let start = unknown.value(setup).unwrap_or(unknown.typical());
        Self { unknown, bounds, start: start.clamp(bounds.lower, bounds.upper) }
    }
}

/// Step of the differences on the scaled unknowns: the cube root of the rounding error, where a central difference is best.
const STEP: f64 = 6e-6;

/// Evaluations that one solved sinkage stands for.
const SOLVE: u64 = 8;

/// Why a point of the search has no residuals.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) enum Obstacle {
    /// The model refuses a row.
    Row { row: usize, error: Error },
    /// The values make no soil or no contact.
    Values,
    /// The evaluations are spent.
    Budget,
}

impl From<InvalidInput> for Obstacle {
    fn from(_: InvalidInput) -> Self {
        Self::Values
    }
}

/// A fit to be made.
#[derive(Debug)]
pub(crate) struct Problem<'a> {
    pub(crate) setup: Setup,
    pub(crate) observations: &'a Observations,
    pub(crate) sought: Vec<Sought>,
    pub(crate) scales: Vec<Scale>,
    pub(crate) fitted: Vec<Quantity>,
    /// 1/σ of every residual, quantity by quantity.
    pub(crate) weights: Vec<f64>,
    pub(crate) loss: Loss,
    /// Evaluations of the forces that are left.
    budget: Cell<u64>,
    /// When the fit ends at the latest.
    until: Option<Instant>,
    spent: Cell<u64>,
}

impl<'a> Problem<'a> {
    pub(crate) fn new(
        setup: Setup,
        observations: &'a Observations,
        sought: &[Sought],
        options: &FitOptions,
    ) -> Result<Self, FitError> {
        if sought.is_empty() {
            return Err(FitError::NothingToFit);
        }
        for (i, one) in sought.iter().enumerate() {
            if sought[..i].iter().any(|other| other.unknown == one.unknown) {
                return Err(FitError::Repeated(one.unknown));
            }
            if one.unknown.value(&setup).is_none() {
                return Err(FitError::NoSuchParameter(one.unknown));
            }
            if !one.bounds.is_proper() {
                return Err(FitError::ImproperBounds(one.unknown));
            }
            if !one.bounds.contains(one.start) {
                return Err(FitError::StartOutsideBounds(one.unknown));
            }
        }
        observations.check(&setup.sinkage)?;
        let fitted = observations.fitted(&setup.sinkage);
        let weights = fitted.iter().filter_map(|&quantity| observations.column(quantity)).flat_map(weights_of).collect();
        let scales = sought.iter().map(|one| one.unknown.scale(&one.bounds, one.start)).collect();
        let (budget, until, spent) = (Cell::new(options.evaluations), options.until, Cell::new(0));
        let loss = Loss::LeastSquares;
        Ok(Self { setup, observations, sought: sought.to_vec(), scales, fitted, weights, loss, budget, until, spent })
    }

    /// The same problem with evaluations enough for one set of predictions and of derivatives.
    pub(crate) fn with_budget_for_the_report(&self) -> Self {
        let evaluations = self.samples() as u64 * (SOLVE + 4 * self.sought.len() as u64 + 2);
        Self {
            setup: self.setup,
            observations: self.observations,
            sought: self.sought.clone(),
            scales: self.scales.clone(),
            fitted: self.fitted.clone(),
            weights: self.weights.clone(),
            loss: self.loss,
            budget: Cell::new(evaluations),
            until: None,
            spent: self.spent.clone(),
        }
    }

    pub(crate) fn samples(&self) -> usize {
        self.observations.slip.len()
    }

    /// Residuals that the data give.
    pub(crate) fn measured_count(&self) -> usize {
        self.fitted.len() * self.samples()
    }

    /// Rows of the least-squares problem: where there are fewer data than unknowns, zeros are added, which change nothing.
    fn rows(&self) -> usize {
        self.measured_count().max(self.sought.len())
    }

    pub(crate) fn evaluations(&self) -> u64 {
        self.spent.get()
    }

    pub(crate) fn has_deviations(&self) -> bool {
        self.fitted.iter().any(|&quantity| self.observations.column(quantity).is_some_and(|column| column.deviation.is_some()))
    }

    /// The scaled unknowns of values.
    pub(crate) fn scaled(&self, values: &[f64]) -> DVector<f64> {
        DVector::from_iterator(values.len(), self.scales.iter().zip(values).map(|(scale, &value)| scale.inward(value)))
    }

    pub(crate) fn setup_at(&self, values: &[f64]) -> Setup {
        self.sought.iter().zip(values).fold(self.setup, |setup, (one, &value)| one.unknown.replaced(&setup, value))
    }

    fn spend(&self, evaluations: u64) -> Result<(), Obstacle> {
        if self.until.is_some_and(|until| Instant::now() > until) {
            return Err(Obstacle::Budget);
        }
        let left = self.budget.get().checked_sub(evaluations).ok_or(Obstacle::Budget)?;
        self.budget.set(left);
        self.spent.set(self.spent.get() + evaluations);
        Ok(())
    }

    /// The evaluations that one set of predictions costs.
    fn cost(&self) -> u64 {
        let each = if self.setup.sinkage == SinkageSource::Load { SOLVE } else { 1 };
        self.samples() as u64 * each
    }

    /// How the sinkage of a row is known.
    fn sinkage(&self, setup: &Setup, row: usize) -> Sinkage {
        let at = |column: Option<&crate::observations::Column>| column.map_or(f64::NAN, |column| column.values[row]);
        match setup.sinkage {
            SinkageSource::Measured => Sinkage::Given(at(self.observations.sinkage.as_ref())),
            SinkageSource::Load => Sinkage::CarryingLoad(at(self.observations.normal.as_ref())),
            SinkageSource::Static { static_sinkage, law } => Sinkage::FromStatic { static_sinkage, law },
        }
    }

    /// What the model says of every sample.
    pub(crate) fn predictions(&self, values: &[f64]) -> Result<Vec<Prediction>, Obstacle> {
        self.spend(self.cost())?;
        let setup = self.setup_at(values);
        let system = setup.system()?;
        let row = |(row, &slip): (usize, &Slip)| {
            let sinkage = self.sinkage(&setup, row);
            setup.predicted(&system, slip, sinkage).map_err(|error| Obstacle::Row { row, error })
        };
        self.observations.slip.iter().enumerate().map(row).collect()
    }

    /// Predicted minus measured over the scale of the column, before the loss.
    pub(crate) fn weighted(&self, predictions: &[Prediction]) -> DVector<f64> {
        let mut residuals = DVector::zeros(self.rows());
        let mut place = 0;
        for &quantity in &self.fitted {
            let measured = self.observations.column(quantity).map_or(&[][..], |column| &column.values);
            for (prediction, measured) in predictions.iter().zip(measured) {
                residuals[place] = (quantity.of(prediction) - measured) * self.weights[place];
                place += 1;
            }
        }
        residuals
    }

    /// The derivatives of the weighted residuals by the scaled unknowns in `free`, before the loss.
    pub(crate) fn jacobian(&self, values: &[f64], base: &[Prediction], free: &[usize]) -> Result<DMatrix<f64>, Obstacle> {
        let by_sinkage = match self.setup.sinkage {
            SinkageSource::Load => Some(self.by_sinkage(values, base)?),
            SinkageSource::Measured | SinkageSource::Static { .. } => None,
        };
        let mut jacobian = DMatrix::zeros(self.rows(), free.len());
        for (column, &i) in free.iter().enumerate() {
            let mut slopes = self.by_unknown(values, base, i)?;
            if let Some(by_sinkage) = &by_sinkage {
                for (slope, along) in slopes.iter_mut().zip(by_sinkage) {
                    let moved = -slope.normal / along.normal; // dz/dp: the load stays what it is
                    slope.longitudinal += along.longitudinal * moved;
                    slope.torque += along.torque * moved;
                    slope.sinkage = moved;
                }
            }
            let mut place = 0;
            for &quantity in &self.fitted {
                for slope in &slopes {
                    jacobian[(place, column)] = quantity.of(slope) * self.weights[place];
                    place += 1;
                }
            }
        }
        if jacobian.iter().all(|entry| entry.is_finite()) { Ok(jacobian) } else { Err(Obstacle::Values) }
    }

    /// Predictions beside `values`, at the sinkages of `base` where those carry a load.
    fn beside(&self, setup: &Setup, base: &[Prediction], shift: f64) -> Result<Vec<Prediction>, Obstacle> {
        self.spend(self.samples() as u64)?;
        let system = setup.system()?;
        let row = |(row, &slip): (usize, &Slip)| {
            let sinkage = match setup.sinkage {
                SinkageSource::Load => Sinkage::Given(base[row].sinkage * (1.0 + shift)),
                SinkageSource::Measured | SinkageSource::Static { .. } => self.sinkage(setup, row),
            };
            setup.predicted(&system, slip, sinkage).map_err(|error| Obstacle::Row { row, error })
        };
        self.observations.slip.iter().enumerate().map(row).collect()
    }

    /// ∂/∂z at the sinkages of `base`.
    fn by_sinkage(&self, values: &[f64], base: &[Prediction]) -> Result<Vec<Prediction>, Obstacle> {
        let setup = self.setup_at(values);
        let shallow = self.beside(&setup, base, -STEP)?;
        let deep = self.beside(&setup, base, STEP)?;
        let row = |(i, here): (usize, &Prediction)| combined(&[(deep[i], 1.0), (shallow[i], -1.0)], 2.0 * STEP * here.sinkage);
        Ok(base.iter().enumerate().map(row).collect())
    }

    /// ∂/∂ of the scaled unknown `i`: a central difference, or a one-sided one of the same order next to a bound or where the
    /// model has no answer on one side.
    fn by_unknown(&self, values: &[f64], base: &[Prediction], i: usize) -> Result<Vec<Prediction>, Obstacle> {
        let (Sought { unknown, bounds, .. }, scale) = (self.sought[i], self.scales[i]);
        let centre = scale.inward(values[i]);
        let step = STEP * centre.abs().max(1.0);
        let setup = self.setup_at(values);
        let at = |steps: f64| -> Option<Result<Vec<Prediction>, Obstacle>> {
            let value = scale.outward(centre + steps * step);
            bounds.contains(value).then(|| self.beside(&unknown.replaced(&setup, value), base, 0.0))
        };
        let (below, above) = (at(-1.0), at(1.0));
        let central: Vec<Prediction> = match (below, above) {
            (Some(Err(Obstacle::Budget)), _) | (_, Some(Err(Obstacle::Budget))) => return Err(Obstacle::Budget),
            (Some(Ok(below)), Some(Ok(above))) => {
                above.iter().zip(&below).map(|(&above, &below)| combined(&[(above, 1.0), (below, -1.0)], 2.0 * step)).collect()
            }
            (below, above) => {
                let (near, side) = match (below, above) {
                    (_, Some(Ok(above))) => (above, 1.0),
                    (Some(Ok(below)), _) => (below, -1.0),
                    (Some(Err(obstacle)), _) | (_, Some(Err(obstacle))) => return Err(obstacle),
                    (None, None) => return Err(Obstacle::Values), // bounds closer together than a step
                };
                // At the sinkage of the base, like its neighbours: a solved force is off by the solver's tolerance.
                let here = self.beside(&setup, base, 0.0)?;
                match at(2.0 * side) {
                    Some(Ok(far)) => here
                        .iter()
                        .zip(&near)
                        .zip(&far)
                        .map(|((&here, &near), &far)| combined(&[(near, 4.0), (here, -3.0), (far, -1.0)], 2.0 * side * step))
                        .collect(),
                    _ => {
                        here.iter().zip(&near).map(|(&here, &near)| combined(&[(near, 1.0), (here, -1.0)], side * step)).collect()
                    }
                }
            }
        };
        Ok(central)
    }
}

/// A weighted sum of predictions over a divisor.
fn combined(terms: &[(Prediction, f64)], divisor: f64) -> Prediction {
    let sum = |of: fn(&Prediction) -> f64| terms.iter().map(|(term, weight)| weight * of(term)).sum::<f64>() / divisor;
    Prediction {
        sinkage: sum(|term| term.sinkage),
        longitudinal: sum(|term| term.longitudinal),
        normal: sum(|term| term.normal),
        torque: sum(|term| term.torque),
    }
}

/// 1/σ of a column: of the given deviations, else one for all from the root mean square of the column.
fn weights_of(column: &crate::observations::Column) -> Vec<f64> {
    match &column.deviation {
        Some(deviation) => deviation.iter().map(|deviation| 1.0 / deviation).collect(),
        None => {
            let count = column.values.len() as f64;
            let largest = column.values.iter().fold(0.0_f64, |largest, value| largest.max(value.abs()));
            // Scaled by the largest, so that the squares neither overflow nor vanish.
            let size = if largest > 0.0 {
                largest * (column.values.iter().map(|value| (value / largest).powi(2)).sum::<f64>() / count).sqrt()
            } else {
                1.0
            };
            vec![1.0 / size; column.values.len()]
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::observations::Column;
    use terramechanics::{
        ContactParams, Direct, ForceModel, JanosiHanamoto, Method, PeakRule, PressureSinkage, ShearLaw, SinkageExponent,
        SoilParams, Wheel, WheelParams,
    };

    /// Of derivatives that differ by the truncation of the coarser ones, a step of 1e-4.
    const AGREED: f64 = 1e-6;

    fn setup(method: Method) -> Setup {
        let exponent = SinkageExponent { base: 0.9, slip_gain: 0.3, skid_gain: None };
        Setup {
            wheel: Wheel::new(WheelParams { radius: 0.15, width: 0.12, lug_height: 0.008, lug_coefficient: 0.5 })
                .expect("a wheel"),
            soil: SoilParams {
                cohesion: 600.0,
                friction_angle: 0.55,
                shear: ShearLaw::JanosiHanamoto(JanosiHanamoto { modulus: 0.012 }),
                pressure_sinkage: PressureSinkage::Direct(Direct { k_s: 9e5, exponent }),
                unit_weight: None,
                lateral_shear_modulus: None,
            },
            contact: ContactParams { rule: PeakRule::WongReece { c1: 0.45, c2: 0.1 }, exit_ratio: 0.0 },
            model: ForceModel::at_rim(method),
            sinkage: SinkageSource::Load,
        }
    }

    /// The derivatives under a load, by the implicit function, against differences of whole load balances.
    #[test]
    fn derivatives_under_a_load_are_those_of_solved_sinkages() {
        let column = |values: Vec<f64>| Some(Column { values, deviation: None });
        let observations = Observations {
            slip: [-0.1, 0.05, 0.3, 0.7].map(|ratio| Slip::new(ratio).expect("a slip")).to_vec(),
            sinkage: column(vec![0.01; 4]),
            longitudinal: column(vec![10.0; 4]),
            normal: column(vec![40.0, 60.0, 90.0, 120.0]),
            torque: column(vec![5.0; 4]),
        };
        for method in [Method::Quadrature, Method::LINEARISED, Method::EXPLICIT] {
            let setup = setup(method);
            let has = |unknown: &Unknown| unknown.value(&setup).is_some();
            let sought: Vec<Sought> =
                Unknown::ALL.into_iter().filter(has).map(|unknown| Sought::from_setup(unknown, &setup)).collect();
            let problem = Problem::new(setup, &observations, &sought, &FitOptions::default()).expect("a problem");
            let values: Vec<f64> = sought.iter().map(|one| one.start).collect();
            let all: Vec<usize> = (0..values.len()).collect();
            let base = problem.predictions(&values).expect("predictions");
            let jacobian = problem.jacobian(&values, &base, &all).expect("derivatives");
            for (i, scale) in problem.scales.iter().enumerate() {
                // λ may stand at 0, where it can go to either side like the others.
                let at = |shift: f64| {
                    let mut values = values.clone();
                    values[i] = scale.outward(scale.inward(values[i]) + shift);
                    problem.weighted(&problem.predictions(&values).expect("predictions"))
                };
                let difference = (at(1e-4) - at(-1e-4)) / 2e-4;
                let error = (jacobian.column(i) - &difference).norm() / difference.norm().max(1e-3);
                assert!(error < AGREED, "{method:?} {}: {error}", sought[i].unknown);
            }
        }
    }
}
