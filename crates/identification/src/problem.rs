//! Residuals: the model against the measurements, as least squares see them.

use std::cell::Cell;
use std::time::Instant;

use nalgebra::DVector;
use terramechanics::{Error, KnownSinkage, Method, Sinkage, Slip};

use crate::consent::Consent;
use crate::error::FitError;
use crate::loss::Loss;
use crate::observations::Observations;
use crate::obstacle::Obstacle;
use crate::options::FitOptions;
use crate::quantity::Quantity;
use crate::range::is_summable;
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
    /// An unknown within its usual bounds, starting from the value in the setup.
    #[must_use]
    pub fn from_setup(unknown: Unknown, setup: &Setup) -> Self {
        let bounds = unknown.bounds();
        let start = unknown.value(setup).unwrap_or(unknown.typical());
        Self { unknown, bounds, start: start.clamp(bounds.lower, bounds.upper) }
    }
}

/// Evaluations that one solved sinkage counts as.
const SOLVE: u64 = 8;

/// Most sets of predictions for the check of one estimate: both sides, refits with their derivatives.
const LOOKS: u64 = 600;

/// Rows between two checks of the clock and of the caller, by a closed form: with a load to balance they take half a
/// millisecond. An integral may take as long by itself, so there every row is followed by a check.
const ROWS_PER_LOOK: usize = 128;

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
    pub(crate) consent: &'a Consent<'a>,
    spent: Cell<u64>,
}

impl<'a> Problem<'a> {
    pub(crate) fn new(
        setup: Setup,
        observations: &'a Observations,
        sought: &[Sought],
        options: &FitOptions,
        consent: &'a Consent<'a>,
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
        Ok(Self { setup, observations, sought: sought.to_vec(), scales, fitted, weights, loss, budget, until, consent, spent })
    }

    /// The same problem with another end, and with enough evaluations for one set of predictions, one of derivatives, and the
    /// check of every estimate.
    pub(crate) fn for_the_report(&self, until: Option<Instant>) -> Self {
        let unknowns = self.sought.len() as u64;
        let evaluations = self.samples() as u64 * (SOLVE + 4 * unknowns + 2) + LOOKS * unknowns * self.cost();
        Self { budget: Cell::new(evaluations), until, ..self.copied() }
    }

    /// The same problem with one unknown held at a value. Its evaluations are charged to this problem by `settle`.
    pub(crate) fn with_held(&self, i: usize, value: f64) -> Self {
        let mut held = self.copied();
        held.setup = self.sought[i].unknown.replaced(&self.setup, value);
        held.sought.remove(i);
        held.scales.remove(i);
        held
    }

    /// Takes back the evaluations that a problem derived from this one has left.
    pub(crate) fn settle(&self, other: &Self) {
        self.budget.set(other.budget.get());
        self.spent.set(other.spent.get());
    }

    fn copied(&self) -> Self {
        Self {
            setup: self.setup,
            observations: self.observations,
            sought: self.sought.clone(),
            scales: self.scales.clone(),
            fitted: self.fitted.clone(),
            weights: self.weights.clone(),
            loss: self.loss,
            budget: self.budget.clone(),
            until: self.until,
            consent: self.consent,
            spent: self.spent.clone(),
        }
    }

    pub(crate) fn samples(&self) -> usize {
        self.observations.slip.len()
    }

    /// Number of residuals from the data.
    pub(crate) fn measured_count(&self) -> usize {
        self.fitted.len() * self.samples()
    }

    /// Rows of the least-squares problem: where there are fewer data than unknowns, zeros are added, which change nothing.
    pub(crate) fn rows(&self) -> usize {
        self.measured_count().max(self.sought.len())
    }

    pub(crate) fn evaluations(&self) -> u64 {
        self.spent.get()
    }

    pub(crate) fn has_deviations(&self) -> bool {
        self.fitted.iter().any(|&quantity| self.observations.column(quantity).is_some_and(|column| column.deviation.is_some()))
    }

    /// The scaled unknowns for these values.
    pub(crate) fn scaled(&self, values: &[f64]) -> DVector<f64> {
        DVector::from_iterator(values.len(), self.scales.iter().zip(values).map(|(scale, &value)| scale.inward(value)))
    }

