//! The linear estimate of the strength from measured samples, reported like every other fit: errors, and what the samples leave
//! open.

use terramechanics::{Coupled, Error, ForceModel, Method, Sinkage, Soil, SoilParams};

use super::{RollingSample, StrengthBound, StrengthEstimate, StressPoint, linear_strength};
use crate::consent::Consent;
use crate::design::{self, DesignGap};
use crate::error::FitError;
use crate::estimate::{Bound, Estimate, Identifiability};
use crate::fitted_column::FittedColumn;
use crate::observations::{Column, Observations};
use crate::quantity::Quantity;
use crate::range::{finite, finite_ends, is_summable};
use crate::setup::{Prediction, Setup, SinkageSource};
use crate::student::quantile_95;
use crate::unknown::Unknown;

/// The unknowns of the line, in the order of its estimates.
const SOUGHT: [Unknown; 2] = [Unknown::COHESION, Unknown::FRICTION_ANGLE];

/// Residual of the normal equations, relative to their sums, that counts as zero: rounding over ten thousand samples.
const SOLVED: f64 = 1e-8;

/// Steps of the search for the true strength behind an estimate, and the share of the difference in cohesion that a step takes.
/// Linear stresses overstate a cohesion by up to a factor of two, so half steps converge.
const BIAS_STEPS: usize = 6;
const BIAS_STEP: f64 = 0.55;

/// The result of a line through samples.
#[derive(Debug, Clone, PartialEq)]
pub struct LinearFit {
    /// Cohesion and friction angle. Their errors cover noise in the samples, not errors of the model.
    pub estimates: [Estimate; 2],
    /// The line itself.
    pub line: StrengthEstimate,
    /// Whether the normal equations hold or, at a bound, call for a value beyond it.
    pub converged: bool,
    /// Correlation of the two; none without an error.
    pub correlation: Option<f64>,
    /// What the operating points do not vary.
    pub gaps: Vec<DesignGap>,
    /// Samples that mobilise enough of the strength to be used.
    pub used: usize,
    /// The torque, measured and predicted by Ding's coupled form at the estimates.
    pub torque: FittedColumn,
    /// The setup with the estimates.
    pub setup: Setup,
    samples: Vec<RollingSample>,
}

/// Cohesion and friction from measured slip, sinkage, normal force and torque; none where the normal stress is the same in all
/// samples. It uses the wheel, the contact, the shear law and the radius of the normal stress of `setup`.
///
/// # Errors
/// [`FitError::Missing`] and [`FitError::Value`] for columns that cannot be used, [`FitError::Refused`] for a sample that the
/// linear stresses do not describe.
pub fn fit_line(setup: &Setup, observations: &Observations) -> Result<Option<LinearFit>, FitError> {
    fit_line_while(setup, observations, &|| true)
}

/// Like [`fit_line`], as long as the caller wants to go on. The caller is asked before every sample, which takes some
/// microseconds.
///
/// # Errors
/// [`FitError::Stopped`] at the first no, and those of [`fit_line`].
pub fn fit_line_while(
    setup: &Setup,
    observations: &Observations,
    go_on: &dyn Fn() -> bool,
) -> Result<Option<LinearFit>, FitError> {
    let consent = Consent::new(go_on);
    let found = found(setup, observations, &consent);
    if consent.is_withdrawn() { Err(FitError::Stopped) } else { found }
}

