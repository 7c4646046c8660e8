//! The answer of `/v1/coupled`.

use std::borrow::Cow;

use serde::Serialize;
use terramechanics::{Error, Heading};
use utoipa::ToSchema;

use super::warning::system_warnings;
use super::{AnglesReply, Reply, Warning};
use crate::request::CoupledCase;

/// Torque and longitudinal force that follow from what was measured.
#[derive(Debug, Serialize, ToSchema)]
#[schema(as = CoupledForces)]
pub(crate) struct CoupledReply {
    /// Slip ratio s (–).
    slip: f64,
    /// Sinkage z (m).
    sinkage_m: f64,
    angles: AnglesReply,
    /// Longitudinal force F_x, the drawbar pull (N).
    longitudinal_force_n: f64,
    /// Torque T about the axle (N·m): the one that was sent, else what follows from the load.
    torque_n_m: f64,
    warnings: Vec<Warning>,
    /// The numbers once more, as the one row of a table.
    #[serde(skip)]
    row: [f64; COLUMNS.len()],
}

const COLUMNS: [&str; 4] = ["slip", "sinkage_m", "longitudinal_force_n", "torque_n_m"];

impl TryFrom<&CoupledCase> for CoupledReply {
    type Error = Error;

    fn try_from(query: &CoupledCase) -> Result<Self, Error> {
        let CoupledCase { system, motion, sinkage, known } = query;
        let rolling = system.rolling(motion.slip)?;
        let patch = rolling.contact(*sinkage)?;
        let forces = known.forces(&patch)?.heading(motion.heading);
        let slip = motion.slip.ratio();
        let mut warnings: Vec<Warning> = forces.cautions(system, motion.slip, *sinkage).map(Warning::from).collect();
        warnings.extend(system_warnings(&system.wheel, system.soil.params()));
        if motion.heading == Heading::Backward {
            warnings.push(Warning::mirrored());
        }
        Ok(Self {
            slip,
            sinkage_m: *sinkage,
            angles: patch.angles.into(),
            longitudinal_force_n: forces.longitudinal,
            torque_n_m: forces.torque,
            warnings,
            row: [slip, *sinkage, forces.longitudinal, forces.torque],
        })
    }
}

impl Reply for CoupledReply {
    fn columns(&self) -> Vec<(Cow<'static, str>, &[f64])> {
        COLUMNS.map(Cow::from).into_iter().zip(self.row.chunks(1)).collect()
    }

    fn warnings(&self) -> &[Warning] {
        &self.warnings
    }
}
