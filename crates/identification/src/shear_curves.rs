//! How strong is the soil, from shear tests? Cohesion, friction and shear modulus from curves of shear stress over displacement.
//!
//! All curves are fitted at once by τ = (c + σ tan φ)(1 − e^(−j/K)) (Janosi & Hanamoto 1961). For a given K that is linear in c
//! and tan φ, so only K is searched: over six decades around the largest displacement, then by golden section. The search needs
//! no start and misses no local minimum that is wider than a step of the scan. The derivatives for the errors are analytic. The
//! sum of squares itself shows whether the data bound an estimate on both sides. Cohesion and friction are kept at or above 0.
//!
//! Validity: curves without a hump. The parameters do not show whether a curve has one; the residuals do.

use std::fmt;

use nalgebra::{DMatrix, DVector};

use crate::consent::{Consent, Stopped};
use crate::estimate::{Bound, Estimate, Identifiability};
use crate::loss::Loss;
use crate::observations::MOST_SAMPLES;
use crate::obstacle::Obstacle;
use crate::profile::Flanks;
use crate::range::{self, finite, finite_ends};
use crate::uncertainty::{Evidence, Scatter, Uncertainty};
use crate::unknown::Unknown;

mod points;

use self::points::{Law, Point, Points, ShearValley, mobilised, mobilised_by_log_modulus};

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
    /// A curve without points or with more than [`MOST_SAMPLES`], with columns of different length, or with a value that is not
    /// allowed.
    Curve(usize),
    /// All tests have one normal stress, so c and σ tan φ cannot be told apart.
    OneStress,
    /// Nothing is displaced, or there is no strength at all.
    NoShear,
    /// The largest displacement is too small or too large for ratios to be computed.
    Displacements,
    /// The largest stress is too small or too large to be squared and summed, or the normal stresses are negligible beside it.
    Stresses,
    /// A result leaves the range of numbers.
    NotFinite,
    /// The caller did not want the fit to go on.
    Stopped,
}

impl From<Stopped> for ShearError {
    fn from(_: Stopped) -> Self {
        Self::Stopped
    }
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
                    "all tests have one normal stress, so c and σ tan φ cannot be told apart; measure under two normal stresses"
                )
            }
            Self::NoShear => write!(f, "the curves show no strength: every displacement or every shear stress is 0"),
            Self::Displacements => write!(f, "the largest displacement {}", range::WORDS),
            Self::Stresses => {
                write!(f, "the largest stress {}, as must the share of the largest normal stress in it", range::WORDS)
            }
            Self::NotFinite => write!(f, "the values are too large or too small together"),
            Self::Stopped => write!(f, "the fit was told to stop"),
        }
    }
}

impl std::error::Error for ShearError {}

/// c, φ and K from shear tests at two or more normal stresses.
///
/// # Errors
/// [`ShearError`].
pub fn fit_shear_curves(curves: &[ShearCurve]) -> Result<ShearFit, ShearError> {
    fit_shear_curves_while(curves, &|| true)
}

/// Like [`fit_shear_curves`], as long as the caller wants to go on. The caller is asked about every thousand points.
///
/// # Errors
/// [`ShearError::Stopped`] at the first no, and those of [`fit_shear_curves`].
pub fn fit_shear_curves_while(curves: &[ShearCurve], go_on: &dyn Fn() -> bool) -> Result<ShearFit, ShearError> {
    check(curves)?;
    let largest_normal = range::largest(curves.iter().map(|curve| curve.normal));
    let unit = range::largest(curves.iter().flat_map(|curve| &curve.shear).copied()).max(largest_normal);
    let farthest = range::largest(curves.iter().flat_map(|curve| &curve.displacement).copied());
    if !range::is_usable(farthest) {
        return Err(ShearError::Displacements);
    }
    if !(range::is_usable(unit) && range::is_usable(largest_normal / unit)) {
        return Err(ShearError::Stresses);
    }
    let list = curves.iter().flat_map(|curve| {
        let point =
            move |(&displacement, &shear): (&f64, &f64)| Point { normal: curve.normal / unit, displacement, shear: shear / unit };
        curve.displacement.iter().zip(&curve.shear).map(point)
    });
    let consent = Consent::new(go_on);
    let points = Points { list: list.collect(), unit, farthest, consent: &consent };
    if !points.list.iter().any(|point| point.displacement > 0.0 && point.shear > 0.0) {
        return Err(ShearError::NoShear);
    }
    let fit = report(curves, &points, &points.best()?)?;
    let values = fit.estimates.iter().map(|estimate| estimate.value).chain([fit.rmse]);
    let predicted = fit.predicted.iter().flatten().copied();
    if values.chain(predicted).all(f64::is_finite) { Ok(fit) } else { Err(ShearError::NotFinite) }
}

