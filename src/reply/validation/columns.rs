//! The columns of a set of measurements.

use std::borrow::Cow;
use std::collections::BTreeMap;

use serde::Serialize;
use utoipa::ToSchema;

use crate::reply::Column;
use crate::validation::{Quantities, Record};

/// Columns of one length, measured and predicted.
#[derive(Debug, Serialize, ToSchema)]
pub(super) struct ValidationColumns {
    /// Slip ratio s (–), in the plane of the wheel.
    #[schema(value_type = Vec<f64>)]
    slip: Column,
    /// Vertical load W (N).
    #[schema(value_type = Vec<f64>)]
    normal_load_n: Column,
    /// Slip ratio (–) as published where the wheel moved at a slip angle: of the speed of travel, not of its component along
    /// the heading.
    #[serde(skip_serializing_if = "Option::is_none")]
    #[schema(value_type = Vec<f64>, required = false)]
    travel_slip: Option<Column>,
    #[serde(skip_serializing_if = "Option::is_none")]
    #[schema(nullable = false)]
    contact: Option<ContactColumns>,
    pub(super) measured: ForceColumns,
    pub(super) predicted: PredictedColumns,
}

/// The contact where it goes with the published slip: rule `wong_reece` with `c2` 0.
#[derive(Debug, Serialize, ToSchema)]
struct ContactColumns {
    /// θm/θ1 (–).
    #[schema(value_type = Vec<f64>)]
    c1: Column,
    /// θ2/θ1 (–).
    #[schema(value_type = Vec<f64>)]
    c3: Column,
}

/// By method, and by what departs from the defaults of a request: the sinkage is solved for the load. Sets at a slip angle have
/// no closed forms, sets of braking wheels two laws of braking.
#[derive(Debug, Default, Serialize, ToSchema)]
pub(super) struct PredictedColumns {
    quadrature: ForceColumns,
    #[serde(skip_serializing_if = "Option::is_none")]
    #[schema(nullable = false)]
    linearised: Option<ForceColumns>,
    #[serde(skip_serializing_if = "Option::is_none")]
    #[schema(nullable = false)]
    explicit: Option<ForceColumns>,
    #[serde(skip_serializing_if = "Option::is_none")]
    #[schema(nullable = false)]
    quadrature_two_zone: Option<ForceColumns>,
    #[serde(skip_serializing_if = "Option::is_none")]
    #[schema(nullable = false)]
    quadrature_mobilised: Option<ForceColumns>,
    #[serde(skip_serializing_if = "Option::is_none")]
    #[schema(nullable = false)]
    quadrature_coupled: Option<ForceColumns>,
    #[serde(skip_serializing_if = "Option::is_none")]
    #[schema(nullable = false)]
    quadrature_coupled_mobilised: Option<ForceColumns>,
}

/// Null where a quantity was not measured or a point has no solution.
#[derive(Debug, Default, Serialize, ToSchema)]
#[schema(as = ValidationForces)]
pub(super) struct ForceColumns {
    /// Drawbar pull F_x (N).
    #[schema(value_type = Vec<Option<f64>>)]
    longitudinal_force_n: Column,
    /// Sinkage z (m).
    #[schema(value_type = Vec<Option<f64>>)]
    pub(super) sinkage_m: Column,
    /// Torque T about the axle (N·m).
    #[schema(value_type = Vec<Option<f64>>)]
    pub(super) torque_n_m: Column,
    /// F_x/W (–).
    #[schema(value_type = Vec<Option<f64>>)]
    pub(super) drawbar_coefficient: Column,
    /// Lateral force F_y (N), positive against the sideways motion; present where the wheel moved at a slip angle.
    #[serde(skip_serializing_if = "Option::is_none")]
    #[schema(value_type = Vec<Option<f64>>, required = false)]
    lateral_force_n: Option<Column>,
    /// F_y/W (–); present where the wheel moved at a slip angle.
    #[serde(skip_serializing_if = "Option::is_none")]
    #[schema(value_type = Vec<Option<f64>>, required = false)]
    pub(super) lateral_coefficient: Option<Column>,
}

