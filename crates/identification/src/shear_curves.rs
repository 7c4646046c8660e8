//! How strong is the soil, from shear tests? Cohesion, friction and shear modulus from curves of shear stress over displacement.
//!
//! All curves are fitted at once by τ = (c + σ tan φ)(1 − e^(−j/K)) (Janosi & Hanamoto 1961). For a given K that is linear in c
//! and tan φ, so only K is searched: over six decades about the range of the displacements, then by golden section. No start is
//! needed and no local minimum missed that is wider than the scan. Derivatives for the errors are by hand, and the sum of squares
//! itself is asked whether the data bound an estimate on both sides. Cohesion and friction are held at or above 0. A curve with a hump cannot be told from this law by its parameters: see the residuals.

use std::fmt;

use nalgebra::{DMatrix, DVector};

use crate::finding::{Bound, Estimate, Identifiability};
use crate::loss::Loss;
use crate::profile::Flanks;
use crate::uncertainty::{Evidence, Scatter, Uncertainty};
use crate::unknown::Unknown;

mod points;

use self::points::{Law, Points, ShearValley};

/// Curves that one fit takes at most.
pub const MOST_CURVES: usize = 64;

/// Relative range of normal stresses below which they count as one.
const LEAST_STRESSES: f64 = 1e-3;

/// One shear test.
#[derive(Debug, Clone, PartialEq)]
pub struct ShearCurve {
    /// Normal stress σ (Pa), not negative.
    pub normal: f64,
    /// Shear displacement j (m), not negative.
    pub displacement: Vec<f64>,
    /// Shear stress τ (Pa).
    pub shear: Vec<f64>,
}

/// Strength of a soil from shear tests.
#[derive(Debug, Clone, PartialEq)]
pub struct ShearFit {
    /// c, φ and K.
    pub estimates: [Estimate; 3],
    /// Predicted shear stresses (Pa), one column per curve.
    pub predicted: Vec<Vec<f64>>,
    /// Correlation of c, tan φ and K.
    pub correlation: Vec<Vec<Option<f64>>>,
    /// Root of the mean squared difference of the shear stresses (Pa).
    pub rmse: f64,
    /// Points minus parameters.
    pub degrees_of_freedom: f64,
}

/// Why shear tests give no parameters.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum ShearError {
    /// Fewer than two curves, or more than are taken.
    Count,
    /// A curve without points, with columns of different length, or a value that cannot be.
    Curve(usize),
    /// All tests have one normal stress, so that c and σ tan φ are one number.
    OneStress,
    /// Nothing is displaced, or there is no strength at all.
    NoShear,
}

impl fmt::Display for ShearError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Count => write!(f, "from two to {MOST_CURVES} curves are needed"),
            Self::Curve(curve) => {
                write!(f, "curve {curve} must have points of finite stress and displacements that are not negative")
            }
            Self::OneStress => {
                write!(
                    f,
                    "all tests have one normal stress: c and σ tan φ are one number then, two normal stresses tell them apart"
                )
            }
            Self::NoShear => write!(f, "the curves show no strength: every displacement or every shear stress is 0"),
        }
    }
}

impl std::error::Error for ShearError {}

/// c, φ and K from shear tests at two or more normal stresses.
///
/// # Errors
/// [`ShearError`].
pub fn fit_shear_curves(curves: &[ShearCurve]) -> Result<ShearFit, ShearError> {
    check(curves)?;
    let largest = |values: &mut dyn Iterator<Item = f64>| values.fold(0.0_f64, |largest, value| largest.max(value.abs()));
    let unit = largest(&mut curves.iter().flat_map(|curve| curve.shear.iter().copied().chain([curve.normal])));
    let points = curves.iter().flat_map(|curve| {
        let point = move |(&displacement, &shear): (&f64, &f64)| (curve.normal / unit, displacement, shear / unit);
        curve.displacement.iter().zip(&curve.shear).map(point)
    });
    let points = Points { list: points.collect(), unit };
    let has_shear = points.list.iter().any(|&(_, displacement, shear)| displacement > 0.0 && shear > 0.0);
    if !has_shear {
        return Err(ShearError::NoShear);
    }
    Ok(report(curves, &points, &points.best()))
}

