//! How deep does a loaded wheel sink? The sinkage at which the normal force balances the load.
//!
//! F_z grows about as z^(N + 1/2), so the search uses y = sgn(F_z) |F_z|^(1/(N + 1/2)), which is nearly a straight line in z. A
//! bracket from one guess and Brent's method then need few evaluations. On a driving wheel whose exit is at the lowest point
//! F_z grows with z, and the balance is unique. Otherwise the search finds the balance nearest to Bekker's estimate at which
//! F_z rises through the load, because a wheel that is set on the soil comes to rest there.
//!
//! Where the balance is unique, it is approached by the slope of the normal force first (`approach.rs`), and the bracket decides
//! only where that finds none.
//!
//! The two zones of a braking wheel need a least sinkage, below which there is no contact. The search then runs over the sinkage
//! beyond it, which is the depth under the peak.

use crate::error::Error;
use crate::forces::{ForceModel, Forces, Method, resistive};
use crate::numerics::brent::{Sample, bracketed_root};
use crate::pressure_sinkage::PressureCurve;
use crate::resistive_force::equivalent_modulus;
use crate::rolling::{Rolling, WheelOnSoil};
use crate::wheel::Wheel;

/// Relative tolerance of the sinkage, as small as the error of the quadrature allows.
const TOLERANCE: f64 = 1e-13;

/// Residual, relative to the scale of the normal force, beyond which a balance counts as not met.
const LARGEST_RESIDUAL: f64 = 1e-9;

/// Largest error of an answer as a share of the load. Where the parts of the normal force are so large beside the load that their
/// rounding exceeds this, there is no answer.
const LARGEST_MISS: f64 = 1e-6;

/// Most steps outward for a bracket. Even at their least growth they cover 27 decades of sinkage.
const BRACKET_STEPS: u32 = 30;

/// Least growth of the first outward step; it doubles with every step. A contact with two zones in cohesive soil carries load
/// at zero depth, and a line through the origin then says little about where the balance is.
const FIRST_STRIDE: f64 = 0.02;

/// Largest factor of an outward step.
const LONGEST_STRIDE: f64 = 16.0;

/// Distance from the least sinkage, as a share of it, within which no balance is sought, so that digits remain to tell the two
/// apart.
const NEAREST: f64 = 1e-12;

/// Number of depths at which the normal force is sampled where it does not reach the load at z = r.
const CAPACITY_SAMPLES: u32 = 64;

/// Steps of the search for the largest normal force. The force is flat at its maximum, so 1e-8 of a stride in place gives its
/// value to rounding.
const SUMMIT_STEPS: u32 = 40;

/// A solved load balance.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct CarriedLoad {
    /// Sinkage z (m).
    pub sinkage: f64,
    /// Remaining difference, normal force minus load (N).
    pub residual: f64,
    /// Evaluations of the forces.
    pub iterations: u32,
    /// The forces at that sinkage.
    pub forces: Forces,
}

impl ForceModel {
    /// The sinkage z in 0 < z ≤ r at which the normal force equals `load` (N), by the same method as the forces.
    ///
    /// # Errors
    /// [`Error::Invalid`] for a load not greater than 0; [`Error::LoadBeyondCapacity`] with the largest load the soil carries;
    /// [`Error::LoadTooLight`] with the least that a braking wheel with two zones carries; [`Error::LoadNotBalanced`] with the
    /// best found, where that misses the load by more than a millionth of it; what [`Rolling::contact`] and
    /// [`ForceModel::forces`] refuse.
    pub fn solve_sinkage(&self, rolling: &Rolling<'_>, load: f64) -> Result<CarriedLoad, Error> {
        WheelOnSoil::NORMAL_LOAD.check(load).map_err(Error::Invalid)?;
        self.solve_sinkage_near(rolling, load, None)
    }

    /// The same of a load that is greater than 0, with a sinkage (m) that is likely to be near.
    pub(crate) fn solve_sinkage_near(&self, rolling: &Rolling<'_>, load: f64, near: Option<f64>) -> Result<CarriedLoad, Error> {
        let curve = &self.guide(rolling)?;
        let guess = near.unwrap_or_else(|| bekker_estimate(&rolling.system.wheel, curve, load));
        match self.approach(rolling, load, guess, near.is_some()) {
            Some(found) => Ok(found),
            None => self.solve_sinkage_in_bracket(rolling, load, curve),
        }
    }

