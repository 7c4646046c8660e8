//! How firm is the ground, from plates pressed into it? Bekker's moduli and exponent from curves of pressure over sinkage.
//!
//! Wong (1980, Data processing methodology in the characterization of the mechanical properties of terrain, Journal of
//! Terramechanics 17, 13) fits ln p = ln k_i + n ln z with the weights p²: an error δp shows as δp/p in ln p, so the weights make it
//! the fit of p itself, and the deep end of a curve counts. Then k_i = k_c/b_i + k_φ is a straight line in 1/b. The weighted
//! normal equations were derived here and not taken from print. Departure: Wong fits an exponent for each plate and takes their
//! mean; here one exponent is fitted to all curves at once, and each plate's own is reported beside it.
//!
//! Standard errors are those of the weighted fit, carried to k_c and k_φ to first order. They do not hold the scatter between
//! soundings: with two plates the line through two moduli has none to show.

use std::fmt;

use nalgebra::{DMatrix, DVector};

use crate::finding::{Estimate, Identifiability};
use crate::student::quantile_95;
use crate::unknown::Unknown;

/// Plates that one fit takes at most.
pub const MOST_PLATES: usize = 16;

/// Relative range of widths below which plates count as one width.
const LEAST_WIDTHS: f64 = 1e-3;

/// One plate and its curve.
#[derive(Debug, Clone, PartialEq)]
pub struct PlateCurve {
    /// Smaller side, or radius of a round plate, b (m).
    pub width: f64,
    /// Sinkage z (m), greater than 0.
    pub sinkage: Vec<f64>,
    /// Pressure p (Pa), greater than 0.
    pub pressure: Vec<f64>,
}

/// What a plate's curve shows.
#[derive(Debug, Clone, PartialEq)]
pub struct FittedPlate {
    /// k_i with the common exponent (Pa/m^n).
    pub modulus: f64,
    /// The exponent of this curve alone; none where its sinkages are all alike.
    pub own_exponent: Option<f64>,
    /// (k_c/b + k_φ) z^n (Pa).
    pub predicted: Vec<f64>,
}

/// Bekker's parameters from plates.
#[derive(Debug, Clone, PartialEq)]
pub struct PlatesFit {
    /// k_c, k_φ and n0.
    pub estimates: [Estimate; 3],
    /// One per plate.
    pub plates: Vec<FittedPlate>,
    /// Correlation of k_c, k_φ and n0; none where no freedom is left.
    pub correlation: [[Option<f64>; 3]; 3],
    /// Root of the mean squared difference of the pressures (Pa).
    pub rmse: f64,
    /// Points minus parameters.
    pub freedom: f64,
}

/// Why plates give no parameters.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum PlatesError {
    /// Fewer than two plates, or more than are taken.
    Count,
    /// A curve without points, with columns of different length or a value that is not positive.
    Curve(usize),
    /// All plates have one width, so that k_c/b and k_φ are one number.
    OneWidth,
    /// No curve has two different sinkages, so that there is no exponent.
    OneSinkage,
    /// Numbers overflow.
    NotFinite,
}

impl fmt::Display for PlatesError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Count => write!(f, "from two to {MOST_PLATES} plates are needed"),
            Self::Curve(plate) => write!(f, "the curve of plate {plate} must have points of positive sinkage and pressure"),
            Self::OneWidth => {
                write!(f, "all plates have one width: k_c/b and k_φ are one number then, two widths tell them apart")
            }
            Self::OneSinkage => write!(f, "no curve has two different sinkages: there is no exponent to be seen"),
            Self::NotFinite => write!(f, "the values are too large or too small together"),
        }
    }
}

impl std::error::Error for PlatesError {}

/// Weighted sums of one curve about its weighted means, pressures in units of the largest.
struct Sums {
    weight: f64,
    mean_depth: f64,
    mean_pressure: f64,
    depth_depth: f64,
    depth_pressure: f64,
}