impl ValidationColumns {
    pub(super) fn of(record: &Record, measured: ForceColumns, predicted: PredictedColumns) -> Self {
        let published = &record.points().slip;
        let contact = record.side_slip.map(|side| ContactColumns {
            c1: Column(published.iter().map(|slip| side.c1(*slip)).collect()),
            c3: Column(published.iter().map(|slip| side.c3(*slip)).collect()),
        });
        Self {
            slip: Column(record.slip()),
            normal_load_n: Column(record.points().load()),
            travel_slip: record.side_slip.is_some().then(|| Column(published.clone())),
            contact,
            measured,
            predicted,
        }
    }

    /// The slips and the load, then `measured.` and `predicted.series.` with the name of each column.
    pub(super) fn named(&self) -> Vec<(Cow<'static, str>, &[f64])> {
        let mut columns = vec![(Cow::from("slip"), self.slip.0.as_slice()), ("normal_load_n".into(), &self.normal_load_n.0)];
        columns.extend(self.travel_slip.iter().map(|Column(slip)| ("travel_slip".into(), slip.as_slice())));
        if let Some(ContactColumns { c1, c3 }) = &self.contact {
            columns.extend([("contact.c1".into(), c1.0.as_slice()), ("contact.c3".into(), &c3.0)]);
        }
        columns.extend(self.measured.named().map(|(name, column)| (format!("measured.{name}").into(), column)));
        for (series, forces) in self.predicted.named() {
            columns.extend(forces.named().map(|(name, column)| (format!("predicted.{series}.{name}").into(), column)));
        }
        columns
    }
}

impl PredictedColumns {
    /// Of the columns by series.
    pub(super) fn of(mut by_series: BTreeMap<&'static str, ForceColumns>) -> Self {
        Self {
            quadrature: by_series.remove("quadrature").unwrap_or_default(),
            linearised: by_series.remove("linearised"),
            explicit: by_series.remove("explicit"),
            quadrature_two_zone: by_series.remove("quadrature_two_zone"),
            quadrature_mobilised: by_series.remove("quadrature_mobilised"),
            quadrature_coupled: by_series.remove("quadrature_coupled"),
            quadrature_coupled_mobilised: by_series.remove("quadrature_coupled_mobilised"),
        }
    }

    fn named(&self) -> impl Iterator<Item = (&'static str, &ForceColumns)> {
        [
            ("quadrature", Some(&self.quadrature)),
            ("linearised", self.linearised.as_ref()),
            ("explicit", self.explicit.as_ref()),
            ("quadrature_two_zone", self.quadrature_two_zone.as_ref()),
            ("quadrature_mobilised", self.quadrature_mobilised.as_ref()),
            ("quadrature_coupled", self.quadrature_coupled.as_ref()),
            ("quadrature_coupled_mobilised", self.quadrature_coupled_mobilised.as_ref()),
        ]
        .into_iter()
        .filter_map(|(series, forces)| Some((series, forces?)))
    }
}

impl ForceColumns {
    pub(super) fn of(quantities: Quantities, load: &[f64], is_sideways: bool) -> Self {
        let Quantities { longitudinal_force, sinkage, torque, lateral_force } = quantities;
        let over_load = |forces: &[f64]| Column(forces.iter().zip(load).map(|(force, load)| force / load).collect());
        Self {
            drawbar_coefficient: over_load(&longitudinal_force),
            lateral_coefficient: is_sideways.then(|| over_load(&lateral_force)),
            longitudinal_force_n: Column(longitudinal_force),
            sinkage_m: Column(sinkage),
            torque_n_m: Column(torque),
            lateral_force_n: is_sideways.then_some(Column(lateral_force)),
        }
    }

    fn named(&self) -> impl Iterator<Item = (&'static str, &[f64])> {
        [
            ("longitudinal_force_n", Some(&self.longitudinal_force_n)),
            ("sinkage_m", Some(&self.sinkage_m)),
            ("torque_n_m", Some(&self.torque_n_m)),
            ("drawbar_coefficient", Some(&self.drawbar_coefficient)),
            ("lateral_force_n", self.lateral_force_n.as_ref()),
            ("lateral_coefficient", self.lateral_coefficient.as_ref()),
        ]
        .into_iter()
        .filter_map(|(name, column)| Some((name, column?.0.as_slice())))
    }
}
