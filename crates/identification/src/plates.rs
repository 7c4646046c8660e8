//! How firm is the ground, from plates pressed into it? Bekker's moduli and exponent from curves of pressure over sinkage.
//!
//! Wong (1980, Data processing methodology in the characterization of the mechanical properties of terrain, Journal of
//! Terramechanics 17, 13) fits ln p = ln k_i + n ln z with the weights p². An error δp of the pressure is δp/p in ln p, so
//! these weights turn the fit into one of p itself, and the deep end of a curve counts most. Then k_i = k_c/b_i + k_φ is a
//! straight line in 1/b. The weighted normal equations were derived here, not taken from print.
//!
//! Departures: Wong fits an exponent for each plate and takes their mean; here one exponent is fitted to all curves at once,
//! and each plate's own is reported beside it. Noise biases the logarithm of the pressure and its weights, so Wong's fit only
//! starts the search for the least squares of p. With small noise both agree.
//!
//! Standard errors allow for noise that differs from point to point (MacKinnon & White 1985, HC3), because the noise of a plate
//! test may or may not grow with the pressure. They are carried to k_c and k_φ to first order. They do not include the scatter
//! between soundings: the line through the moduli of two plates has no residual that could show it.

use std::fmt;

use nalgebra::{DMatrix, DVector};
use terramechanics::Bekker;

use crate::consent::{Consent, Stopped};
use crate::estimate::{Estimate, Identifiability};
use crate::observations::MOST_SAMPLES;
use crate::range::{self, finite, finite_ends};
use crate::student::quantile_95;
use crate::unknown::Unknown;

mod curves;

use self::curves::Curves;

/// Plates that one fit takes at most.
pub const MOST_PLATES: usize = 16;

/// Relative range of widths below which plates count as one width.
const LEAST_WIDTHS: f64 = 1e-3;

/// Relative difference of the plates' own exponents beyond which one exponent does not describe them.
const EXPONENTS_APART: f64 = 0.2;

/// One plate and its curve.
#[derive(Debug, Clone, PartialEq)]
pub struct PlateCurve {
    /// Smaller side, or radius of a round plate, b (m).
    pub width: f64,
    /// Sinkage z (m), greater than 0.
    pub sinkage: Vec<f64>,
    /// Pressure p (Pa), not negative, and somewhere greater than 0.
    pub pressure: Vec<f64>,
}

/// What a plate's curve shows.
#[derive(Debug, Clone, PartialEq)]
pub struct FittedPlate {
    /// k_i with the common exponent (Pa/m^n).
    pub modulus: f64,
    /// The exponent of this curve alone; none where all its sinkages are equal.
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
    pub degrees_of_freedom: f64,
}

/// Why plate tests give no parameters.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum PlatesError {
    /// Fewer than two plates, or more than are taken.
    Count,
    /// A curve without points or without pressure, with more than [`MOST_SAMPLES`] points, with columns of different length, or
    /// with a value that is not allowed.
    Curve(usize),
    /// A plate whose width or largest pressure is too small or too large to be squared and summed, or whose largest pressure is
    /// negligible beside that of another plate.
    Size(usize),
    /// All plates have one width, so k_c/b and k_φ cannot be told apart.
    OneWidth,
    /// No curve has two different sinkages, so the exponent cannot be found.
    OneSinkage,
    /// A result leaves the range of numbers.
    NotFinite,
    /// The caller did not want the fit to go on.
    Stopped,
}

impl From<Stopped> for PlatesError {
    fn from(_: Stopped) -> Self {
        Self::Stopped
    }
}

impl fmt::Display for PlatesError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Count => write!(f, "from two to {MOST_PLATES} plates are needed"),
            Self::Curve(plate) => write!(
                f,
                "the curve of plate {plate} must have points of positive sinkage with pressures that are not negative and not all 0"
            ),
            Self::Size(plate) => write!(
                f,
                "the width and the largest pressure of plate {plate}, and its share of the largest of all, {}",
                range::WORDS
            ),
            Self::OneWidth => {
                write!(f, "all plates have one width, so k_c/b and k_φ cannot be told apart; measure with two widths")
            }
            Self::OneSinkage => write!(f, "no curve has two different sinkages, so the exponent cannot be found"),
            Self::NotFinite => write!(f, "the values are too large or too small together"),
            Self::Stopped => write!(f, "the fit was told to stop"),
        }
    }
}

impl std::error::Error for PlatesError {}

/// k_c, k_φ and n of Bekker's law from the curves of two or more plates.
///
/// # Errors
/// [`PlatesError`].
pub fn fit_plates(curves: &[PlateCurve]) -> Result<PlatesFit, PlatesError> {
    fit_plates_while(curves, &|| true)
}

