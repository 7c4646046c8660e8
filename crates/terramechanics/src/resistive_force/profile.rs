//! How are the stresses spread along the rim by a method? The profile that belongs to its forces.

use super::LeadingEdge;
use crate::contact::Angles;
use crate::error::Error;
use crate::forces::{ForceModel, Method, PeakDepth};
use crate::patch::ContactPatch;
use crate::profile::StressProfile;

impl ForceModel {
    /// The stresses along the contact by this method at `points` places (at least [`StressProfile::FEWEST_POINTS`]); the linear
    /// stresses have the depth `peak_depth` under their peak.
    ///
    /// By the resistive force method the places are those of [`StressProfile::of`], or equally spaced where θm is the exit. It has no
    /// linear stresses: their columns are NaN.
    ///
    /// # Errors
    /// [`Error::MissingLaw`] for what the method needs of the soil.
    pub fn profile(&self, patch: &ContactPatch<'_>, points: usize, peak_depth: PeakDepth) -> Result<StressProfile, Error> {
        match self.method {
            Method::ResistiveForce => Ok(in_grains(&LeadingEdge::of(patch.rolling, patch.sinkage)?, &patch.angles, points)),
            Method::Quadrature | Method::SideSlipping(_) | Method::Linearised { .. } | Method::Explicit { .. } => {
                Ok(StressProfile::of(&patch.stresses()?, points, peak_depth))
            }
        }
    }
}

fn in_grains(edge: &LeadingEdge, angles: &Angles, points: usize) -> StressProfile {
    let places = places(angles, points.max(StressProfile::FEWEST_POINTS) - 1);
    let mut profile = StressProfile::default();
    for &(theta, chord) in &places {
        let place = edge.at(chord.min(edge.reach));
        profile.theta.push(theta);
        profile.depth.push(place.depth);
        let stresses = edge.stresses(&place);
        profile.normal.push(stresses.normal);
        profile.shear.push(stresses.shear);
    }
    profile.normal_linear = vec![f64::NAN; places.len()];
    profile.shear_linear = vec![f64::NAN; places.len()];
    profile
}

/// θ (rad), ascending from 0 to θ1 with θm among them, each with its chord (–).
fn places(angles: &Angles, steps: usize) -> Vec<(f64, f64)> {
    let Angles { entry, peak, .. } = *angles;
    let rear_steps = if peak > 0.0 { ((steps as f64 * peak / entry).round() as usize).clamp(1, steps - 1) } else { 0 };
    let theta = |step: usize| {
        if rear_steps > 0 && step <= rear_steps {
            peak * (step as f64 / rear_steps as f64)
        } else {
            entry - (entry - peak) * ((steps - step) as f64 / (steps - rear_steps) as f64)
        }
    };
    let chord = |theta: f64| 2.0 * (0.5 * theta).sin();
    (0..=steps).map(theta).map(|theta| (theta, chord(theta))).collect()
}
