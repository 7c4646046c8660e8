//! The cost of a fit near its minimum.

use crate::obstacle::Obstacle;
use crate::problem::Problem;
use crate::profile::Valley;
use crate::search::{Found, refitted_cost};
use crate::uncertainty::Uncertainty;
use crate::unknown::Unknown;

/// A minimum with what is needed to evaluate the cost near it.
pub(crate) struct FitValley<'a> {
    pub(crate) problem: &'a Problem<'a>,
    pub(crate) best: &'a Found,
    pub(crate) uncertainty: &'a Uncertainty,
    pub(crate) useful: &'a [f64],
}

impl FitValley<'_> {
    /// The values with the scaled unknown `i` moved by `step` and the others with it along the valley, within the bounds.
    fn beside(&self, i: usize, step: f64) -> Vec<f64> {
        let value = |k: usize| {
            let (bounds, scale) = (self.problem.sought[k].bounds, self.problem.scales[k]);
            let moved = scale.inward(self.best.values[k]) + step * self.uncertainty.along_the_valley(i, k);
            scale.outward(moved).clamp(bounds.lower, bounds.upper)
        };
        (0..self.best.values.len()).map(value).collect()
    }

    /// A cost minus that of the minimum; `otherwise` where the model has no answer.
    fn above(&self, cost: Result<f64, Obstacle>, otherwise: f64) -> Result<f64, Obstacle> {
        match cost {
            Ok(cost) => Ok((cost - self.best.cost).max(0.0).min(otherwise)),
            Err(Obstacle::Budget) => Err(Obstacle::Budget),
            Err(Obstacle::Row { .. } | Obstacle::Values) => Ok(otherwise),
        }
    }
}

impl Valley for FitValley<'_> {
    fn uncertainty(&self) -> &Uncertainty {
        self.uncertainty
    }

    fn useful(&self, i: usize) -> f64 {
        self.useful[i]
    }

    fn room(&self, i: usize, side: f64) -> f64 {
        let (bounds, scale) = (self.problem.sought[i].bounds, self.problem.scales[i]);
        let bound = if side < 0.0 { bounds.lower } else { bounds.upper };
        (scale.inward(bound) - scale.inward(self.best.values[i])).abs()
    }

    fn is_natural(&self, i: usize, side: f64) -> bool {
        let one = self.problem.sought[i];
        side < 0.0 && one.bounds.lower == 0.0 && matches!(one.unknown, Unknown::COHESION | Unknown::FRICTION_ANGLE)
    }

    fn rise_along(&self, i: usize, step: f64) -> Result<f64, Obstacle> {
        self.above(self.problem.cost_at(&self.beside(i, step)), f64::INFINITY)
    }

    fn rise(&self, i: usize, step: f64, most: f64) -> Result<f64, Obstacle> {
        let mut values = self.beside(i, step);
        if values.len() == 1 {
            return if most.is_finite() { Ok(most) } else { self.rise_along(i, step) };
        }
        let held = self.problem.with_held(i, values.remove(i));
        let mut found = refitted_cost(&held, &values);
        if matches!(found, Err(Obstacle::Row { .. } | Obstacle::Values)) {
            let mut others = self.best.values.clone();
            others.remove(i);
            found = refitted_cost(&held, &others);
        }
        self.problem.settle(&held);
        self.above(found, most)
    }
}
