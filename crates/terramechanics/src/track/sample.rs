//! A sample of the telemetry, and the row that is computed for it.

use crate::motion::Velocities;
use crate::operating_point::Sinkage;

/// How the motion of a sample is known.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum SampleMotion {
    /// By the slip ratio (–); there is no power then.
    Slip(f64),
    /// By both velocities.
    Velocities(Velocities),
}

/// What was measured at one time. NaN stands for a missing value.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Sample {
    /// Time (s).
    pub time: f64,
    /// The motion.
    pub motion: SampleMotion,
    /// The sinkage: as measured, or how it is found.
    pub sinkage: Sinkage,
    /// Torque (N·m) and normal load (N), where both are measured: then Ding's coupled form gives the pull as well.
    pub measured: Option<Measured>,
    /// Whether a missing value was sent, but could not be read.
    pub unreadable: bool,
}

/// A value of a sample.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Channel {
    /// Time.
    Time,
    /// Slip.
    Slip,
    /// Forward velocity of the axle.
    ForwardVelocity,
    /// Angular velocity of the wheel.
    AngularVelocity,
    /// Sinkage.
    Sinkage,
    /// Torque.
    Torque,
    /// Normal load.
    NormalLoad,
}

/// Torque and load of a sample.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Measured {
    /// Torque T (N·m), positive when it turns the wheel forward.
    pub torque: f64,
    /// Normal load W (N).
    pub normal_load: f64,
}

/// Whether a sample has a result, and if not, why.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Status {
    /// It has a result.
    Ok,
    /// It has a result, and the wheel is at rest.
    Static,
    /// A value is missing.
    MissingValue,
    /// A value was sent, but could not be read.
    Unreadable,
    /// A value is infinite, a load or sinkage is not positive, or a measured sinkage is beyond the radius.
    OutOfRange,
    /// The slip is not from −1 to 1.
    SlipOutOfRange,
    /// The wheel moves against its own rotation.
    OppositeRotation,
    /// The time is before that of the sample before.
    TimeBackwards,
    /// The model has no answer there.
    NoSolution,
}

impl Status {
    /// Every status.
    pub const ALL: [Self; 9] = [
        Self::Ok,
        Self::Static,
        Self::MissingValue,
        Self::Unreadable,
        Self::OutOfRange,
        Self::SlipOutOfRange,
        Self::OppositeRotation,
        Self::TimeBackwards,
        Self::NoSolution,
    ];

    /// A name for programs.
    #[must_use]
    pub fn code(self) -> &'static str {
        match self {
            Self::Ok => "ok",
            Self::Static => "static",
            Self::MissingValue => "missing_value",
            Self::Unreadable => "unreadable",
            Self::OutOfRange => "out_of_range",
            Self::SlipOutOfRange => "slip_out_of_range",
            Self::OppositeRotation => "opposite_rotation",
            Self::TimeBackwards => "time_backwards",
            Self::NoSolution => "no_solution",
        }
    }

    /// Whether the sample has a result.
    #[must_use]
    pub fn is_good(self) -> bool {
        matches!(self, Self::Ok | Self::Static)
    }
}

/// The row of a sample; NaN where there is no value.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct TrackRow {
    /// Time (s).
    pub time: f64,
    /// Slip s (–); it is given even where the forces have no solution.
    pub slip: f64,
    /// Sinkage z (m).
    pub sinkage: f64,
    /// Longitudinal force F_x (N).
    pub longitudinal: f64,
    /// Normal force F_z (N).
    pub normal: f64,
    /// Torque T (N·m).
    pub torque: f64,
    /// Drawbar coefficient F_x/F_z (–).
    pub drawbar_coefficient: f64,
    /// Tractive efficiency (–).
    pub tractive_efficiency: f64,
    /// Mechanical power T ω (W).
    pub power: f64,
    /// Energy since the first sample (J).
    pub energy: f64,
    /// Longitudinal force (N) by Ding's coupled form from the measured torque and load.
    pub longitudinal_coupled: f64,
    /// Sinkage modulus K_s (Pa/mᴺ): the soil's, or the one that a known load shows.
    pub sinkage_modulus: f64,
    /// Granular stiffness ξ (N/m³) by the resistive force method: the soil's, or the one that a known load shows.
    pub granular_stiffness: f64,
    /// Whether there is a result.
    pub status: Status,
}

impl TrackRow {
    /// The row of a sample without a result.
    pub(super) fn bad(time: f64, slip: f64, status: Status) -> Self {
        let none = f64::NAN;
        Self {
            time,
            slip,
            sinkage: none,
            longitudinal: none,
            normal: none,
            torque: none,
            drawbar_coefficient: none,
            tractive_efficiency: none,
            power: none,
            energy: none,
            longitudinal_coupled: none,
            sinkage_modulus: none,
            granular_stiffness: none,
            status,
        }
    }
}
