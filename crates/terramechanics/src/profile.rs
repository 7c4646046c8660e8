//! How are the stresses spread along the rim? Exact and linearised (letter, Eqs. 1, 3–7 and Fig. 1b).

use crate::contact::Angles;
use crate::forces::{PeakDepth, peak_stresses};
use crate::stress::{StressField, Stresses};

/// Stresses at places from the exit to the entry, as columns of one length.
#[derive(Debug, Clone, Default, PartialEq)]
pub struct StressProfile {
    /// θ (rad), ascending from θ2 to θ1; θm is one of them.
    pub theta: Vec<f64>,
    /// Depth that presses there (m).
    pub depth: Vec<f64>,
    /// σ (Pa).
    pub normal: Vec<f64>,
    /// τ (Pa).
    pub shear: Vec<f64>,
    /// Linearised σ (Pa); NaN where a braking wheel has two zones, at whose peak no shear stress acts. Eqs. (7a), (7b).
    pub normal_linear: Vec<f64>,
    /// Linearised τ (Pa); NaN as above. Eqs. (7c), (7d).
    pub shear_linear: Vec<f64>,
}

impl StressProfile {
    /// Fewest places: the exit, the peak and the entry.
    pub const FEWEST_POINTS: usize = 3;

    /// The profile at `points` places (at least [`StressProfile::FEWEST_POINTS`]), equally spaced on each side of the peak
    /// and nearly so over the whole; the linear stresses have the depth `peak_depth` under their peak.
    #[must_use]
    pub fn of(stresses: &StressField<'_>, points: usize, peak_depth: PeakDepth) -> Self {
        let patch = stresses.patch;
        let Angles { entry, peak, exit } = patch.angles;
        let linear_peak = if patch.has_two_zones() {
            Stresses { normal: f64::NAN, shear: f64::NAN }
        } else {
            peak_stresses(stresses, peak_depth)
        };
        let steps = points.max(Self::FEWEST_POINTS) - 1;
        let rear_steps = ((steps as f64 * (peak - exit) / (entry - exit)).round() as usize).clamp(1, steps - 1);
        let column = || Vec::with_capacity(steps + 1);
        let mut profile = Self {
            theta: column(),
            depth: column(),
            normal: column(),
            shear: column(),
            normal_linear: column(),
            shear_linear: column(),
        };
        for step in 0..=steps {
            // The share of the way from the free end to the peak: 0 at exit and entry, 1 at the peak, each exactly.
            let (theta, share) = if step <= rear_steps {
                let share = step as f64 / rear_steps as f64;
                (if step == rear_steps { peak } else { exit + share * (peak - exit) }, share)
            } else {
                let share = (steps - step) as f64 / (steps - rear_steps) as f64;
                (entry - share * (entry - peak), share)
            };
            let depth = patch.depth(theta);
            let here = stresses.under(&patch.rim_point(entry - theta), depth);
            profile.theta.push(theta);
            profile.depth.push(depth);
            profile.normal.push(here.normal);
            profile.shear.push(here.shear);
            profile.normal_linear.push(share * linear_peak.normal); // Eqs. (7a), (7b)
            profile.shear_linear.push(share * linear_peak.shear); // Eqs. (7c), (7d)
        }
        profile
    }

    /// Number of places.
    #[must_use]
    pub fn len(&self) -> usize {
        self.theta.len()
    }

    /// Whether there are none.
    #[must_use]
    pub fn is_empty(&self) -> bool {
        self.theta.is_empty()
    }
}
