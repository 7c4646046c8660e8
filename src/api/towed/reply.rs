//! The answer of `/v1/towed`.

use std::borrow::Cow;

use serde::Serialize;
use utoipa::ToSchema;

use super::found::FoundTowed;
use crate::reply::{AnglesReply, Reply, one_row};
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
    angles: AnglesReply,
    warnings: Vec<Warning>,
}

impl From<FoundTowed> for TowedReply {
    fn from(FoundTowed { towed, warnings }: FoundTowed) -> Self {
        Self {
            slip: towed.slip.ratio(),
            sinkage_m: towed.sinkage,
            towing_resistance_n: towed.resistance(),
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
