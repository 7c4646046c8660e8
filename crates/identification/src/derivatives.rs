//! Derivatives of the residuals with respect to the unknowns.
//!
//! At a given sinkage the forces are linear in c, tan φ and the sinkage modulus and smooth in the rest, so
//! central differences on the scaled unknowns keep ten digits. Where the sinkage carries a load, differences through the
//! solver would cost two solves per unknown and lose digits to its tolerance; there the derivative is the exact one of the
//! implicit function: with G(p, z) = F_z(p, z) − W = 0, dY/dp = ∂Y/∂p − ∂Y/∂z (∂G/∂p)/(∂G/∂z), all taken at the solved
//! sinkage without solving again.

use nalgebra::DMatrix;
use terramechanics::Sinkage;

use crate::obstacle::Obstacle;
use crate::problem::{Problem, Sought};
use crate::range::is_summable;
use crate::setup::{Prediction, Setup, SinkageSource};

/// Step of the differences on the scaled unknowns: the cube root of the rounding error, where a central difference is best.
const STEP: f64 = 6e-6;

impl Problem<'_> {
    /// The derivatives of the weighted residuals by the scaled unknowns in `free`, before the loss.
    pub(crate) fn jacobian(&self, values: &[f64], base: &[Prediction], free: &[usize]) -> Result<DMatrix<f64>, Obstacle> {
        let by_sinkage = match self.setup.sinkage {
            SinkageSource::Load => Some(self.by_sinkage(values, base)?),
            SinkageSource::Measured | SinkageSource::UnderLoad | SinkageSource::Static { .. } => None,
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
        if jacobian.iter().all(|&entry| is_summable(entry)) { Ok(jacobian) } else { Err(Obstacle::Values) }
    }

    /// Predictions at neighbouring `values`; where the sinkage carries a load, at the sinkages of `base`.
    fn beside(&self, setup: &Setup, base: &[Prediction], shift: f64) -> Result<Vec<Prediction>, Obstacle> {
        self.spend(self.samples() as u64)?;
        let system = setup.system()?;
        self.by_row(|row, slip| {
            let sinkage = match setup.sinkage {
                SinkageSource::Load => Sinkage::Given(base[row].sinkage * (1.0 + shift)),
                SinkageSource::Measured | SinkageSource::UnderLoad | SinkageSource::Static { .. } => self.sinkage(setup, row),
            };
            setup.predicted(&system, slip, sinkage)
        })
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
                // Taken at the sinkage of the base, like its neighbours: a solved force is off by the solver's tolerance.
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

#[cfg(test)]
mod tests;
