//! The answer of `/v1/towed`.

use std::borrow::Cow;

use serde::Serialize;
use terramechanics::{Error, Outcome, WheelOnSoil, cautions};
use utoipa::ToSchema;

use super::warning::system_warnings;
use super::{AnglesReply, Reply, Warning};
use crate::request::TowedCase;

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
    /// The numbers once more, as the one row of a table.
    #[serde(skip)]
    row: [f64; COLUMNS.len()],
}

const COLUMNS: [&str; 6] = ["slip", "sinkage_m", "towing_resistance_n", "entry_rad", "maximum_stress_rad", "exit_rad"];

impl TryFrom<&TowedCase> for TowedReply {
    type Error = Error;

    fn try_from(query: &TowedCase) -> Result<Self, Error> {
        let TowedCase { operation, load } = query;
        let towed = operation.system.solve_towed(*load)?;
        let (slip, angles) = (towed.slip.ratio(), towed.angles);
        let outcome = Outcome {
            slip: towed.slip,
            sinkage: towed.sinkage,
            normal: Some(towed.forces.normal),
            integration_error: towed.forces.integration_error,
            mobilised_share: None,
        };
        let WheelOnSoil { wheel, soil, .. } = &operation.system;
        Ok(Self {
            slip,
            sinkage_m: towed.sinkage,
            towing_resistance_n: towed.resistance(),
            angles: angles.into(),
            warnings: cautions(operation, &outcome).map(Warning::from).chain(system_warnings(wheel, soil.params())).collect(),
            row: [slip, towed.sinkage, towed.resistance(), angles.entry, angles.peak, angles.exit],
        })
    }
}

impl Reply for TowedReply {
    fn columns(&self) -> Vec<(Cow<'static, str>, &[f64])> {
        COLUMNS.map(Cow::from).into_iter().zip(self.row.chunks(1)).collect()
    }

    fn warnings(&self) -> &[Warning] {
        &self.warnings
    }
}
