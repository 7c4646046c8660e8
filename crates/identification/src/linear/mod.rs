//! How strong is the soil under a rolling wheel, right now? Cohesion and friction from torque, load, slip and sinkage by
//! linear least squares (Iagnemma, Kang, Shibly & Dubowsky 2004, Online terrain parameter estimation for wheeled mobile
//! robots with application to planetary rovers, IEEE Transactions on Robotics 20, 921).
//!
//! With the stresses linear on both sides of their peak, the torque gives the shear stress there, τm = T/(r_s² b H), and the
//! load the normal stress, σm = (W − r_s b B τm)/(r b A); then τm/E = c + σm tan φ is a straight line with one point per
//! sample. The pressure–sinkage law is eliminated; the shear law enters E and has to be known.
//!
//! | what | here |
//! |---|---|
//! | a sample's point on the line | [`StressPoint::of`], the inverse of Ding's coupled form [`Coupled`] |
//! | the line, with older samples forgotten | [`RunningStrength`] |
//! | the line with an account of what the samples do not tell | [`fit_line`] |
//!
//! The paper's κ1 tan φ − κ3 c = −κ2 for a smooth wheel with the peak at the middle of the contact is the same line:
//! κ2/κ3 = τm/E and −κ1/κ3 = σm, derived by putting the closed forms of A, B and H into the two stresses, and tested.
//!
//! Departures: shear acts at r_s, so lugs count as they do in the model; the rule of the contact places the peak and the exit.
//!
//! Validity: the covariance does not cover two biases. The stresses of a wheel are not linear, which shifts both estimates
//! however many samples there are (see [`LinearFit::model_bias`]). And σm contains the torque, so noise in the torque biases
//! the slope towards zero.

mod fit;
mod running;

use terramechanics::{Coupled, Error, NormalStressRadius, Slip, WheelOnSoil};

pub use fit::{LinearFit, fit_line, fit_line_while};
pub use running::{RunningStrength, StrengthBound, StrengthEstimate, StrengthTally, linear_strength};

/// Least |E| of a sample that is used: below it the torque says little about the strength.
pub const LEAST_MOBILISATION: f64 = 0.05;

/// One sample of a rolling wheel.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct RollingSample {
    /// Slip s (–).
    pub slip: Slip,
    /// Measured sinkage z (m). A modelled one would presuppose the soil that is sought.
    pub sinkage: f64,
    /// Vertical load W (N), greater than 0.
    pub load: f64,
    /// Torque T (N·m) of the wheel moving forward.
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
    /// The point of a sample; none where the wheel mobilises too little of the strength. That includes a braking wheel with two
    /// zones, whose shear stress is zero at the peak. Cohesion, friction and pressure–sinkage law of the soil have no
    /// influence.
    ///
    /// # Errors
    /// Those of [`WheelOnSoil::rolling`], of the contact at the sinkage, and of [`Coupled::forces`] with a torque.
    pub fn of(system: &WheelOnSoil, radius: NormalStressRadius, sample: &RollingSample) -> Result<Option<Self>, Error> {
        let RollingSample { slip, sinkage, load, torque } = *sample;
        let rolling = system.rolling(slip)?;
        let patch = rolling.contact(sinkage)?;
        let known = Coupled { normal_load: load, torque: Some(torque), normal_stress_radius: radius };
        let forces = known.forces(&patch)?;
        let mobilisation = patch.peak_mobilisation();
        let point = Self { normal: forces.peak_normal_stress, strength: forces.peak_shear_stress / mobilisation, mobilisation };
        Ok((mobilisation.abs() >= LEAST_MOBILISATION).then_some(point))
    }
}
