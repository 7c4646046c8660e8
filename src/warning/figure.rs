//! Figures of a finding beside the one that it is about.

use serde::Serialize;
use utoipa::ToSchema;

use crate::quantity::unit_of_name;

/// A further figure of a finding.
#[derive(Debug, Clone, PartialEq, Serialize, ToSchema)]
#[schema(as = WarningFigure)]
pub(super) struct Figure {
    /// What it is.
    #[schema(example = "sinkage")]
    quantity: &'static str,
    /// Its value.
    pub(super) value: f64,
    /// Its unit by UCUM, 1 for a ratio, where it is known.
    #[serde(skip_serializing_if = "Option::is_none")]
    #[schema(nullable = false, example = "m")]
    unit: Option<&'static str>,
}

impl Figure {
    pub(super) fn of(quantity: &'static str, value: f64, unit: &'static str) -> Self {
        Self { quantity, value, unit: Some(unit) }
    }

    /// In the unit of a parameter.
    pub(super) fn of_parameter(quantity: &'static str, value: f64, parameter: &str) -> Self {
        Self { quantity, value, unit: unit_of_name(parameter) }
    }
}
