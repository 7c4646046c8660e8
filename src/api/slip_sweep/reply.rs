//! The answer of `/v1/slip-sweep`.

use serde::Serialize;
use terramechanics::Method;
use utoipa::ToSchema;

use super::found::FoundSweep;
use crate::quantity::PointColumns;
use crate::reply::in_columns;
use crate::reply::method_name;
use crate::request::circles::{Counted, words};
use crate::warning::Warning;

/// Forces over slip.
#[derive(Debug, Serialize, ToSchema)]
#[schema(as = SlipSweep)]
pub(crate) struct SweepReply {
    /// The method by which the forces were found.
    method: &'static str,
    /// Circle on which the shear displacement was counted: shearing or rim; null where the method counts none.
    #[schema(required = true, example = "shearing")]
    shear_displacement_radius: Option<&'static str>,
    /// Circle on which the slip was counted: rim, shearing or lug_tip.
    #[schema(example = "rim")]
    slip_radius: &'static str,
    /// What the normal stress follows from: the pressure–sinkage law of the soil, or the load, which was known beside the sinkage.
    #[schema(example = "soil")]
    normal_stress_from: &'static str,
    columns: PointColumns,
    warnings: Vec<Warning>,
}

impl From<FoundSweep> for SweepReply {
    fn from(FoundSweep { operation, sweep, warnings }: FoundSweep) -> Self {
        let method = &operation.model.method;
        let is_sideways = matches!(method, Method::SideSlipping(_));
        let columns = PointColumns::of(&sweep, &operation, is_sideways);
        let (shear_displacement_radius, slip_radius) = words(Counted::by(method, operation.system.contact.circles()));
        Self {
            method: method_name(method),
            shear_displacement_radius,
            slip_radius,
            normal_stress_from: operation.sinkage.normal_stress_from().name(),
            columns,
            warnings,
        }
    }
}

in_columns!(SweepReply);
