//! The answer of `/v1/coupled`.

use std::borrow::Cow;

use serde::Serialize;
use terramechanics::Slip;
use utoipa::ToSchema;

use super::found::FoundCoupled;
use crate::reply::{AnglesReply, Reply, one_row, or_null};
use crate::request::circles::words;
use crate::warning::Warning;

/// Torque and longitudinal force that follow from what was measured.
#[derive(Debug, Serialize, ToSchema)]
#[schema(as = CoupledForces)]
pub(crate) struct CoupledReply {
    /// Slip ratio s (–); null where none was sent beside the torque.
    #[serde(serialize_with = "or_null")]
    #[schema(value_type = Option<f64>)]
    slip: f64,
    /// Sinkage z (m).
    sinkage_m: f64,
    /// Circle on which the shear displacement was counted: shearing or rim.
    #[schema(required = true, example = "shearing")]
    shear_displacement_radius: Option<&'static str>,
    /// Circle on which the slip was counted: rim, shearing or lug_tip.
    #[schema(example = "rim")]
    slip_radius: &'static str,
    angles: AnglesReply,
    /// Longitudinal force F_x, the drawbar pull (N).
    longitudinal_force_n: f64,
    /// Torque T about the axle (N·m): the one that was sent, else what follows from the load.
    torque_n_m: f64,
    warnings: Vec<Warning>,
}

impl From<FoundCoupled> for CoupledReply {
    fn from(FoundCoupled { slip, sinkage, circles, angles, forces, warnings }: FoundCoupled) -> Self {
        let (shear_displacement_radius, slip_radius) = words(circles);
        Self {
            slip: slip.map_or(f64::NAN, Slip::ratio),
            sinkage_m: sinkage,
            shear_displacement_radius,
            slip_radius,
            angles: angles.into(),
            longitudinal_force_n: forces.longitudinal,
            torque_n_m: forces.torque,
            warnings,
        }
    }
}

impl Reply for CoupledReply {
    fn columns(&self) -> Vec<(Cow<'static, str>, &[f64])> {
        one_row!(self; slip, sinkage_m, longitudinal_force_n, torque_n_m)
    }

    fn warnings(&self) -> &[Warning] {
        &self.warnings
    }

    fn warn(&mut self, warning: Warning) {
        self.warnings.push(warning);
    }
}
