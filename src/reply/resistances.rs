//! The answer of `/v1/resistances`.

use std::borrow::Cow;

use serde::Serialize;
use terramechanics::{Error, Lacking, Resistances};
use utoipa::ToSchema;

use super::warning::system_warnings;
use super::{Reply, Warning};
use crate::request::ResistancesCase;

/// Bekker's estimates for one wheel; null, with a warning, where the request lacks what an estimate needs.
#[derive(Debug, Serialize, ToSchema)]
#[schema(as = Resistances)]
pub(crate) struct ResistancesReply {
    /// Sinkage z of a rigid wheel without slip (m).
    rigid_wheel_sinkage_m: Option<f64>,
    /// Resistance R_c by compaction of the soil under the wheel (N).
    compaction_resistance_n: Option<f64>,
    /// Resistance R_b by the soil that a leading wheel pushes ahead (N); a wheel in the rut of another has none.
    bulldozing_resistance_n: Option<f64>,
    /// Thrust H, the forward force of the soil's shear before any resistance (N); lugs are taken as continuous along the contact.
    thrust_n: Option<f64>,
    warnings: Vec<Warning>,
    /// The numbers once more, as the one row of a table.
    #[serde(skip)]
    row: [f64; COLUMNS.len()],
}

const COLUMNS: [&str; 4] = ["rigid_wheel_sinkage_m", "compaction_resistance_n", "bulldozing_resistance_n", "thrust_n"];

impl TryFrom<&ResistancesCase> for ResistancesReply {
    type Error = Error;

    fn try_from(query: &ResistancesCase) -> Result<Self, Error> {
        let ResistancesCase { system, normal_load, slip } = query;
        let found = Resistances::of(system, *normal_load, *slip)?;
        let all = [found.rigid_wheel_sinkage, found.compaction, found.bulldozing, found.thrust];
        let mut warnings: Vec<Warning> = found.cautions(system, *slip).map(Warning::from).collect();
        warnings.extend(system_warnings(&system.wheel, system.soil.params()));
        warnings
            .extend(COLUMNS.into_iter().zip(all).filter_map(|(name, estimate)| Some(Warning::of_null(name, &estimate.err()?))));
        let [rigid_wheel_sinkage_m, compaction_resistance_n, bulldozing_resistance_n, thrust_n] = all.map(Result::ok);
        Ok(Self {
            rigid_wheel_sinkage_m,
            compaction_resistance_n,
            bulldozing_resistance_n,
            thrust_n,
            warnings,
            row: all.map(|estimate| estimate.unwrap_or(f64::NAN)),
        })
    }
}

impl Warning {
    /// Why the field `name` is null.
    fn of_null(name: &str, lacking: &Lacking) -> Self {
        Self::new(lacking.code(), format!("`{name}` is null: {lacking}"))
    }
}

impl Reply for ResistancesReply {
    fn columns(&self) -> Vec<(Cow<'static, str>, &[f64])> {
        COLUMNS.map(Cow::from).into_iter().zip(self.row.chunks(1)).collect()
    }

    fn warnings(&self) -> &[Warning] {
        &self.warnings
    }
}
