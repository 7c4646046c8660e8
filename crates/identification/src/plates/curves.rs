//! One exponent for all curves and a modulus for each: Wong's weighted fit, then the least squares of p.

use nalgebra::DMatrix;

use super::PlateCurve;
use crate::consent::{Consent, Stopped};

/// Steps towards the least squares of p. With noise of some percent each step at least halves the distance.
const STEPS: u32 = 60;

/// Change of the exponent below which the search has converged.
const FOUND: f64 = 1e-13;

/// Leverage above which a point has no residual of its own: its curve passes through it whatever it is.
const ALL_LEVERAGE: f64 = 0.99;

/// One curve: depths ln z about their weighted mean, pressures in units of the largest of all curves.
struct Points {
    mean_depth: f64,
    depth: Vec<f64>,
    pressure: Vec<f64>,
    /// Weighted sums of Wong's fit: squares of the depths, and their products with ln p.
    depth_depth: f64,
    depth_pressure: f64,
    weight: f64,
}

impl Points {
    fn of(curve: &PlateCurve, largest: f64) -> Self {
        let pressure: Vec<f64> = curve.pressure.iter().map(|p| p / largest).collect();
        let depth: Vec<f64> = curve.sinkage.iter().map(|z| z.ln()).collect();
        // A pressure of 0 has no logarithm, and its weight is 0.
        let weighted = || depth.iter().zip(&pressure).filter(|(_, p)| **p > 0.0).map(|(z, p)| (p * p, *z, p.ln()));
        let weight: f64 = weighted().map(|(weight, ..)| weight).sum();
        let mean_depth = weighted().map(|(weight, z, _)| weight * z).sum::<f64>() / weight;
        let mean_pressure = weighted().map(|(weight, _, p)| weight * p).sum::<f64>() / weight;
        let depth_depth = weighted().map(|(weight, z, _)| weight * (z - mean_depth).powi(2)).sum();
        let depth_pressure = weighted().map(|(weight, z, p)| weight * (z - mean_depth) * (p - mean_pressure)).sum();
        let depth = depth.iter().map(|z| z - mean_depth).collect();
        Self { mean_depth, depth, pressure, depth_depth, depth_pressure, weight }
    }

    fn has_spread(&self) -> bool {
        self.depth_depth > 1e-20 * self.weight
    }

    /// e^(n ln z), ln z about the mean.
    fn shapes(&self, exponent: f64) -> impl Iterator<Item = f64> {
        self.depth.iter().map(move |depth| (exponent * depth).exp())
    }

    /// The best pressure at the mean depth for an exponent.
    fn level(&self, exponent: f64) -> f64 {
        let product: f64 = self.shapes(exponent).zip(&self.pressure).map(|(shape, p)| shape * p).sum();
        product / self.shapes(exponent).map(|shape| shape * shape).sum::<f64>()
    }

    fn squares(&self, exponent: f64) -> f64 {
        let level = self.level(exponent);
        self.shapes(exponent).zip(&self.pressure).map(|(shape, p)| (level * shape - p).powi(2)).sum()
    }

    /// Derivatives of p by the exponent, freed of what the level takes up: their squares, and their products with the residuals.
    fn slope_sums(&self, exponent: f64) -> (f64, f64) {
        let level = self.level(exponent);
        let rows = || self.shapes(exponent).zip(&self.depth);
        let shape_shape: f64 = rows().map(|(shape, _)| shape * shape).sum();
        let shared = rows().map(|(shape, depth)| shape * level * shape * depth).sum::<f64>() / shape_shape;
        let free = |shape: f64, depth: f64| level * shape * depth - shared * shape;
        let square = rows().map(|(shape, depth)| free(shape, *depth).powi(2)).sum();
        let product = rows().zip(&self.pressure).map(|((shape, depth), p)| free(shape, *depth) * (p - level * shape)).sum();
        (square, product)
    }
}

/// A point as the covariance takes it: derivatives of its pressure by the level of its curve and by the exponent.
#[derive(Clone, Copy)]
struct Row {
    by_level: f64,
    by_exponent: f64,
    residual: f64,
}

/// All curves with an exponent. The caller is asked before each curve is gone through.
pub(super) struct Curves<'a> {
    points: Vec<Points>,
    consent: &'a Consent<'a>,
    largest: f64,
    pub(super) exponent: f64,
}

impl<'a> Curves<'a> {
    /// By Wong's weighted fit.
    pub(super) fn of(curves: &[PlateCurve], consent: &'a Consent<'a>) -> Result<Self, Stopped> {
        let largest = curves.iter().flat_map(|curve| &curve.pressure).copied().fold(0.0, f64::max);
        let points = curves.iter().map(|curve| consent.ask().map(|()| Points::of(curve, largest)));
        let points: Vec<Points> = points.collect::<Result<_, _>>()?;
        let sum = |of: fn(&Points) -> f64| points.iter().map(of).sum::<f64>();
        let exponent = sum(|points| points.depth_pressure) / sum(|points| points.depth_depth);
        Ok(Self { points, consent, largest, exponent })
    }

