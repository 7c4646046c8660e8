//! How strong is the soil under a rolling wheel, right now? Cohesion and friction from torque, load, slip and sinkage by
//! linear least squares (Iagnemma, Kang, Shibly & Dubowsky 2004, Online terrain parameter estimation for wheeled mobile
//! robots with application to planetary rovers, IEEE Transactions on Robotics 20, 921).
//!
//! With the stresses linear on both sides of their peak, the torque gives the shear stress there, τm = T/(r_s² b H), and the
//! load the normal stress, σm = (W − r_s b B τm)/(r b A); then τm/E = c + σm tan φ is a straight line with one point per
//! sample. The pressure–sinkage law is eliminated; the shear modulus K enters E and has to be known.
//!
//! Assumed, as in the paper: the peak at the middle of the contact, the contact ends at the lowest point, Janosi–Hanamoto's E.
//! The paper's κ1 tan φ − κ3 c = −κ2 for a smooth wheel is the same line: κ2/κ3 = τm/E and −κ1/κ3 = σm, derived by putting the
//! closed forms of A, B and H into the two stresses, and tested. Departure: shear acts at r_s, so that lugs count as they do in
//! the model. What is not told: σm contains the torque too, so noise in it biases the slope towards zero.

use terramechanics::{Angles, Contact, Error, ShapeIntegrals, Slip, Wheel};

/// Least |E| of a sample that is used: below, the torque hardly shows the strength.
const LEAST_MOBILISATION: f64 = 0.05;

/// Relative spread of the normal stresses below which the line has no slope: rounding of the stresses.
const LEAST_SPREAD: f64 = 1e-6;

/// One sample of a rolling wheel.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct RollingSample {
    /// Slip s (–).
    pub slip: Slip,
    /// Sinkage z (m).
    pub sinkage: f64,
    /// Vertical load W (N).
    pub load: f64,
    /// Torque T (N·m).
    pub torque: f64,
}

/// Where a sample lies on the line τm/E = c + σm tan φ.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct StressPoint {
    /// Normal stress at the peak σm (Pa).
    pub normal: f64,
    /// Shear strength at the peak τm/E (Pa).
    pub strength: f64,
    /// E at the peak (–).
    pub mobilisation: f64,
}

impl StressPoint {
    /// The point of a sample on a soil with the shear modulus K (m); none where the wheel mobilises too little of the strength.
    ///
    /// # Errors
    /// A sinkage not in 0 < z ≤ r.
    pub fn of(wheel: &Wheel, shear_modulus: f64, sample: &RollingSample) -> Result<Option<Self>, Error> {
        let RollingSample { slip, sinkage, load, torque } = *sample;
        let radius = wheel.radius();
        if !(sinkage > 0.0 && sinkage <= radius) {
            return Err(Error::SinkageOutsideWheel { sinkage, radius });
        }
        let angles = Contact::MIDPOINT.angles(sinkage / radius, slip)?;
        let mobilisation = mobilisation(radius / shear_modulus, &angles, slip);
        let ShapeIntegrals { a, b, h } = ShapeIntegrals::of(&angles);
        let shear_arm = wheel.shearing_radius();
        let shear = torque / (shear_arm * shear_arm * wheel.width() * h);
        let normal = (load - shear_arm * wheel.width() * b * shear) / (radius * wheel.width() * a);
        let point = Self { normal, strength: shear / mobilisation, mobilisation };
        if !(point.normal.is_finite() && point.strength.is_finite()) {
            return Ok(None);
        }
        Ok((mobilisation.abs() >= LEAST_MOBILISATION).then_some(point))
    }

