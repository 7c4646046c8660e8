//! The answer of `/v1/slip-sweep`.

use std::borrow::Cow;

use serde::Serialize;
use terramechanics::Method;
use utoipa::ToSchema;

use super::found::FoundSweep;
use crate::quantity::PointColumns;
use crate::reply::Reply;
use crate::reply::method_name;
use crate::warning::Warning;

/// Forces over slip.
#[derive(Debug, Serialize, ToSchema)]
#[schema(as = SlipSweep)]
pub(crate) struct SweepReply {
    /// The method by which the forces were found.
    method: &'static str,
    columns: PointColumns,
    warnings: Vec<Warning>,
}

impl From<FoundSweep> for SweepReply {
    fn from(FoundSweep { operation, sweep, warnings }: FoundSweep) -> Self {
        let method = &operation.model.method;
        let is_sideways = matches!(method, Method::SideSlipping(_));
        let columns = PointColumns::of(&sweep, &operation.system.wheel, is_sideways);
        Self { method: method_name(method), columns, warnings }
    }
}

impl Reply for SweepReply {
    fn columns(&self) -> Vec<(Cow<'static, str>, &[f64])> {
        self.columns.as_table()
    }

    fn warnings(&self) -> &[Warning] {
        &self.warnings
    }

    fn warn(&mut self, warning: Warning) {
        self.warnings.push(warning);
    }
}