    /// Whether the sinkages of any curve differ by more than rounding.
    pub(super) fn has_spread(&self) -> bool {
        self.points.iter().any(Points::has_spread)
    }

    /// The exponent of one curve alone, by Wong's fit.
    pub(super) fn own_exponent(&self, i: usize) -> Option<f64> {
        let points = &self.points[i];
        points.has_spread().then(|| points.depth_pressure / points.depth_depth).filter(|exponent| exponent.is_finite())
    }

    /// A value for every curve, as long as the caller wants to go on.
    fn each<T>(&self, of: impl Fn(&Points) -> T) -> impl Iterator<Item = Result<T, Stopped>> {
        self.points.iter().map(move |points| self.consent.ask().map(|()| of(points)))
    }

    fn squares(&self, exponent: f64) -> Result<f64, Stopped> {
        self.each(|points| points.squares(exponent)).sum()
    }

    /// The least squares of p by Gauss–Newton steps, halved where the sum of squares would grow.
    pub(super) fn refined(mut self) -> Result<Self, Stopped> {
        let mut exponent = self.exponent;
        let mut least = self.squares(exponent)?;
        let mut factor = 1.0;
        for _ in 0..STEPS {
            let (mut square, mut product) = (0.0, 0.0);
            for sums in self.each(|points| points.slope_sums(exponent)) {
                let sums = sums?;
                (square, product) = (square + sums.0, product + sums.1);
            }
            let step = factor * product / square;
            if step.abs() < FOUND || !step.is_finite() {
                break;
            }
            let trial = self.squares(exponent + step)?;
            if trial <= least {
                (exponent, least, factor) = (exponent + step, trial, 1.0);
            } else {
                factor *= 0.5;
            }
        }
        self.exponent = exponent;
        Ok(self)
    }

    /// k_i of every curve (Pa/m^n).
    pub(super) fn moduli(&self) -> Vec<f64> {
        let modulus = |points: &Points| self.largest * points.level(self.exponent) * (-self.exponent * points.mean_depth).exp();
        self.points.iter().map(modulus).collect()
    }

    /// Covariance of the k_i and n: (JᵀJ)⁻¹ Jᵀ diag(r²/(1 − h)²) J (JᵀJ)⁻¹ with the leverages h (HC3); not finite where JᵀJ has
    /// no inverse.
    pub(super) fn covariance(&self) -> Result<DMatrix<f64>, Stopped> {
        let count = self.points.len();
        let mut normal = DMatrix::zeros(count + 1, count + 1);
        let add = |matrix: &mut DMatrix<f64>, i: usize, Row { by_level, by_exponent, .. }: Row, weight: f64| {
            matrix[(i, i)] += weight * by_level * by_level;
            matrix[(i, count)] += weight * by_level * by_exponent;
            matrix[(count, i)] = matrix[(i, count)];
            matrix[(count, count)] += weight * by_exponent * by_exponent;
        };
        let (mut measured, mut squares) = (0.0, 0.0);
        self.each_row(|i, row| {
            add(&mut normal, i, row, 1.0);
            measured += 1.0;
            squares += row.residual * row.residual;
        })?;
        let Some(inverse) = normal.try_inverse() else {
            return Ok(DMatrix::from_element(count + 1, count + 1, f64::INFINITY));
        };
        let pooled = squares / (measured - count as f64 - 1.0_f64).max(1.0);
        let mut scatter = DMatrix::zeros(count + 1, count + 1);
        self.each_row(|i, row| {
            let Row { by_level, by_exponent, residual } = row;
            let leverage = by_level * by_level * inverse[(i, i)]
                + 2.0 * by_level * by_exponent * inverse[(i, count)]
                + by_exponent * by_exponent * inverse[(count, count)];
            let variance = if leverage < ALL_LEVERAGE { (residual / (1.0 - leverage)).powi(2) } else { pooled };
            add(&mut scatter, i, row, variance);
        })?;
        let by_level = &inverse * scatter * &inverse;
        // From the levels at the mean depths to the moduli: k_i = level e^(−n m_i).
        let moduli = self.moduli();
        let slopes = DMatrix::from_fn(count + 1, count + 1, |row, column| match (row, column) {
            (row, column) if row < count && row == column => self.largest * (-self.exponent * self.points[row].mean_depth).exp(),
            (row, column) if row < count && column == count => -self.points[row].mean_depth * moduli[row],
            (row, column) if row == column => 1.0,
            _ => 0.0,
        });
        Ok(&slopes * by_level * slopes.transpose())
    }

    /// Visits every point with the number of its curve, as long as the caller wants to go on.
    fn each_row(&self, mut of: impl FnMut(usize, Row)) -> Result<(), Stopped> {
        for (i, points) in self.points.iter().enumerate() {
            self.consent.ask()?;
            let level = points.level(self.exponent);
            for ((shape, depth), p) in points.shapes(self.exponent).zip(&points.depth).zip(&points.pressure) {
                of(i, Row { by_level: shape, by_exponent: level * shape * depth, residual: level * shape - p });
            }
        }
        Ok(())
    }
}