    /// The torque (N·m) that the line with this cohesion (Pa) and tan φ predicts for a sample: T solved from the two stresses.
    ///
    /// # Errors
    /// A sinkage not in 0 < z ≤ r.
    pub fn torque(
        wheel: &Wheel,
        shear_modulus: f64,
        sample: &RollingSample,
        cohesion: f64,
        tan_friction: f64,
    ) -> Result<f64, Error> {
        let RollingSample { slip, sinkage, load, .. } = *sample;
        let radius = wheel.radius();
        if !(sinkage > 0.0 && sinkage <= radius) {
            return Err(Error::SinkageOutsideWheel { sinkage, radius });
        }
        let angles = Contact::MIDPOINT.angles(sinkage / radius, slip)?;
        let mobilisation = mobilisation(radius / shear_modulus, &angles, slip);
        let ShapeIntegrals { a, b, h } = ShapeIntegrals::of(&angles);
        let shear_arm = wheel.shearing_radius();
        let pressing = tan_friction / (radius * wheel.width() * a);
        let shear = mobilisation * (cohesion + load * pressing) / (1.0 + mobilisation * shear_arm * wheel.width() * b * pressing);
        Ok(shear_arm * shear_arm * wheel.width() * h * shear)
    }
}

/// E at the peak by Janosi & Hanamoto, with the sign of the shear displacement; −1 on a locked wheel.
fn mobilisation(radius_per_modulus: f64, angles: &Angles, slip: Slip) -> f64 {
    if slip.is_locked() {
        return -1.0;
    }
    let ratio = slip.ratio();
    let velocity_ratio = if slip.is_driving() { 1.0 - ratio } else { 1.0 / (1.0 + ratio) };
    let arc = angles.entry - angles.peak;
    // sin θ1 − sin θm as a product, which keeps its digits on a small contact.
    let rise = 2.0 * (0.5 * (angles.entry + angles.peak)).cos() * (0.5 * arc).sin();
    let displacement = radius_per_modulus * (arc - velocity_ratio * rise);
    -(-displacement.abs()).exp_m1() * displacement.signum()
}

/// Strength of a soil with its covariance.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct StrengthEstimate {
    /// Cohesion c (Pa).
    pub cohesion: f64,
    /// tan φ (–).
    pub tan_friction: f64,
    /// Variance of c (Pa²), of tan φ (–) and their covariance (Pa); infinite where no freedom is left.
    pub cohesion_variance: f64,
    /// Variance of tan φ.
    pub tan_friction_variance: f64,
    /// Covariance of c and tan φ (Pa).
    pub covariance: f64,
    /// Samples minus two, where older samples count less than one.
    pub freedom: f64,
    /// Condition number of the line, with both columns of length one.
    pub condition_number: f64,
    /// Whether the bound c ≥ 0 or φ ≥ 0 holds it; then the other is the best there.
    pub bound: Option<StrengthBound>,
}

/// A bound that an unbounded line would cross.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum StrengthBound {
    /// c = 0.
    NoCohesion,
    /// tan φ = 0.
    NoFriction,
}

/// A line through the stress points that forgets: recursive least squares in constant memory.
///
/// Kept are the weight, the means and the centred moments of the points, each older one with a factor less: the information
/// form of recursive least squares, which needs no first guess of estimate and covariance.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct RunningStrength {
    wheel: Wheel,
    shear_modulus: f64,
    forgetting: f64,
    weight: f64,
    mean_normal: f64,
    mean_strength: f64,
    normal_normal: f64,
    normal_strength: f64,
    strength_strength: f64,
}

impl RunningStrength {
    /// An estimate without samples; none unless K (m) is positive and the forgetting factor in 0 < λ ≤ 1, 1 for never.
    #[must_use]
    pub fn new(wheel: Wheel, shear_modulus: f64, forgetting: f64) -> Option<Self> {
        let proper = shear_modulus.is_finite() && shear_modulus > 0.0 && forgetting > 0.0 && forgetting <= 1.0;
        proper.then_some(Self {
            wheel,
            shear_modulus,
            forgetting,
            weight: 0.0,
            mean_normal: 0.0,
            mean_strength: 0.0,
            normal_normal: 0.0,
            normal_strength: 0.0,
            strength_strength: 0.0,
        })
    }