/// Residuals and their derivatives with respect to c, tan φ and ln K, with at least three rows.
fn evidence(points: &Points<'_>, law: &Law) -> Result<(DMatrix<f64>, DVector<f64>), Stopped> {
    let rows = points.list.len().max(3);
    let (mut jacobian, mut residuals) = (DMatrix::zeros(rows, 3), DVector::zeros(rows));
    points.each(|i, &Point { normal, displacement, shear }| {
        let share = mobilised(displacement, law.modulus);
        jacobian[(i, 0)] = share;
        jacobian[(i, 1)] = normal * share;
        jacobian[(i, 2)] = law.strength(normal) * mobilised_by_log_modulus(displacement, law.modulus);
        residuals[i] = law.shear(normal, displacement) - shear;
    })?;
    Ok((jacobian, residuals))
}

fn report(curves: &[ShearCurve], points: &Points<'_>, law: &Law) -> Result<ShearFit, ShearError> {
    let count = points.list.len();
    let (jacobian, residuals) = evidence(points, law)?;
    let cohesion = law.cohesion * points.unit;
    let useful = [cohesion.max(500.0) / points.unit, 0.25, 1.0];
    let known = Uncertainty::of(
        &Evidence {
            jacobian: &jacobian,
            residuals: &residuals,
            measured: count,
            scatter: Scatter::Either,
            useful: &useful,
            loss: Loss::LeastSquares,
        },
        points.consent,
    );
    let known = match known {
        Ok(known) => Some(known),
        Err(Obstacle::Budget) => return Err(ShearError::Stopped),
        Err(Obstacle::Row { .. } | Obstacle::Values) => None,
    };
    let angle_per_tangent = 1.0 / (1.0 + law.tan_friction * law.tan_friction); // dφ/d tan φ
    let slopes = [points.unit, angle_per_tangent, law.modulus];
    let at_zero = [law.cohesion == 0.0, law.tan_friction == 0.0, false];
    let mut estimates = std::array::from_fn(|i| Estimate {
        unknown: [Unknown::COHESION, Unknown::FRICTION_ANGLE, Unknown::SHEAR_MODULUS][i],
        value: [cohesion, law.tan_friction.atan(), law.modulus][i],
        standard_error: None,
        interval: None,
        at_bound: at_zero[i].then_some(Bound::Lower),
        identifiability: Identifiability::Uncertain,
    });
    for (i, estimate) in estimates.iter_mut().enumerate() {
        let Some(known) = &known else { break };
        let scaled = [law.cohesion, law.tan_friction, law.modulus.ln()][i];
        let outward = |scaled: f64| [scaled * points.unit, scaled.atan(), scaled.exp()][i];
        estimate.standard_error = known.standard_error[i].and_then(|error| finite(error * slopes[i]));
        estimate.interval = known.half_width[i].and_then(|half| finite_ends([outward(scaled - half), outward(scaled + half)]));
        if known.without_effect[i] {
            estimate.identifiability = Identifiability::WithoutEffect;
        } else if let Some(half) = known.half_width[i].filter(|half| *half <= useful[i]) {
            let valley = ShearValley { points, law, uncertainty: known, useful };
            let flanks = Flanks::of(&valley, i, half).map_err(|_| ShearError::Stopped)?; // nothing else stands in its way
            estimate.interval = finite_ends(flanks.ends(scaled).map(outward));
            estimate.identifiability = flanks.finding();
            if at_zero[i] && estimate.identifiability == Identifiability::Determined {
                estimate.identifiability = Identifiability::AtBound;
            }
            if matches!(estimate.identifiability, Identifiability::OneSided(_)) {
                estimate.standard_error = None;
            }
        }
    }
    let whole = Law { cohesion, ..*law };
    let predicted = curves.iter().map(|curve| {
        points.consent.ask()?;
        Ok(curve.displacement.iter().map(|&j| whole.shear(curve.normal, j)).collect())
    });
    let predicted = predicted.collect::<Result<_, Stopped>>()?;
    let rmse = points.unit * (residuals.iter().map(|residual| residual * residual).sum::<f64>() / count as f64).sqrt();
    let unknown = || vec![vec![None; 3]; 3];
    Ok(ShearFit {
        estimates,
        predicted,
        correlation: known.as_ref().map_or_else(unknown, |known| known.correlation.clone()),
        rmse,
        degrees_of_freedom: known.as_ref().map_or(count as f64 - 3.0, |known| known.degrees_of_freedom),
    })
}

fn check(curves: &[ShearCurve]) -> Result<(), ShearError> {
    if !(2..=MOST_CURVES).contains(&curves.len()) {
        return Err(ShearError::Count);
    }
    let is_sound = |curve: &ShearCurve| {
        curve.normal.is_finite()
            && curve.normal >= 0.0
            && (1..=MOST_SAMPLES).contains(&curve.displacement.len())
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