fn found(setup: &Setup, observations: &Observations, consent: &Consent<'_>) -> Result<Option<LinearFit>, FitError> {
    let samples = samples(observations)?;
    let refused = |(row, error): (usize, Error)| FitError::Refused { row, error };
    let unsound = |_| FitError::Refused { row: 0, error: Error::NotFinite };
    let system = setup.system().map_err(unsound)?;
    let radius = setup.model.normal_stress_radius;
    let (line, used) = linear_strength(system, radius, while_wanted(&samples, consent)).map_err(refused)?;
    let Some(line) = line else { return Ok(None) };
    let (cohesion, friction_angle) = (line.cohesion, line.tan_friction.atan());
    let setup = Setup { soil: SoilParams { cohesion, friction_angle, ..setup.soil }, ..*setup };
    let system = terramechanics::WheelOnSoil { soil: Soil::new(setup.soil).map_err(unsound)?, ..system };
    let mut points = Vec::with_capacity(samples.len());
    let mut predicted = Vec::with_capacity(samples.len());
    for (row, sample) in while_wanted(&samples, consent).enumerate() {
        let refused = |error| refused((row, error));
        points.extend(StressPoint::of(&system, radius, &sample).map_err(refused)?);
        let rolling = system.rolling(sample.slip).map_err(refused)?;
        let patch = rolling.contact(sample.sinkage).map_err(refused)?;
        let known = Coupled { normal_load: sample.load, torque: None, normal_stress_radius: radius };
        let forces = known.forces(&patch).map_err(refused)?;
        let (longitudinal, torque) = (forces.longitudinal, forces.torque);
        if !(is_summable(longitudinal) && is_summable(torque)) {
            return Err(refused(Error::NotFinite));
        }
        predicted.push(Prediction { sinkage: sample.sinkage, longitudinal, normal: sample.load, torque });
    }
    // The shear modulus is taken as known. Samples of one slip could not find it, and they cannot reveal that it is wrong either.
    let unknowns = [Unknown::SHEAR_MODULUS, Unknown::COHESION, Unknown::FRICTION_ANGLE];
    let gaps: Vec<_> =
        design::gaps(observations, &[Quantity::Torque], &unknowns, &predicted).into_iter().map(|(gap, _)| gap).collect();
    let correlation = line.covariance / (line.cohesion_variance * line.tan_friction_variance).sqrt();
    let measured = samples.iter().map(|sample| sample.torque).collect();
    Ok(Some(LinearFit {
        estimates: estimates(&line, &setup, &gaps),
        converged: is_solved(&line, &points),
        correlation: correlation.is_finite().then(|| correlation.clamp(-1.0, 1.0)),
        gaps,
        used,
        torque: FittedColumn::new(Quantity::Torque, measured, predicted.iter().map(|prediction| prediction.torque).collect()),
        setup,
        samples,
        line,
    }))
}

impl LinearFit {
    /// Whether the data determine both; one at a bound counts.
    #[must_use]
    pub fn is_identifiable(&self) -> bool {
        self.estimates.iter().all(|estimate| estimate.identifiability.is_determined())
    }

    /// Number of samples.
    #[must_use]
    pub fn samples(&self) -> usize {
        self.samples.len()
    }

    /// Bias of cohesion (Pa) and friction angle (rad) from the assumption of linear stresses, for the pressure–sinkage law of
    /// the setup. It is the estimate minus the true strength behind it: the strength for which the quadrature, at the measured
    /// slips and sinkages, predicts loads and torques whose line gives this estimate. None where the model has no answer for a
    /// sample.
    #[must_use]
    pub fn model_bias(&self) -> Option<[f64; 2]> {
        self.model_bias_while(&|| true).ok().flatten()
    }

    /// Like [`LinearFit::model_bias`], as long as the caller wants to go on. The caller is asked before every sample, each of
    /// which takes an integral.
    ///
    /// # Errors
    /// [`FitError::Stopped`] at the first no.
    pub fn model_bias_while(&self, go_on: &dyn Fn() -> bool) -> Result<Option<[f64; 2]>, FitError> {
        let consent = Consent::new(go_on);
        let bias = self.bias(&consent);
        if consent.is_withdrawn() { Err(FitError::Stopped) } else { Ok(bias.and_then(finite_ends)) }
    }

    fn bias(&self, consent: &Consent<'_>) -> Option<[f64; 2]> {
        let [cohesion, friction_angle] = [self.setup.soil.cohesion, self.setup.soil.friction_angle];
        let mut truth = self.setup.soil;
        for _ in 0..BIAS_STEPS {
            let line = self.line_on(truth, consent)?;
            truth.cohesion = (truth.cohesion - BIAS_STEP * (line.cohesion - cohesion)).max(0.0);
            truth.friction_angle -= line.tan_friction.atan() - friction_angle;
        }
        Some([cohesion - truth.cohesion, friction_angle - truth.friction_angle])
    }