    /// Takes a sample; whether it was used.
    ///
    /// # Errors
    /// A sinkage not in 0 < z ≤ r.
    pub fn take(&mut self, sample: &RollingSample) -> Result<bool, Error> {
        let Some(point) = StressPoint::of(&self.wheel, self.shear_modulus, sample)? else { return Ok(false) };
        let kept = self.forgetting;
        self.weight = kept * self.weight + 1.0;
        let (from_normal, from_strength) = (point.normal - self.mean_normal, point.strength - self.mean_strength);
        self.mean_normal += from_normal / self.weight;
        self.mean_strength += from_strength / self.weight;
        let (to_normal, to_strength) = (point.normal - self.mean_normal, point.strength - self.mean_strength);
        self.normal_normal = kept * self.normal_normal + from_normal * to_normal;
        self.normal_strength = kept * self.normal_strength + from_normal * to_strength;
        self.strength_strength = kept * self.strength_strength + from_strength * to_strength;
        Ok(true)
    }

    /// The estimate; none as long as fewer than two different normal stresses were seen.
    #[must_use]
    pub fn estimate(&self) -> Option<StrengthEstimate> {
        let Self { weight, mean_normal, mean_strength, normal_normal, normal_strength, strength_strength, .. } = *self;
        let spread = (normal_normal / weight.max(1.0)).sqrt();
        if weight <= 1.0 || spread <= LEAST_SPREAD * mean_normal.abs() {
            return None;
        }
        let tan_friction = normal_strength / normal_normal;
        let cohesion = mean_strength - tan_friction * mean_normal;
        let freedom = weight - 2.0;
        let about_zero = normal_normal + weight * mean_normal * mean_normal;
        // The two columns have the cosine Σσ/√(n Σσ²); of two unit vectors the singular values are √(1 ± cos). Their product is
        // the sine, which comes from the centred sum without cancellation.
        let sine = (normal_normal / about_zero).sqrt();
        let cosine = (weight * mean_normal * mean_normal / about_zero).sqrt();
        let condition_number = (1.0 + cosine) / sine;
        let bound = match (cohesion < 0.0, tan_friction < 0.0) {
            (true, _) => Some(StrengthBound::NoCohesion),
            (false, true) => Some(StrengthBound::NoFriction),
            (false, false) => None,
        };
        let (cohesion, tan_friction) = match bound {
            None => (cohesion, tan_friction),
            // Of a convex sum of squares with one bound broken, the best is on that bound.
            Some(StrengthBound::NoCohesion) => {
                (0.0, ((normal_strength + weight * mean_normal * mean_strength) / about_zero).max(0.0))
            }
            Some(StrengthBound::NoFriction) => (mean_strength.max(0.0), 0.0),
        };
        let (off_mean, slope) = (mean_strength - cohesion - tan_friction * mean_normal, tan_friction);
        let squares =
            strength_strength - 2.0 * slope * normal_strength + slope * slope * normal_normal + weight * off_mean * off_mean;
        let variance = if freedom > 0.0 { squares.max(0.0) / freedom } else { f64::INFINITY };
        Some(StrengthEstimate {
            cohesion,
            tan_friction,
            cohesion_variance: variance * (1.0 / weight + mean_normal * mean_normal / normal_normal),
            tan_friction_variance: variance / normal_normal,
            covariance: -variance * mean_normal / normal_normal,
            freedom,
            condition_number,
            bound,
        })
    }
}

/// The strength from samples that all count alike, and how many could be used.
///
/// # Errors
/// The row at fault, with a sinkage not in 0 < z ≤ r.
pub fn linear_strength(
    wheel: Wheel,
    shear_modulus: f64,
    samples: impl IntoIterator<Item = RollingSample>,
) -> Result<(Option<StrengthEstimate>, usize), (usize, Error)> {
    let Some(mut running) = RunningStrength::new(wheel, shear_modulus, 1.0) else { return Ok((None, 0)) };
    let mut used = 0;
    for (row, sample) in samples.into_iter().enumerate() {
        used += usize::from(running.take(&sample).map_err(|error| (row, error))?);
    }
    Ok((running.estimate(), used))
}
