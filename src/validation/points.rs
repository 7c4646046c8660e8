//! The measurements of a set, point by point.

use serde::Deserialize;

/// Measurements by slip as published; a quantity that was not measured is left out.
#[derive(Debug, Default, Deserialize)]
#[serde(deny_unknown_fields)]
pub(crate) struct Points {
    normal_load_n: Load,
    pub(crate) slip: Vec<f64>,
    pub(super) longitudinal_force_n: Option<Vec<Option<f64>>>,
    pub(super) sinkage_m: Option<Vec<Option<f64>>>,
    pub(super) torque_n_m: Option<Vec<Option<f64>>>,
    pub(super) lateral_force_n: Option<Vec<Option<f64>>>,
}

#[derive(Debug, Deserialize)]
#[serde(untagged)]
enum Load {
    /// The same at every point (N).
    Constant(f64),
    /// Measured at each point (N).
    Measured(Vec<f64>),
}

impl Default for Load {
    fn default() -> Self {
        Self::Measured(Vec::new())
    }
}

impl Points {
    /// Sinkage (m) at a point, where it was measured.
    pub(super) fn sinkage_at(&self, row: usize) -> Option<f64> {
        self.sinkage_m.as_ref()?.get(row).copied().flatten()
    }

    /// Load W at each point (N).
    pub(crate) fn load(&self) -> Vec<f64> {
        match &self.normal_load_n {
            Load::Constant(load) => vec![*load; self.slip.len()],
            Load::Measured(loads) => loads.clone(),
        }
    }
}
