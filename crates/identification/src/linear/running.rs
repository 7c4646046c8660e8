//! A running estimate of the strength that forgets old samples: recursive least squares in constant memory, with the covariance
//! for weighted samples.
//!
//! Sample i of n has the weight w_i = λ^(n−i); X has a row (1, σm) and y a value τm/E per sample, W = diag(w). Derived here:
//!
//! * estimate β = (XᵀWX)⁻¹XᵀWy;
//! * covariance under independent noise of one variance s²: s² (XᵀWX)⁻¹ XᵀW²X (XᵀWX)⁻¹. The weights express age,
//!   not accuracy, so they do not cancel;
//! * e = y − Xβ has eᵀWe = yᵀGy with G = W − WX(XᵀWX)⁻¹XᵀW, whose expectation is s² tr G, where
//!   tr G = Σw − tr[(XᵀWX)⁻¹XᵀW²X]. So s² = eᵀWe/tr G.
//!
//! With the mean m of the stresses under the weights w, XᵀWX is diagonal in the basis (1, σm − m): S = Σw and M = Σw (σm − m)².
//! XᵀW²X has the sums with w², about their own mean m₂: P₀ = Σw², P₁ = P₀ (m₂ − m), P₂ = Σw² (σm − m₂)² + P₀ (m₂ − m)². All
//! follow by one recursion, that of means and centred squares, with λ or with λ². Hence, for the height a = c + m tan φ of the
//! line at the mean: var a = s² P₀/S², cov(a, tan φ) = s² P₁/(S M), var tan φ = s² P₂/M², and tr G = S − P₀/S − P₂/M.
//! For λ = 1 these are the formulas of ordinary least squares, with tr G = n − 2.

use terramechanics::{
    Error, KnownSinkage, NormalStressRadius, Sample, SampleMotion, Sinkage, Slip, Status, TrackRow, WheelOnSoil,
};

use super::{RollingSample, StressPoint};
use crate::design::{LOAD_SPREAD, SLIP_SPREAD};
use crate::range;

/// Relative spread of the normal stresses below which the slope is undefined: the stresses differ by rounding alone.
const LEAST_SPREAD: f64 = 1e-6;

/// tr G below this is rounding, and no degree of freedom is left. Three samples give at least λ².
const LEAST_FREEDOM: f64 = 1e-6;

/// Strength of a soil with its covariance, which covers noise in the samples, not errors of the model.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct StrengthEstimate {
    /// Cohesion c (Pa).
    pub cohesion: f64,
    /// tan φ (–).
    pub tan_friction: f64,
    /// Variance of c (Pa²) without the bound. Like the other two it is infinite where no degree of freedom is left.
    pub cohesion_variance: f64,
    /// Variance of tan φ (–) without the bound.
    pub tan_friction_variance: f64,
    /// Covariance of c and tan φ (Pa) without the bound.
    pub covariance: f64,
    /// tr G of the module's head: the number of samples minus two where none is forgotten. With forgetting it is less than the
    /// degrees of freedom (tr G)²/tr G² by which the variance scatters, because no eigenvalue of G exceeds 1.
    pub freedom: f64,
    /// Condition number of the line, with both columns of length one.
    pub condition_number: f64,
    /// The bound c ≥ 0 or φ ≥ 0 that is active, if one is; the other parameter is then the best at that bound.
    pub bound: Option<StrengthBound>,
}

/// A bound that the unbounded estimate would cross.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum StrengthBound {
    /// c = 0.
    NoCohesion,
    /// tan φ = 0.
    NoFriction,
}

/// Mean and centred sum of squares of a quantity under weights that are known.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
struct Moments {
    mean: f64,
    squares: f64,
}

impl Moments {
    /// Adds a value of weight 1. The others keep a share `kept` of their weights, and the total becomes `weight`. Returns how
    /// far the value lies from the mean before and after.
    fn take(&mut self, value: f64, kept: f64, weight: f64) -> (f64, f64) {
        let before = value - self.mean;
        self.mean += before / weight;
        let after = value - self.mean;
        self.squares = kept * self.squares + before * after;
        (before, after)
    }
}

/// What the samples of a run leave open, counted over the rows that have an estimate.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub struct StrengthTally {
    /// Rows with an estimate.
    pub estimates: u64,
    /// Rows whose remembered samples have one load.
    pub one_load: u64,
    /// Rows whose remembered samples have one slip.
    pub one_slip: u64,
    /// Rows with the cohesion held at 0.
    pub no_cohesion: u64,
    /// Rows with the friction held at 0.
    pub no_friction: u64,
}

