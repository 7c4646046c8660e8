//! One exponent for all curves and a modulus for each: Wong's weighted fit, and the least squares of p from there.

use nalgebra::DMatrix;

use super::PlateCurve;

/// Steps towards the least squares of p; each takes the distance to it at least by half where there is noise of some percent.
const STEPS: u32 = 60;

/// Change of the exponent below which it is found.
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
        // Where there is no pressure there is no logarithm, and no weight.
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

/// All curves with an exponent.
pub(super) struct Curves {
    points: Vec<Points>,
    largest: f64,
    pub(super) exponent: f64,
}

impl Curves {
    /// By Wong's weighted fit.
    pub(super) fn of(curves: &[PlateCurve]) -> Self {
        let largest = curves.iter().flat_map(|curve| &curve.pressure).copied().fold(0.0, f64::max);
        let points: Vec<Points> = curves.iter().map(|curve| Points::of(curve, largest)).collect();
        let sum = |of: fn(&Points) -> f64| points.iter().map(of).sum::<f64>();
        let exponent = sum(|points| points.depth_pressure) / sum(|points| points.depth_depth);
        Self { points, largest, exponent }
    }

    /// Whether the sinkages of any curve differ by more than rounding.
    pub(super) fn has_spread(&self) -> bool {
        self.points.iter().any(Points::has_spread)
    }

    /// The exponent of one curve alone, by Wong's fit.
    pub(super) fn own_exponent(&self, i: usize) -> Option<f64> {
        let points = &self.points[i];
        points.has_spread().then(|| points.depth_pressure / points.depth_depth)
    }

    /// By the least squares of p, by Gauss and Newton's steps, halved where they lead up.
    pub(super) fn refined(mut self) -> Self {
        let squares = |exponent: f64| self.points.iter().map(|points| points.squares(exponent)).sum::<f64>();
        let mut exponent = self.exponent;
        let mut least = squares(exponent);
        let mut factor = 1.0;
        for _ in 0..STEPS {
            let sums = self.points.iter().map(|points| points.slope_sums(exponent));
            let (square, product) = sums.fold((0.0, 0.0), |sum, (square, product)| (sum.0 + square, sum.1 + product));
            let step = factor * product / square;
            let trial = squares(exponent + step);
            if step.abs() < FOUND || !step.is_finite() {
                break;
            }
            if trial <= least {
                (exponent, least, factor) = (exponent + step, trial, 1.0);
            } else {
                factor *= 0.5;
            }
        }
        self.exponent = exponent;
        self
    }

    /// k_i of every curve (Pa/m^n).
    pub(super) fn moduli(&self) -> Vec<f64> {
        let modulus = |points: &Points| self.largest * points.level(self.exponent) * (-self.exponent * points.mean_depth).exp();
        self.points.iter().map(modulus).collect()
    }

    /// Covariance of the k_i and n: (JᵀJ)⁻¹ Jᵀ diag(r²/(1 − h)²) J (JᵀJ)⁻¹ with the leverages h (HC3).
    pub(super) fn covariance(&self) -> DMatrix<f64> {
        let count = self.points.len();
        let rows = || {
            self.points.iter().enumerate().flat_map(|(i, points)| {
                let level = points.level(self.exponent);
                let row = move |((shape, depth), p): ((f64, &f64), &f64)| (i, shape, level * shape * depth, level * shape - p);
                points.shapes(self.exponent).zip(&points.depth).zip(&points.pressure).map(row)
            })
        };
        let mut normal = DMatrix::zeros(count + 1, count + 1);
        let add = |matrix: &mut DMatrix<f64>, i: usize, by_level: f64, by_exponent: f64, weight: f64| {
            matrix[(i, i)] += weight * by_level * by_level;
            matrix[(i, count)] += weight * by_level * by_exponent;
            matrix[(count, i)] = matrix[(i, count)];
            matrix[(count, count)] += weight * by_exponent * by_exponent;
        };
        rows().for_each(|(i, by_level, by_exponent, _)| add(&mut normal, i, by_level, by_exponent, 1.0));
        let Some(inverse) = normal.try_inverse() else { return DMatrix::from_element(count + 1, count + 1, f64::INFINITY) };
        let measured = rows().count() as f64;
        let squares: f64 = rows().map(|(.., residual)| residual * residual).sum();
        let pooled = squares / (measured - count as f64 - 1.0).max(1.0);
        let mut scatter = DMatrix::zeros(count + 1, count + 1);
        for (i, by_level, by_exponent, residual) in rows() {
            let leverage = by_level * by_level * inverse[(i, i)]
                + 2.0 * by_level * by_exponent * inverse[(i, count)]
                + by_exponent * by_exponent * inverse[(count, count)];
            let variance = if leverage < ALL_LEVERAGE { (residual / (1.0 - leverage)).powi(2) } else { pooled };
            add(&mut scatter, i, by_level, by_exponent, variance);
        }
        let by_level = &inverse * scatter * &inverse;
        // From the levels at the mean depths to the moduli: k_i = level e^(−n m_i).
        let moduli = self.moduli();
        let slopes = DMatrix::from_fn(count + 1, count + 1, |row, column| match (row, column) {
            (row, column) if row < count && row == column => self.largest * (-self.exponent * self.points[row].mean_depth).exp(),
            (row, column) if row < count && column == count => -self.points[row].mean_depth * moduli[row],
            (row, column) if row == column => 1.0,
            _ => 0.0,
        });
        &slopes * by_level * slopes.transpose()
    }
}
