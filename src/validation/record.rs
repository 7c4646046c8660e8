//! Sets of measurements as they are kept.

use std::collections::BTreeMap;

use serde::{Deserialize, Serialize};
use serde_json::Value;
use terramechanics::Soil;
use utoipa::ToSchema;

use super::inputs::InputsOfOrigin;
use super::points::Points;
use super::run::{Run, runs_of};
use super::side_slip::SideSlipOfSet;
use crate::catalogue;

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
    /// Where its inputs come from.
    pub(crate) inputs: Vec<InputsOfOrigin>,
    /// Measured columns that count in no error, each with the reason.
    #[serde(default)]
    pub(crate) not_scored: BTreeMap<String, String>,
    pub(crate) source: String,
    pub(crate) grade: MeasurementGrade,
    pub(crate) note: Option<String>,
    pub(crate) wheel: Value,
    pub(crate) soil: Value,
    pub(crate) contact: Option<Value>,
    /// Where the wheel moved at a slip angle: its slips are then those of travel, and the contact goes with them.
    pub(crate) side_slip: Option<SideSlipOfSet>,
    /// Circle on which the slip was counted, as a request has it.
    pub(crate) slip_radius: String,
    /// Whether the source says so; else it is assumed.
    pub(crate) slip_radius_stated: bool,
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

    /// Slip in the plane of the wheel at each point, as a request has it.
    pub(crate) fn slip(&self) -> Vec<f64> {
        let published = self.points().slip.iter();
        published.map(|slip| self.side_slip.map_or(*slip, |side| side.slip(*slip))).collect()
    }

    /// The contact of a request for the point of that published slip, where the set has one of its own.
    pub(super) fn contact_at(&self, published_slip: f64) -> Option<Value> {
        self.side_slip.map(|side| side.contact(published_slip)).or_else(|| self.contact.clone())
    }

    /// The ways in which it is run.
    pub(crate) fn runs(&self) -> Vec<&'static Run> {
        let is_braking = self.points().slip.iter().all(|slip| *slip < 0.0);
        // A set that shares its measurements differs from the other in laws that grains do not have.
        let by_grains = self.has_density() && matches!(self.measured, Measured::Points(_));
        let points = self.points();
        let knows_sinkage = (0..points.slip.len()).all(|row| points.sinkage_at(row).is_some());
        runs_of(self.side_slip.is_some(), is_braking, by_grains, knows_sinkage).collect()
    }

    /// The quadrature, for a set that goes straight ahead.
    pub(super) fn quadrature(&self) -> Option<&'static Run> {
        self.runs().into_iter().find(|run| run.series == "quadrature" && run.side.is_none())
    }

    /// Whether the pull was measured at any point.
    pub(super) fn has_pull(&self) -> bool {
        self.points().longitudinal_force_n.iter().flatten().any(Option::is_some)
    }

    /// Whether the bulk density of the soil is known.
    fn has_density(&self) -> bool {
        let name = Soil::BULK_DENSITY.name;
        let preset = self.soil["preset"].as_str().and_then(catalogue::soil);
        self.soil[name].is_number() || preset.is_some_and(|record| record.number(name).is_some())
    }
}