/// The strength, updated with every sample in constant memory. It uses the information form of recursive least squares, which
/// needs no first guess of estimate and covariance.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct RunningStrength {
    system: WheelOnSoil,
    radius: NormalStressRadius,
    forgetting: f64,
    /// Σw and Σw².
    weight: f64,
    squared_weight: f64,
    normal: Moments,
    strength: Moments,
    /// Σw of both, centred.
    product: f64,
    /// Mean and centred sum of squares of the normal stress under the squared weights.
    squared_normal: Moments,
    load: Moments,
    slip: Moments,
    tally: StrengthTally,
}

impl RunningStrength {
    /// An estimate without samples, for a wheel on a soil whose shear law is known; none unless the forgetting factor is in
    /// 0 < λ ≤ 1, 1 for never.
    #[must_use]
    pub fn new(system: WheelOnSoil, radius: NormalStressRadius, forgetting: f64) -> Option<Self> {
        let none = Moments::default();
        (forgetting > 0.0 && forgetting <= 1.0).then_some(Self {
            system,
            radius,
            forgetting,
            weight: 0.0,
            squared_weight: 0.0,
            normal: none,
            strength: none,
            product: 0.0,
            squared_normal: none,
            load: none,
            slip: none,
            tally: StrengthTally::default(),
        })
    }

    /// Adds a sample and returns whether it was used. A refused sample leaves the estimate unchanged.
    ///
    /// # Errors
    /// Those of [`StressPoint::of`], and [`Error::NotFinite`] for stresses whose squares could not be summed.
    pub fn take(&mut self, sample: &RollingSample) -> Result<bool, Error> {
        let Some(point) = StressPoint::of(&self.system, self.radius, sample)? else { return Ok(false) };
        if ![point.normal, point.strength, sample.load].into_iter().all(range::is_summable) {
            return Err(Error::NotFinite);
        }
        let kept = self.forgetting;
        self.weight = kept * self.weight + 1.0;
        self.squared_weight = kept * kept * self.squared_weight + 1.0;
        let (from_normal, _) = self.normal.take(point.normal, kept, self.weight);
        let (_, to_strength) = self.strength.take(point.strength, kept, self.weight);
        self.product = kept * self.product + from_normal * to_strength;
        self.squared_normal.take(point.normal, kept * kept, self.squared_weight);
        self.load.take(sample.load, kept, self.weight);
        self.slip.take(sample.slip.ratio(), kept, self.weight);
        Ok(true)
    }

    /// The estimate after a sample of a track and its row. It is unchanged by a sample without a result, at rest, without a
    /// measured torque, load and sinkage, or that mobilises too little.
    pub fn follow(&mut self, sample: &Sample, row: &TrackRow) -> Option<StrengthEstimate> {
        if let Some(sample) = rolling_sample(sample, row) {
            // The row has a result, so the only refusal left is an overflow.
            let _ = self.take(&sample);
        }
        let estimate = self.estimate()?;
        let count = |count: &mut u64, counts: bool| *count += u64::from(counts);
        let (one_load, one_slip) = (self.has_one_load(), self.has_one_slip());
        count(&mut self.tally.estimates, true);
        count(&mut self.tally.one_load, one_load);
        count(&mut self.tally.one_slip, one_slip);
        count(&mut self.tally.no_cohesion, estimate.bound == Some(StrengthBound::NoCohesion));
        count(&mut self.tally.no_friction, estimate.bound == Some(StrengthBound::NoFriction));
        Some(estimate)
    }

    /// What the samples so far leave open.
    #[must_use]
    pub fn tally(&self) -> &StrengthTally {
        &self.tally
    }

    fn has_one_load(&self) -> bool {
        (self.load.squares / self.weight).sqrt() < LOAD_SPREAD * self.load.mean
    }

    /// The standard deviation of slips within a range is at most half of the range.
    fn has_one_slip(&self) -> bool {
        (self.slip.squares / self.weight).sqrt() < 0.5 * SLIP_SPREAD
    }