impl Sums {
    fn of(curve: &PlateCurve, largest: f64) -> Self {
        let points = || {
            let pair = |(&z, &p): (&f64, &f64)| ((p / largest).powi(2), z.ln(), p.ln());
            curve.sinkage.iter().zip(&curve.pressure).map(pair)
        };
        let weight: f64 = points().map(|(weight, ..)| weight).sum();
        let mean_depth = points().map(|(weight, depth, _)| weight * depth).sum::<f64>() / weight;
        let mean_pressure = points().map(|(weight, _, pressure)| weight * pressure).sum::<f64>() / weight;
        let depth_depth = points().map(|(weight, depth, _)| weight * (depth - mean_depth).powi(2)).sum();
        let depth_pressure =
            points().map(|(weight, depth, pressure)| weight * (depth - mean_depth) * (pressure - mean_pressure)).sum();
        Self { weight, mean_depth, mean_pressure, depth_depth, depth_pressure }
    }

    /// Whether the sinkages differ by more than rounding.
    fn has_spread(&self) -> bool {
        self.depth_depth > 1e-20 * self.weight
    }
}

/// k_c, k_φ and n of Bekker's law from the curves of two or more plates.
///
/// # Errors
/// [`PlatesError`].
pub fn fit_plates(curves: &[PlateCurve]) -> Result<PlatesFit, PlatesError> {
    check(curves)?;
    let largest = curves.iter().flat_map(|curve| &curve.pressure).copied().fold(0.0, f64::max);
    let sums: Vec<Sums> = curves.iter().map(|curve| Sums::of(curve, largest)).collect();
    if !sums.iter().any(Sums::has_spread) {
        return Err(PlatesError::OneSinkage);
    }
    let spread: f64 = sums.iter().map(|sums| sums.depth_depth).sum();
    let exponent = sums.iter().map(|sums| sums.depth_pressure).sum::<f64>() / spread;
    let moduli: Vec<f64> = sums.iter().map(|sums| (sums.mean_pressure - exponent * sums.mean_depth).exp()).collect();

    // The line k_i = k_c/b_i + k_φ through the moduli, as rows that give k_c and k_φ from them.
    let count = curves.len() as f64;
    let mean = curves.iter().map(|curve| 1.0 / curve.width).sum::<f64>() / count;
    let off_mean: Vec<f64> = curves.iter().map(|curve| 1.0 / curve.width - mean).collect();
    let square: f64 = off_mean.iter().map(|off| off * off).sum();
    let rows = DMatrix::from_fn(2, curves.len(), |row, i| {
        let cohesive = off_mean[i] / square;
        if row == 0 { cohesive } else { 1.0 / count - mean * cohesive }
    });
    let line = &rows * DVector::from_column_slice(&moduli);
    let (k_c, k_phi) = (line[0], line[1]);

    let predicted = |curve: &PlateCurve| -> Vec<f64> {
        curve.sinkage.iter().map(|z| (k_c / curve.width + k_phi) * z.powf(exponent)).collect()
    };
    let plates: Vec<FittedPlate> = curves
        .iter()
        .zip(&sums)
        .zip(&moduli)
        .map(|((curve, sums), &modulus)| FittedPlate {
            modulus,
            own_exponent: sums.has_spread().then(|| sums.depth_pressure / sums.depth_depth),
            predicted: predicted(curve),
        })
        .collect();
    let points = curves.iter().map(|curve| curve.sinkage.len()).sum::<usize>() as f64;
    let freedom = points - count - 1.0;
    let variance = variance(curves, &moduli, exponent, largest) / freedom.max(1.0);
    // d(k_c, k_φ, n) by (ln k_i, n), and the covariance of those: ln k_i = mean ln p − n mean ln z.
    let mut covariance = DMatrix::zeros(curves.len() + 1, curves.len() + 1);
    for (i, one) in sums.iter().enumerate() {
        covariance[(i, i)] = variance / one.weight;
        for (k, other) in sums.iter().enumerate() {
            covariance[(i, k)] += variance / spread * one.mean_depth * other.mean_depth;
        }
        let with_exponent = -variance / spread * one.mean_depth;
        (covariance[(i, curves.len())], covariance[(curves.len(), i)]) = (with_exponent, with_exponent);
    }
    covariance[(curves.len(), curves.len())] = variance / spread;
    let slopes = DMatrix::from_fn(3, curves.len() + 1, |row, i| match (row, moduli.get(i)) {
        (0 | 1, Some(modulus)) => rows[(row, i)] * modulus,
        (2, None) => 1.0,
        _ => 0.0,
    });
    let covariance = &slopes * covariance * slopes.transpose();

    let squares: f64 = curves
        .iter()
        .zip(&plates)
        .flat_map(|(curve, plate)| curve.pressure.iter().zip(&plate.predicted))
        .map(|(measured, predicted)| (predicted - measured).powi(2))
        .sum();
    let width = 1.0 / mean;
    let useful = [k_c.abs().max(width * k_phi.abs()), k_phi.abs(), 0.3];
    let unknowns = [Unknown::CohesiveModulus, Unknown::FrictionalModulus, Unknown::BaseExponent];
    let values = [k_c, k_phi, exponent];
    let fit = PlatesFit {
        estimates: std::array::from_fn(|i| {
            let error = (freedom >= 1.0).then(|| covariance[(i, i)].max(0.0).sqrt());
            stated(unknowns[i], values[i], error, freedom, useful[i])
        }),
        plates,
        correlation: std::array::from_fn(|i| {
            std::array::from_fn(|k| {
                let ratio = covariance[(i, k)] / (covariance[(i, i)] * covariance[(k, k)]).sqrt();
                let ratio = if i == k { 1.0 } else { ratio };
                (freedom >= 1.0 && ratio.is_finite()).then(|| ratio.clamp(-1.0, 1.0))
            })
        }),
        rmse: (squares / points).sqrt(),
        freedom,
    };
    let numbers = values.into_iter().chain([fit.rmse]).chain(fit.plates.iter().flat_map(|plate| plate.predicted.iter().copied()));
    if numbers.into_iter().all(f64::is_finite) { Ok(fit) } else { Err(PlatesError::NotFinite) }
}

