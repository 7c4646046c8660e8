//! Sets of measurements as they are kept.

use serde::{Deserialize, Serialize};
use serde_json::Value;
use utoipa::ToSchema;

/// How well measurements are known.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Deserialize, Serialize, ToSchema)]
#[serde(rename_all = "snake_case")]
pub(crate) enum MeasurementGrade {
    /// Numbers published by those who measured.
    Measured,
    /// Read off a published figure.
    Digitised,
    /// Computed by a finer model.
    Simulated,
    /// From a worked example, or from an observation that stands for a measurement.
    WorkedExample,
}

/// A set: measurements, and the wheel and soil of a request that stand for theirs.
#[derive(Debug, Deserialize)]
#[serde(deny_unknown_fields)]
pub(crate) struct Record {
    pub(crate) id: String,
    pub(crate) title: String,
    pub(crate) source: String,
    pub(crate) grade: MeasurementGrade,
    pub(crate) note: Option<String>,
    pub(crate) wheel: Value,
    pub(crate) soil: Value,
    pub(crate) contact: Option<Value>,
    /// What of the parameters was fitted to these measurements.
    pub(crate) fitted_to: Option<String>,
    measured: Measured,
}

#[derive(Debug, Deserialize)]
#[serde(untagged)]
enum Measured {
    Points(Points),
    /// Those of the set of that name.
    SameAs(String),
}

/// Measurements by slip; a quantity that was not measured is left out.
#[derive(Debug, Default, Deserialize)]
#[serde(deny_unknown_fields)]
pub(crate) struct Points {
    normal_load_n: Load,
    pub(crate) slip: Vec<f64>,
    longitudinal_force_n: Option<Vec<Option<f64>>>,
    sinkage_m: Option<Vec<Option<f64>>>,
    torque_n_m: Option<Vec<Option<f64>>>,
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

impl Record {
    /// The measurements, its own or those it shares; none where a record names a set that is not there.
    pub(crate) fn points(&self) -> &Points {
        static NONE: std::sync::LazyLock<Points> = std::sync::LazyLock::new(Points::default);
        match &self.measured {
            Measured::Points(points) => points,
            Measured::SameAs(id) => match super::record(id).map(|record| &record.measured) {
                Some(Measured::Points(points)) => points,
                _ => &NONE,
            },
        }
    }
}

impl Points {
    /// Load W at each point (N).
    pub(crate) fn load(&self) -> Vec<f64> {
        match &self.normal_load_n {
            Load::Constant(load) => vec![*load; self.slip.len()],
            Load::Measured(loads) => loads.clone(),
        }
    }

    /// Drawbar pull at each point (N), NaN where it was not measured.
    pub(crate) fn longitudinal_force(&self) -> Vec<f64> {
        self.column(self.longitudinal_force_n.as_ref())
    }

    /// Sinkage at each point (m), NaN where it was not measured.
    pub(crate) fn sinkage(&self) -> Vec<f64> {
        self.column(self.sinkage_m.as_ref())
    }

    /// Torque at each point (N·m), NaN where it was not measured.
    pub(crate) fn torque(&self) -> Vec<f64> {
        self.column(self.torque_n_m.as_ref())
    }

    fn column(&self, values: Option<&Vec<Option<f64>>>) -> Vec<f64> {
        match values {
            Some(values) => values.iter().map(|value| value.unwrap_or(f64::NAN)).collect(),
            None => vec![f64::NAN; self.slip.len()],
        }
    }
}
