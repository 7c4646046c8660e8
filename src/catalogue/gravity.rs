//! Gravity on the surface of the bodies where wheels roll.

use std::sync::LazyLock;

use serde::{Deserialize, Serialize};
use utoipa::ToSchema;

static GRAVITY: LazyLock<Vec<Gravity>> = LazyLock::new(|| super::compiled_in(include_str!("../../catalogue/gravity.json")));

/// Acceleration due to gravity on the surface of a body.
#[derive(Debug, Clone, Deserialize, Serialize, ToSchema)]
#[serde(deny_unknown_fields)]
pub(crate) struct Gravity {
    #[schema(example = "moon")]
    pub(crate) id: String,
    name: String,
    /// Acceleration due to gravity (m/s²).
    pub(crate) acceleration_m_s2: f64,
    /// Where it was published.
    pub(crate) source: String,
}

/// Gravity of all bodies.
pub(crate) fn gravity() -> &'static [Gravity] {
    &GRAVITY
}