/// An estimate with its interval, and whether that is narrow enough to be of use.
pub(crate) fn stated(unknown: Unknown, value: f64, error: Option<f64>, freedom: f64, useful: f64) -> Estimate {
    let half = error.map(|error| error * quantile_95(freedom));
    let is_determined = half.is_some_and(|half| half <= useful);
    let identifiability = if is_determined { Identifiability::Determined } else { Identifiability::Uncertain };
    let interval = half.map(|half| [value - half, value + half]);
    Estimate { unknown, value, standard_error: error, interval, at_bound: None, identifiability }
}

/// Weighted sum of the squared residuals of ln p.
fn variance(curves: &[PlateCurve], moduli: &[f64], exponent: f64, largest: f64) -> f64 {
    let of_curve = |(curve, modulus): (&PlateCurve, &f64)| -> f64 {
        let residual = |(z, p): (&f64, &f64)| ((p / largest) * (p.ln() - modulus.ln() - exponent * z.ln())).powi(2);
        curve.sinkage.iter().zip(&curve.pressure).map(residual).sum()
    };
    curves.iter().zip(moduli).map(of_curve).sum()
}

fn check(curves: &[PlateCurve]) -> Result<(), PlatesError> {
    if !(2..=MOST_PLATES).contains(&curves.len()) {
        return Err(PlatesError::Count);
    }
    let positive = |value: &f64| value.is_finite() && *value > 0.0;
    let is_sound = |curve: &PlateCurve| {
        positive(&curve.width)
            && !curve.sinkage.is_empty()
            && curve.sinkage.len() == curve.pressure.len()
            && curve.sinkage.iter().chain(&curve.pressure).all(positive)
    };
    if let Some(plate) = curves.iter().position(|curve| !is_sound(curve)) {
        return Err(PlatesError::Curve(plate));
    }
    let widths = || curves.iter().map(|curve| curve.width);
    let (narrow, wide) = (widths().fold(f64::INFINITY, f64::min), widths().fold(0.0, f64::max));
    if wide - narrow < LEAST_WIDTHS * wide { Err(PlatesError::OneWidth) } else { Ok(()) }
}
