//! The answer of `/v1/towed`.

use std::borrow::Cow;

use serde::Serialize;
use utoipa::ToSchema;

use super::found::FoundTowed;
use crate::reply::{AnglesReply, Reply, one_row};
use crate::request::circles::words;
use crate::warning::Warning;

/// A wheel that is towed and rolls freely: without a torque, under its load.
#[derive(Debug, Serialize, ToSchema)]
#[schema(as = Towed)]
pub(crate) struct TowedReply {
    /// Slip ratio s (–), below 0: the skid.
    slip: f64,
    /// Sinkage z (m).
    sinkage_m: f64,
    /// Towing resistance −F_x (N).
    towing_resistance_n: f64,
    /// Circle on which the shear displacement was counted: shearing or rim; null where the method counts none.
    #[schema(required = true, example = "shearing")]
    shear_displacement_radius: Option<&'static str>,
    /// Circle on which the slip was counted: rim, shearing or lug_tip.
    #[schema(example = "rim")]
    slip_radius: &'static str,
    /// Granular stiffness ξ (N/m³); present by the method resistive_force.
    #[serde(skip_serializing_if = "Option::is_none")]
    #[schema(nullable = false)]
    granular_stiffness_n_m3: Option<f64>,
    angles: AnglesReply,
    warnings: Vec<Warning>,
}

impl From<FoundTowed> for TowedReply {
    fn from(FoundTowed { towed, granular_stiffness, circles, warnings }: FoundTowed) -> Self {
        let (shear_displacement_radius, slip_radius) = words(circles);
        Self {
            slip: towed.slip.ratio(),
            sinkage_m: towed.sinkage,
            towing_resistance_n: towed.resistance(),
            granular_stiffness_n_m3: granular_stiffness,
            shear_displacement_radius,
            slip_radius,
            angles: towed.angles.into(),
            warnings,
        }
    }
}

impl Reply for TowedReply {
    fn columns(&self) -> Vec<(Cow<'static, str>, &[f64])> {
        let mut columns = one_row!(self; slip, sinkage_m, towing_resistance_n);
        columns.extend(one_row!(self.angles; entry_rad, maximum_stress_rad, exit_rad));
        columns
    }

    fn warnings(&self) -> &[Warning] {
        &self.warnings
    }

    fn warn(&mut self, warning: Warning) {
        self.warnings.push(warning);
    }
}