    /// The same by a bracket and Brent's method.
    pub(crate) fn solve_sinkage_in_bracket(
        &self,
        rolling: &Rolling<'_>,
        load: f64,
        curve: &PressureCurve,
    ) -> Result<CarriedLoad, Error> {
        let power = 1.0 / (curve.exponent + 0.5);
        let (least, most) = rolling.sinkages();
        let level = load.powf(power);
        let mut balance = Balance { model: self, rolling, curve, load, power, level, least, most, iterations: 0, latest: None };
        let (below, above) = balance.bracket()?;
        let found = bracketed_root(|beyond| balance.imbalance(beyond), below, above, TOLERANCE)?;
        let sinkage = balance.sinkage(found.best.x);
        let forces = match balance.latest {
            Some((z, forces)) if z == sinkage => forces,
            _ => balance.forces(found.best.x)?,
        };
        let (residual, iterations) = (forces.normal - load, balance.iterations);
        let carried = CarriedLoad { sinkage, residual, iterations, forces };
        if found.converged && carried.is_met(load) {
            Ok(carried)
        } else {
            Err(Error::LoadNotBalanced { load, iterations, residual, sinkage })
        }
    }
}

impl CarriedLoad {
    /// Whether the normal force meets `load` (N).
    pub(crate) fn is_met(&self, load: f64) -> bool {
        is_met(self.residual, self.forces.normal_scale(), load)
    }
}

/// Whether a normal force of that `scale` (N), which is beside the `load` (N) by a `residual` (N), meets it.
#[inline]
pub(crate) fn is_met(residual: f64, scale: f64, load: f64) -> bool {
    residual.abs() <= (LARGEST_RESIDUAL * scale.max(load)).min(LARGEST_MISS * load)
}

/// Bekker's sinkage of a rigid wheel, z = (3 W / ((3 − N) b K_s √(2r)))^(2/(2N+1)) (Bekker 1956): a first guess.
pub(crate) fn bekker_estimate(wheel: &Wheel, curve: &PressureCurve, load: f64) -> f64 {
    let share = (3.0 - curve.exponent).max(0.5) / 3.0;
    let scale = share * wheel.width() * curve.modulus * (2.0 * wheel.radius()).sqrt();
    let estimate = (load / scale).powf(1.0 / (curve.exponent + 0.5));
    if estimate.is_finite() { estimate.max(f64::MIN_POSITIVE) } else { wheel.radius() }
}

impl ForceModel {
    /// Pressure over depth that tells the search about how deep to look: the soil's, or that of a flat plate in grains.
    fn guide(&self, rolling: &Rolling<'_>) -> Result<PressureCurve, Error> {
        match self.method {
            Method::ResistiveForce => Ok(PressureCurve { modulus: equivalent_modulus(rolling.system)?, exponent: 1.0 }),
            Method::Quadrature | Method::SideSlipping(_) | Method::Linearised { .. } | Method::Explicit { .. } => {
                rolling.curve().copied()
            }
        }
    }

    /// The forces at a sinkage (m), without the angles of the contact where the method does not need them.
    fn forces_at(&self, rolling: &Rolling<'_>, sinkage: f64) -> Result<Forces, Error> {
        match self.method {
            Method::ResistiveForce => resistive::forces_in_grains(rolling, sinkage),
            Method::Quadrature | Method::SideSlipping(_) | Method::Linearised { .. } | Method::Explicit { .. } => {
                self.forces(&rolling.contact(sinkage)?)
            }
        }
    }
}

struct Balance<'a> {
    model: &'a ForceModel,
    rolling: &'a Rolling<'a>,
    curve: &'a PressureCurve,
    load: f64,
    /// 1/(N + 1/2).
    power: f64,
    /// The load to that power.
    level: f64,
    /// Sinkages (m) between which there is a contact; the search counts from the smaller.
    least: f64,
    most: f64,
    iterations: u32,
    /// The latest sinkage and its forces: mostly those of the solution.
    latest: Option<(f64, Forces)>,
}