    pub(crate) fn setup_at(&self, values: &[f64]) -> Setup {
        self.sought.iter().zip(values).fold(self.setup, |setup, (one, &value)| one.unknown.replaced(&setup, value))
    }

    /// Whether time or evaluations are spent.
    pub(crate) fn is_spent(&self) -> bool {
        self.budget.get() < self.cost() || self.until.is_some_and(|until| Instant::now() >= until)
    }

    pub(crate) fn spend(&self, evaluations: u64) -> Result<(), Obstacle> {
        let left = self.budget.get().checked_sub(evaluations).ok_or(Obstacle::Budget)?;
        self.budget.set(left);
        self.spent.set(self.spent.get() + evaluations);
        Ok(())
    }

    /// The result of `of` for every row, until the time is spent or the caller says no.
    pub(crate) fn by_row(&self, of: impl Fn(usize, Slip) -> Result<Prediction, Error>) -> Result<Vec<Prediction>, Obstacle> {
        let rows_per_look = match self.setup.model.method {
            Method::Quadrature | Method::SideSlipping(_) | Method::ResistiveForce => 1,
            Method::Linearised { .. } | Method::Explicit { .. } => ROWS_PER_LOOK,
        };
        let mut rows = Vec::with_capacity(self.samples());
        for (row, &slip) in self.observations.slip.iter().enumerate() {
            if row % rows_per_look == 0 {
                self.consent.ask()?;
                if self.until.is_some_and(|until| Instant::now() >= until) {
                    return Err(Obstacle::Budget);
                }
            }
            rows.push(of(row, slip).map_err(|error| Obstacle::Row { row, error })?);
        }
        Ok(rows)
    }

    /// The evaluations that one set of predictions costs.
    fn cost(&self) -> u64 {
        let each = if self.setup.sinkage == SinkageSource::Load { SOLVE } else { 1 };
        self.samples() as u64 * each
    }

    /// How the sinkage of a row is known.
    pub(crate) fn sinkage(&self, setup: &Setup, row: usize) -> Sinkage {
        let at = |column: Option<&crate::observations::Column>| column.map_or(f64::NAN, |column| column.values[row]);
        match setup.sinkage {
            SinkageSource::Measured => Sinkage::Given(at(self.observations.sinkage.as_ref())),
            SinkageSource::Load => Sinkage::CarryingLoad(at(self.observations.normal.as_ref())),
            SinkageSource::UnderLoad => Sinkage::UnderLoad {
                load: at(self.observations.normal.as_ref()),
                sinkage: KnownSinkage::Given(at(self.observations.sinkage.as_ref())),
            },
            SinkageSource::Static { static_sinkage, law } => Sinkage::FromStatic { static_sinkage, law },
        }
    }

    /// The predictions of the model for every sample.
    pub(crate) fn predictions(&self, values: &[f64]) -> Result<Vec<Prediction>, Obstacle> {
        self.spend(self.cost())?;
        let setup = self.setup_at(values);
        let system = setup.system()?;
        self.by_row(|row, slip| setup.predicted(&system, slip, self.sinkage(&setup, row)))
    }

    /// The sum of the losses.
    pub(crate) fn cost_at(&self, values: &[f64]) -> Result<f64, Obstacle> {
        let residuals = self.weighted(&self.predictions(values)?)?;
        Ok(residuals.iter().map(|&residual| self.loss.of(residual)).sum())
    }

    /// Predicted minus measured over the scale of the column, before the loss; an obstacle where the sum of squares would
    /// overflow.
    pub(crate) fn weighted(&self, predictions: &[Prediction]) -> Result<DVector<f64>, Obstacle> {
        let mut residuals = DVector::zeros(self.rows());
        let mut place = 0;
        for &quantity in &self.fitted {
            let measured = self.observations.column(quantity).map_or(&[][..], |column| &column.values);
            for (row, (prediction, measured)) in predictions.iter().zip(measured).enumerate() {
                let residual = (quantity.of(prediction) - measured) * self.weights[place];
                if !is_summable(residual) {
                    return Err(Obstacle::Row { row, error: Error::NotFinite });
                }
                residuals[place] = residual;
                place += 1;
            }
        }
        Ok(residuals)
    }
}

/// 1/σ for a column: from the given deviations, else one value for all rows from the root mean square of the column.
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