    /// The line through the samples that the quadrature predicts on another soil.
    fn line_on(&self, soil: SoilParams, consent: &Consent<'_>) -> Option<StrengthEstimate> {
        let radius = self.setup.model.normal_stress_radius;
        let model = ForceModel { method: Method::Quadrature, normal_stress_radius: radius };
        let exact = Setup { soil, model, ..self.setup };
        let system = exact.system().ok()?;
        let simulated: Result<Vec<_>, _> = while_wanted(&self.samples, consent)
            .map(|sample| {
                let forces = exact.predicted(&system, sample.slip, Sinkage::Given(sample.sinkage))?;
                Ok::<_, Error>(RollingSample { load: forces.normal, torque: forces.torque, ..sample })
            })
            .collect();
        linear_strength(system, radius, while_wanted(&simulated.ok()?, consent)).ok()?.0
    }
}

/// The samples, up to where the caller does not want to go on.
fn while_wanted(samples: &[RollingSample], consent: &Consent<'_>) -> impl Iterator<Item = RollingSample> {
    samples.iter().copied().take_while(|_| consent.ask().is_ok())
}

fn samples(observations: &Observations) -> Result<Vec<RollingSample>, FitError> {
    observations.check(&SinkageSource::Measured)?;
    let values = |quantity: Quantity| match observations.column(quantity) {
        Some(Column { values, .. }) => Ok(values),
        None => Err(FitError::Missing(quantity)),
    };
    let (sinkages, loads, torques) = (values(Quantity::Sinkage)?, values(Quantity::Normal)?, values(Quantity::Torque)?);
    if let Some(row) = loads.iter().position(|&load| load <= 0.0) {
        return Err(FitError::Value { quantity: Quantity::Normal, row });
    }
    let columns = sinkages.iter().zip(loads).zip(torques);
    let slips = observations.slip.iter();
    Ok(slips.zip(columns).map(|(&slip, ((&sinkage, &load), &torque))| RollingSample { slip, sinkage, load, torque }).collect())
}

/// Whether the residuals e have Σe = 0 and Σe σm = 0; at a bound the sum may call for a value beyond it.
fn is_solved(line: &StrengthEstimate, points: &[StressPoint]) -> bool {
    let StrengthEstimate { cohesion, tan_friction, bound, .. } = *line;
    let [mut height, mut slope, mut heights, mut slopes] = [0.0; 4];
    for point in points {
        let friction = tan_friction * point.normal;
        let residual = point.strength - cohesion - friction;
        let size = point.strength.abs() + cohesion + friction.abs();
        height += residual;
        slope += residual * point.normal;
        heights += size;
        slopes += size * point.normal.abs();
    }
    let holds = |sum: f64, sizes: f64, beyond: bool| sum.abs() <= SOLVED * sizes || (beyond && sum < 0.0);
    holds(height, heights, bound == Some(StrengthBound::NoCohesion) || cohesion == 0.0)
        && holds(slope, slopes, bound == Some(StrengthBound::NoFriction) || tan_friction == 0.0)
}

fn estimates(line: &StrengthEstimate, setup: &Setup, gaps: &[DesignGap]) -> [Estimate; 2] {
    let angle_per_tangent = 1.0 / (1.0 + line.tan_friction * line.tan_friction); // dφ/d tan φ
    let numbers = [
        (line.cohesion, line.cohesion_variance.sqrt(), line.bound == Some(StrengthBound::NoCohesion)),
        (
            line.tan_friction.atan(),
            line.tan_friction_variance.sqrt() * angle_per_tangent,
            line.bound == Some(StrengthBound::NoFriction),
        ),
    ];
    let factor = quantile_95(line.freedom);
    [0, 1].map(|i| {
        let (value, error, is_held) = numbers[i];
        let unknown = SOUGHT[i];
        let standard_error = finite(error).filter(|_| line.freedom >= 1.0);
        let half = standard_error.and_then(|error| finite(factor * error));
        let at_bound = is_held.then_some(Bound::Lower);
        let identifiability = match gaps.first() {
            Some(DesignGap::OneSlip) => Identifiability::Unseparated(DesignGap::OneSlip, vec![Unknown::SHEAR_MODULUS]),
            Some(&gap) => Identifiability::Unseparated(gap, vec![SOUGHT[1 - i]]),
            None if half.is_none_or(|half| half > unknown.useful_width(value, setup)) => Identifiability::Uncertain,
            None if at_bound.is_some() => Identifiability::AtBound,
            None => Identifiability::Determined,
        };
        let interval = half.and_then(|half| finite_ends([value - half, value + half]));
        Estimate { unknown, value, standard_error, interval, at_bound, identifiability }
    })
}
