//! Measured and predicted columns side by side.

use std::borrow::Cow;

use serde::Serialize;
use terramechanics_identification::{Fit, FittedColumn, Observations, Quantity};
use utoipa::ToSchema;

use crate::reply::Column;

/// Columns of one length: what was measured, what the model predicts with the estimates, and predicted minus measured; only for the quantities that were fitted.
#[derive(Debug, Default, Serialize, ToSchema)]
pub(super) struct IdentifyColumns {
    /// Slip ratio s (–).
    #[schema(value_type = Vec<f64>)]
    slip: Column,
    /// Sinkage z at which the forces are predicted (m).
    #[schema(value_type = Vec<f64>)]
    sinkage_m: Column,
    #[serde(flatten)]
    sinkage: SinkageColumns,
    #[serde(flatten)]
    longitudinal: LongitudinalColumns,
    #[serde(flatten)]
    normal: NormalColumns,
    #[serde(flatten)]
    torque: TorqueColumns,
}

/// Declares the three columns of one quantity.
macro_rules! columns_of {
    ($title:ident, $what:literal, $measured:ident, $predicted:ident, $residual:ident) => {
        #[derive(Debug, Default, Serialize, ToSchema)]
        struct $title {
            #[doc = concat!("Measured ", $what, ".")]
            #[schema(value_type = Option<Vec<f64>>, nullable = false)]
            #[serde(skip_serializing_if = "Option::is_none")]
            $measured: Option<Column>,
            #[doc = concat!("Predicted ", $what, ".")]
            #[schema(value_type = Option<Vec<f64>>, nullable = false)]
            #[serde(skip_serializing_if = "Option::is_none")]
            $predicted: Option<Column>,
            #[doc = concat!("Predicted minus measured ", $what, ".")]
            #[schema(value_type = Option<Vec<f64>>, nullable = false)]
            #[serde(skip_serializing_if = "Option::is_none")]
            $residual: Option<Column>,
        }

        impl $title {
            fn of(column: &FittedColumn) -> Self {
                let residual = column.predicted.iter().zip(&column.measured).map(|(predicted, measured)| predicted - measured);
                Self {
                    $residual: Some(Column(residual.collect())),
                    $measured: Some(Column(column.measured.clone())),
                    $predicted: Some(Column(column.predicted.clone())),
                }
            }

            fn named(&self) -> [(&'static str, Option<&Column>); 3] {
                [
                    (stringify!($measured), self.$measured.as_ref()),
                    (stringify!($predicted), self.$predicted.as_ref()),
                    (stringify!($residual), self.$residual.as_ref()),
                ]
            }
        }
    };
}

columns_of!(SinkageColumns, "sinkage (m)", measured_sinkage_m, predicted_sinkage_m, residual_sinkage_m);
columns_of!(
    LongitudinalColumns,
    "longitudinal force (N)",
    measured_longitudinal_force_n,
    predicted_longitudinal_force_n,
    residual_longitudinal_force_n
);
columns_of!(NormalColumns, "normal force (N)", measured_normal_force_n, predicted_normal_force_n, residual_normal_force_n);
columns_of!(TorqueColumns, "torque (N·m)", measured_torque_n_m, predicted_torque_n_m, residual_torque_n_m);

impl IdentifyColumns {
    pub(super) fn of_fit(observations: &Observations, found: &Fit) -> Self {
        Self::of(observations, found.sinkage.clone(), &found.columns)
    }

    pub(super) fn of(observations: &Observations, sinkage: Vec<f64>, fitted: &[FittedColumn]) -> Self {
        let slip = Column(observations.slip.iter().map(|slip| slip.ratio()).collect());
        let mut columns = Self { slip, sinkage_m: Column(sinkage), ..Self::default() };
        for column in fitted {
            match column.quantity {
                Quantity::Sinkage => columns.sinkage = SinkageColumns::of(column),
                Quantity::Longitudinal => columns.longitudinal = LongitudinalColumns::of(column),
                Quantity::Normal => columns.normal = NormalColumns::of(column),
                Quantity::Torque => columns.torque = TorqueColumns::of(column),
            }
        }
        columns
    }

    /// The columns by name.
    pub(super) fn named(&self) -> Vec<(Cow<'static, str>, &[f64])> {
        let always = [("slip", Some(&self.slip)), ("sinkage_m", Some(&self.sinkage_m))];
        let groups = [self.sinkage.named(), self.longitudinal.named(), self.normal.named(), self.torque.named()];
        let there = always.into_iter().chain(groups.into_iter().flatten());
        there.filter_map(|(name, column)| Some((name.into(), column?.0.as_slice()))).collect()
    }
}