fn report(curves: &[ShearCurve], points: &Points, law: &Law) -> ShearFit {
    let count = points.list.len();
    let row = |i: usize| points.list[i];
    let jacobian = DMatrix::from_fn(count.max(3), 3, |i, column| {
        if i >= count {
            return 0.0;
        }
        let (normal, displacement, _) = row(i);
        let left = (-displacement / law.modulus).exp();
        match column {
            0 => 1.0 - left,
            1 => normal * (1.0 - left),
            _ => -(law.cohesion + normal * law.tan_friction) * left * displacement / law.modulus, // by ln K
        }
    });
    let residuals = DVector::from_fn(count.max(3), |i, _| {
        if i >= count {
            return 0.0;
        }
        let (normal, displacement, shear) = row(i);
        law.shear(normal, displacement) - shear
    });
    let cohesion = law.cohesion * points.unit;
    let useful = [cohesion.max(500.0), 0.25, law.modulus];
    let useful_scaled = [useful[0] / points.unit, useful[1], 1.0];
    let known = Uncertainty::of(&Evidence {
        jacobian: &jacobian,
        residuals: &residuals,
        measured: count,
        scatter: Scatter::Either,
        useful: &useful_scaled,
        loss: Loss::LeastSquares,
    });
    let valley = ShearValley { points, law, uncertainty: &known, useful: useful_scaled };
    let angle_per_tangent = 1.0 / (1.0 + law.tan_friction * law.tan_friction); // dφ/d tan φ
    let slopes = [points.unit, angle_per_tangent, law.modulus];
    let at_zero = [law.cohesion == 0.0, law.tan_friction == 0.0, false];
    let estimates = std::array::from_fn(|i| {
        let scaled = [law.cohesion, law.tan_friction, law.modulus.ln()][i];
        let outward = |scaled: f64| [scaled * points.unit, scaled.atan(), scaled.exp()][i];
        let mut estimate = Estimate {
            unknown: [Unknown::Cohesion, Unknown::FrictionAngle, Unknown::ShearModulus][i],
            value: [cohesion, law.tan_friction.atan(), law.modulus][i],
            standard_error: known.standard_error[i].map(|error| error * slopes[i]),
            interval: known.half_width[i].map(|half| [outward(scaled - half), outward(scaled + half)]),
            at_bound: at_zero[i].then_some(Bound::Lower),
            identifiability: Identifiability::Uncertain,
        };
        if known.without_effect[i] {
            estimate.identifiability = Identifiability::WithoutEffect;
        } else if let Some(half) = known.half_width[i].filter(|half| *half <= useful_scaled[i])
            && let Ok(flanks) = Flanks::of(&valley, i, half)
        {
            estimate.interval = Some(flanks.ends(scaled).map(outward));
            estimate.identifiability = flanks.finding();
            if at_zero[i] && estimate.identifiability == Identifiability::Determined {
                estimate.identifiability = Identifiability::AtBound;
            }
            if matches!(estimate.identifiability, Identifiability::OneSided(_)) {
                estimate.standard_error = None;
            }
        }
        estimate
    });
    let law = Law { cohesion, ..*law };
    let predicted = curves.iter().map(|curve| curve.displacement.iter().map(|&j| law.shear(curve.normal, j)).collect()).collect();
    let rmse = points.unit * (residuals.iter().map(|residual| residual * residual).sum::<f64>() / count as f64).sqrt();
    ShearFit { estimates, predicted, correlation: known.correlation, rmse, degrees_of_freedom: known.degrees_of_freedom }
}

fn check(curves: &[ShearCurve]) -> Result<(), ShearError> {
    if !(2..=MOST_CURVES).contains(&curves.len()) {
        return Err(ShearError::Count);
    }
    let is_sound = |curve: &ShearCurve| {
        curve.normal.is_finite()
            && curve.normal >= 0.0
            && !curve.displacement.is_empty()
            && curve.displacement.len() == curve.shear.len()
            && curve.displacement.iter().all(|value| value.is_finite() && *value >= 0.0)
            && curve.shear.iter().all(|value| value.is_finite())
    };
    if let Some(curve) = curves.iter().position(|curve| !is_sound(curve)) {
        return Err(ShearError::Curve(curve));
    }
    let stresses = || curves.iter().map(|curve| curve.normal);
    let (low, high) = (stresses().fold(f64::INFINITY, f64::min), stresses().fold(0.0, f64::max));
    if high - low <= LEAST_STRESSES * high {
        return Err(ShearError::OneStress);
    }
    let any = |of: fn(&ShearCurve) -> &Vec<f64>| curves.iter().any(|curve| of(curve).iter().any(|value| *value > 0.0));
    if any(|curve| &curve.displacement) && any(|curve| &curve.shear) { Ok(()) } else { Err(ShearError::NoShear) }
}