/// Like [`fit_plates`], as long as the caller wants to go on. The caller is asked before each pass over a curve, some hundred
/// times for each.
///
/// # Errors
/// [`PlatesError::Stopped`] at the first no, and those of [`fit_plates`].
pub fn fit_plates_while(curves: &[PlateCurve], go_on: &dyn Fn() -> bool) -> Result<PlatesFit, PlatesError> {
    check(curves)?;
    let consent = Consent::new(go_on);
    let fitted = Curves::of(curves, &consent)?;
    if !fitted.has_spread() {
        return Err(PlatesError::OneSinkage);
    }
    let fitted = fitted.refined()?;
    let (exponent, moduli) = (fitted.exponent, fitted.moduli());

    // The line k_i = k_c/b_i + k_φ through the moduli: the rows that map the moduli to k_c and k_φ.
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
        .zip(&moduli)
        .enumerate()
        .map(|(i, (curve, &modulus))| FittedPlate { modulus, own_exponent: fitted.own_exponent(i), predicted: predicted(curve) })
        .collect();
    let points = curves.iter().map(|curve| curve.sinkage.len()).sum::<usize>() as f64;
    let degrees_of_freedom = points - count - 1.0;
    // Derivatives of (k_c, k_φ, n) with respect to (k_i, n).
    let slopes = DMatrix::from_fn(3, curves.len() + 1, |row, i| match row {
        0 | 1 if i < curves.len() => rows[(row, i)],
        2 if i == curves.len() => 1.0,
        _ => 0.0,
    });
    let covariance = &slopes * fitted.covariance()? * slopes.transpose();

    let squares: f64 = curves
        .iter()
        .zip(&plates)
        .flat_map(|(curve, plate)| curve.pressure.iter().zip(&plate.predicted))
        .map(|(measured, predicted)| (predicted - measured).powi(2))
        .sum();
    let width = 1.0 / mean;
    let unknowns = [Unknown::COHESIVE_MODULUS, Unknown::FRICTIONAL_MODULUS, Unknown::BASE_EXPONENT];
    let values = [k_c, k_phi, exponent];
    let fit = PlatesFit {
        estimates: std::array::from_fn(|i| {
            // A variance that overflowed or underflowed is not a variance of 0.
            let variance = finite(covariance[(i, i)]).filter(|_| degrees_of_freedom >= 1.0);
            let error = variance.map(|variance| variance.max(0.0).sqrt());
            let useful = unknowns[i].useful_beside(values[i], width, |name| (name == Bekker::K_PHI.name).then_some(k_phi));
            stated(unknowns[i], values[i], error, degrees_of_freedom, useful)
        }),
        plates,
        correlation: std::array::from_fn(|i| {
            std::array::from_fn(|k| {
                let ratio = covariance[(i, k)] / (covariance[(i, i)] * covariance[(k, k)]).sqrt();
                let ratio = if i == k { 1.0 } else { ratio };
                (degrees_of_freedom >= 1.0 && ratio.is_finite()).then(|| ratio.clamp(-1.0, 1.0))
            })
        }),
        rmse: (squares / points).sqrt(),
        degrees_of_freedom,
    };
    let of_plates = fit.plates.iter().flat_map(|plate| plate.predicted.iter().copied().chain([plate.modulus]));
    if values.into_iter().chain([fit.rmse]).chain(of_plates).all(f64::is_finite) { Ok(fit) } else { Err(PlatesError::NotFinite) }
}

impl PlatesFit {
    /// The width above which the law has a positive modulus, where a negative k_c makes that a limit (m).
    #[must_use]
    pub fn least_width(&self) -> Option<f64> {
        let [k_c, k_phi, _] = self.estimates.each_ref().map(|estimate| estimate.value);
        (k_c < 0.0 && k_phi > 0.0).then(|| -k_c / k_phi)
    }

    /// The least and the largest of the plates' own exponents, where they are too far apart for one to describe them.
    #[must_use]
    pub fn exponents_apart(&self) -> Option<[f64; 2]> {
        let own = || self.plates.iter().filter_map(|plate| plate.own_exponent);
        let (least, largest) = (own().fold(f64::INFINITY, f64::min), own().fold(f64::NEG_INFINITY, f64::max));
        (largest - least > EXPONENTS_APART * self.estimates[2].value.abs()).then_some([least, largest])
    }

    /// Whether the law makes a soil: k_φ and n0 are positive.
    #[must_use]
    pub fn is_a_soil(&self) -> bool {
        self.estimates[1].value > 0.0 && self.estimates[2].value > 0.0
    }
}

/// An estimate with its interval, and whether that is narrow enough to be of use.
fn stated(unknown: Unknown, value: f64, error: Option<f64>, degrees_of_freedom: f64, useful: f64) -> Estimate {
    let half = error.and_then(|error| finite(error * quantile_95(degrees_of_freedom)));
    let is_determined = half.is_some_and(|half| half <= useful);
    let identifiability = if is_determined { Identifiability::Determined } else { Identifiability::Uncertain };
    let interval = half.and_then(|half| finite_ends([value - half, value + half]));
    Estimate { unknown, value, standard_error: error, interval, at_bound: None, identifiability }
}

fn check(curves: &[PlateCurve]) -> Result<(), PlatesError> {
    if !(2..=MOST_PLATES).contains(&curves.len()) {
        return Err(PlatesError::Count);
    }
    let positive = |value: &f64| value.is_finite() && *value > 0.0;
    let is_sound = |curve: &PlateCurve| {
        positive(&curve.width)
            && (1..=MOST_SAMPLES).contains(&curve.sinkage.len())
            && curve.sinkage.len() == curve.pressure.len()
            && curve.sinkage.iter().all(positive)
            && curve.pressure.iter().all(|value| value.is_finite() && *value >= 0.0)
            && curve.pressure.iter().any(positive)
    };
    if let Some(plate) = curves.iter().position(|curve| !is_sound(curve)) {
        return Err(PlatesError::Curve(plate));
    }
    let pressure = |curve: &PlateCurve| range::largest(curve.pressure.iter().copied());
    let largest = range::largest(curves.iter().map(pressure));
    let is_usable = |curve: &PlateCurve| {
        let pressure = pressure(curve);
        [curve.width, pressure, pressure / largest].into_iter().all(range::is_usable)
    };
    if let Some(plate) = curves.iter().position(|curve| !is_usable(curve)) {
        return Err(PlatesError::Size(plate));
    }
    let widths = || curves.iter().map(|curve| curve.width);
    let (narrow, wide) = (widths().fold(f64::INFINITY, f64::min), widths().fold(0.0, f64::max));
    if wide - narrow < LEAST_WIDTHS * wide { Err(PlatesError::OneWidth) } else { Ok(()) }
}