impl Balance<'_> {
    /// The sinkage (m) at this distance from the least one, kept in range against rounding.
    fn sinkage(&self, beyond: f64) -> f64 {
        (self.least + beyond).min(self.most)
    }

    fn forces(&mut self, beyond: f64) -> Result<Forces, Error> {
        self.iterations += 1;
        let sinkage = self.sinkage(beyond);
        let forces = self.model.forces_at(self.rolling, sinkage)?;
        self.latest = Some((sinkage, forces));
        Ok(forces)
    }

    /// Normal force minus load, both on the scale on which the force is about proportional to the sinkage. It is 0 where they
    /// differ by no more than rounding, unless that exceeds the allowed error.
    fn imbalance(&mut self, beyond: f64) -> Result<f64, Error> {
        let forces = self.forces(beyond)?;
        if (forces.normal - self.load).abs() <= (TOLERANCE * forces.normal_scale()).min(LARGEST_MISS * self.load) {
            return Ok(0.0);
        }
        Ok(forces.normal.abs().powf(self.power).copysign(forces.normal) - self.level)
    }

    fn sample(&mut self, beyond: f64) -> Result<Sample, Error> {
        Ok(Sample { x: beyond, y: self.imbalance(beyond)? })
    }

    /// Two sinkages between which F_z rises through the load.
    fn bracket(&mut self) -> Result<(Sample, Sample), Error> {
        let span = self.most - self.least;
        let nearest = NEAREST * self.least;
        let estimate = bekker_estimate(&self.rolling.system.wheel, self.curve, self.load);
        let mut here = self.sample(estimate.max(nearest).min(span))?;
        let mut stride = FIRST_STRIDE;
        for _ in 0..BRACKET_STEPS {
            let shortest = (1.0 + stride).min(LONGEST_STRIDE);
            stride *= 2.0;
            // The balance by a straight line through the origin, and a little beyond.
            let ratio = self.level / (here.y + self.level);
            let next = if here.y < 0.0 {
                if here.x >= span {
                    return self.carried_before_the_axle();
                }
                let factor = if ratio.is_finite() && ratio > 1.0 { 1.0 + (ratio - 1.0) * 1.2 } else { 2.0 };
                self.sample((here.x * factor.clamp(shortest, LONGEST_STRIDE)).min(span))?
            } else {
                if here.x <= nearest {
                    let (least, sinkage) = (self.forces(here.x)?.normal, self.sinkage(here.x));
                    return Err(Error::LoadTooLight { load: self.load, least, sinkage });
                }
                let factor = if ratio.is_finite() && ratio > 0.0 { 1.0 - (1.0 - ratio) * 1.2 } else { 0.5 };
                self.sample((here.x * factor.clamp(1.0 / LONGEST_STRIDE, 1.0 / shortest)).max(nearest))?
            };
            match (here.y < 0.0, next.y < 0.0) {
                (true, false) => return Ok((here, next)),
                (false, true) => return Ok((next, here)),
                _ => here = next,
            }
        }
        let residual = self.forces(here.x)?.normal - self.load;
        Err(Error::LoadNotBalanced { load: self.load, iterations: self.iterations, residual, sinkage: self.sinkage(here.x) })
    }

    /// F_z(r) is below the load, but under a braking wheel F_z need not grow throughout and may reach the load at a smaller
    /// sinkage: that bracket, or the largest load.
    fn carried_before_the_axle(&mut self) -> Result<(Sample, Sample), Error> {
        let span = self.most - self.least;
        let stride = span / f64::from(CAPACITY_SAMPLES);
        let mut before = Sample { x: 0.0, y: -self.level };
        let mut largest = Sample { x: span, y: f64::NEG_INFINITY };
        for i in 1..=CAPACITY_SAMPLES {
            let here = self.sample((stride * f64::from(i)).min(span))?;
            if here.y >= 0.0 {
                return Ok((before, here));
            }
            if here.y > largest.y {
                largest = here;
            }
            before = here;
        }
        largest = self.summit(largest, stride, span)?;
        if largest.y >= 0.0 {
            // On the way up to the summit F_z rises through the load.
            let below = (largest.x - stride).max(0.0);
            let below = if below > 0.0 { self.sample(below)? } else { Sample { x: 0.0, y: -self.level } };
            if below.y < 0.0 {
                return Ok((below, largest));
            }
        }
        let deepest = largest.x;
        let largest = self.forces(deepest)?.normal;
        Err(Error::LoadBeyondCapacity { load: self.load, largest, sinkage: self.sinkage(deepest) })
    }

    /// The largest normal force within a stride of the largest sample, by golden section. The search ends early where the load is
    /// reached.
    fn summit(&mut self, highest: Sample, stride: f64, span: f64) -> Result<Sample, Error> {
        const GOLDEN: f64 = 0.618_033_988_749_894_8;
        if highest.x >= span && self.sample(span * (1.0 - 1e-6))?.y < highest.y {
            return Ok(highest); // it still grows at the end
        }
        let (mut left, mut right) = ((highest.x - stride).max(0.0), (highest.x + stride).min(span));
        let mut inner_left = self.sample(right - GOLDEN * (right - left))?;
        let mut inner_right = self.sample(left + GOLDEN * (right - left))?;
        let mut highest = highest;
        for _ in 0..SUMMIT_STEPS {
            let higher = if inner_left.y > inner_right.y { inner_left } else { inner_right };
            if higher.y > highest.y {
                highest = higher;
            }
            if highest.y >= 0.0 {
                break;
            }
            if inner_left.y > inner_right.y {
                (right, inner_right) = (inner_right.x, inner_left);
                inner_left = self.sample(right - GOLDEN * (right - left))?;
            } else {
                (left, inner_left) = (inner_left.x, inner_right);
                inner_right = self.sample(left + GOLDEN * (right - left))?;
            }
        }
        Ok(highest)
    }
}
