//! Where the inputs of a set come from.

use serde::{Deserialize, Serialize};
use utoipa::ToSchema;

/// How an input of a set is known.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Deserialize, Serialize, ToSchema)]
#[serde(rename_all = "lowercase")]
pub(crate) enum Origin {
    /// Of the wheel or the soil that was tested, by a test of its own.
    Measured,
    /// Of another soil or another batch.
    Borrowed,
    /// Of no test at all.
    Assumed,
    /// Chosen so that the predictions meet these very measurements.
    Fitted,
}

/// Inputs that come from one place.
#[derive(Debug, Deserialize)]
#[serde(deny_unknown_fields)]
pub(crate) struct InputsOfOrigin {
    /// The fields of a request, with a dot between an object and its field.
    pub(crate) names: Vec<String>,
    pub(crate) origin: Origin,
    pub(crate) source: String,
}
