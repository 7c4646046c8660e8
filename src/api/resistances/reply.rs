//! The answer of `/v1/resistances`.

use std::borrow::Cow;

use serde::Serialize;
use terramechanics::{Lacking, Resistances};
use utoipa::ToSchema;

use super::found::FoundResistances;
use crate::reply::{Reply, one_row, or_null};
use crate::warning::Warning;

/// Bekker's estimates for one wheel; null, with a warning, where the request lacks what an estimate needs.
#[derive(Debug, Serialize, ToSchema)]
#[schema(as = Resistances)]
pub(crate) struct ResistancesReply {
    /// Sinkage z of a rigid wheel without slip (m).
    #[serde(serialize_with = "or_null")]
    #[schema(value_type = Option<f64>)]
    rigid_wheel_sinkage_m: f64,
    /// Resistance R_c by compaction of the soil under the wheel (N).
    #[serde(serialize_with = "or_null")]
    #[schema(value_type = Option<f64>)]
    compaction_resistance_n: f64,
    /// Resistance R_b by the soil that a leading wheel pushes ahead (N); a wheel in the rut of another has none.
    #[serde(serialize_with = "or_null")]
    #[schema(value_type = Option<f64>)]
    bulldozing_resistance_n: f64,
    /// Thrust H, the forward force of the soil's shear before any resistance (N); lugs are taken as continuous along the contact.
    #[serde(serialize_with = "or_null")]
    #[schema(value_type = Option<f64>)]
    thrust_n: f64,
    warnings: Vec<Warning>,
}

impl From<FoundResistances> for ResistancesReply {
    fn from(FoundResistances { estimates, warnings }: FoundResistances) -> Self {
        let Resistances { rigid_wheel_sinkage, compaction, bulldozing, thrust } = estimates;
        let or_none = |estimate: Result<f64, Lacking>| estimate.unwrap_or(f64::NAN);
        Self {
            rigid_wheel_sinkage_m: or_none(rigid_wheel_sinkage),
            compaction_resistance_n: or_none(compaction),
            bulldozing_resistance_n: or_none(bulldozing),
            thrust_n: or_none(thrust),
            warnings,
        }
    }
}

impl Reply for ResistancesReply {
    fn columns(&self) -> Vec<(Cow<'static, str>, &[f64])> {
        one_row!(self; rigid_wheel_sinkage_m, compaction_resistance_n, bulldozing_resistance_n, thrust_n)
    }

    fn warnings(&self) -> &[Warning] {
        &self.warnings
    }

    fn warn(&mut self, warning: Warning) {
        self.warnings.push(warning);
    }
}