    /// The estimate; none until two different normal stresses were seen, or where their squares underflow.
    #[must_use]
    pub fn estimate(&self) -> Option<StrengthEstimate> {
        let Self { weight, squared_weight, product, .. } = *self;
        let Moments { mean, squares } = self.normal;
        let spread = (squares / weight.max(1.0)).sqrt();
        if weight <= 1.0 || spread <= LEAST_SPREAD * mean.abs() || !range::is_usable(spread) {
            return None;
        }
        let about_zero = squares + weight * mean * mean;
        let Strength { cohesion, tan_friction, bound } = self.strength(about_zero);
        if !(cohesion.is_finite() && tan_friction.is_finite()) {
            return None;
        }
        let off_mean = self.strength.mean - cohesion - tan_friction * mean;
        let residuals = self.strength.squares - 2.0 * tan_friction * product
            + tan_friction * tan_friction * squares
            + weight * off_mean * off_mean;
        let shift = self.squared_normal.mean - mean;
        let first = squared_weight * shift; // P₁
        let second = self.squared_normal.squares + first * shift; // P₂
        let freedom = weight - squared_weight / weight - second / squares;
        let is_known = freedom > LEAST_FREEDOM && residuals.is_finite();
        let noise = if is_known { residuals.max(0.0) / freedom } else { f64::INFINITY };
        let times_noise = |share: f64| if is_known { noise * share } else { f64::INFINITY };
        let height = squared_weight / (weight * weight);
        let mixed = first / (weight * squares);
        let slope = second / squares / squares;
        // The two columns have the cosine Σwσ/√(Σw Σwσ²); of two unit vectors the singular values are √(1 ± cos). Their product
        // is the sine, which comes from the centred sum without cancellation.
        let sine = (squares / about_zero).sqrt();
        let cosine = (weight * mean * mean / about_zero).sqrt();
        Some(StrengthEstimate {
            cohesion,
            tan_friction,
            cohesion_variance: times_noise(height - 2.0 * mean * mixed + mean * mean * slope),
            tan_friction_variance: times_noise(slope),
            covariance: times_noise(mixed - mean * slope),
            freedom: freedom.max(0.0),
            condition_number: (1.0 + cosine) / sine,
            bound,
        })
    }

    /// The best line with c ≥ 0 and tan φ ≥ 0. The sum of squares is convex, so where one bound is broken the best lies on that
    /// bound.
    fn strength(&self, about_zero: f64) -> Strength {
        let (mean, squares) = (self.normal.mean, self.normal.squares);
        let tan_friction = self.product / squares;
        let cohesion = self.strength.mean - tan_friction * mean;
        if cohesion < 0.0 {
            let through_zero = (self.product + self.weight * mean * self.strength.mean) / about_zero;
            Strength { cohesion: 0.0, tan_friction: through_zero.max(0.0), bound: Some(StrengthBound::NoCohesion) }
        } else if tan_friction < 0.0 {
            let cohesion = self.strength.mean.max(0.0);
            Strength { cohesion, tan_friction: 0.0, bound: Some(StrengthBound::NoFriction) }
        } else {
            Strength { cohesion, tan_friction, bound: None }
        }
    }
}

struct Strength {
    cohesion: f64,
    tan_friction: f64,
    bound: Option<StrengthBound>,
}

/// The rolling sample in a sample of a track; none unless the wheel moves and sinkage, load and torque were measured.
fn rolling_sample(sample: &Sample, row: &TrackRow) -> Option<RollingSample> {
    let (Status::Ok, Some(measured)) = (row.status, sample.measured) else { return None };
    let (Sinkage::Given(sinkage) | Sinkage::UnderLoad { sinkage: KnownSinkage::Given(sinkage), .. }) = sample.sinkage else {
        return None;
    };
    // A wheel that moves backwards is the mirror image: its torque drives it the other way.
    let torque = match sample.motion {
        SampleMotion::Velocities(velocities) => velocities.heading().as_forward(measured.torque),
        SampleMotion::Slip(_) => measured.torque,
    };
    Some(RollingSample { slip: Slip::new(row.slip).ok()?, sinkage, load: measured.normal_load, torque })
}

/// The strength from equally weighted samples, and how many of them could be used.
///
/// # Errors
/// The row at fault, with a refusal of [`StressPoint::of`].
pub fn linear_strength(
    system: WheelOnSoil,
    radius: NormalStressRadius,
    samples: impl IntoIterator<Item = RollingSample>,
) -> Result<(Option<StrengthEstimate>, usize), (usize, Error)> {
    let Some(mut running) = RunningStrength::new(system, radius, 1.0) else { return Ok((None, 0)) };
    let mut used = 0;
    for (row, sample) in samples.into_iter().enumerate() {
        used += usize::from(running.take(&sample).map_err(|error| (row, error))?);
    }
    Ok((running.estimate(), used))
}
