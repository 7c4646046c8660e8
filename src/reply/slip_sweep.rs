//! The answer of `/v1/slip-sweep`.

use std::borrow::Cow;
use std::collections::BTreeMap;

use serde::Serialize;
use terramechanics::{Error, Outcome, SideColumns, SlipSweep, cautions};
use utoipa::ToSchema;

use super::forces::{COLUMNS, SIDE_COLUMNS, method_name};
use super::warning::{RowCautions, rows_in_words, system_warnings};
use super::{Column, Reply, Warning};
use crate::compute::{Pace, Stop};
use crate::request::{SweepCase, error_pointer};

/// Forces over slip.
#[derive(Debug, Serialize, ToSchema)]
#[schema(as = SlipSweep)]
pub(crate) struct SweepReply {
    /// The method by which the forces were found.
    pub(super) method: &'static str,
    pub(super) columns: SweepColumns,
    pub(super) warnings: Vec<Warning>,
}

/// Columns of one length; null where a point has no solution or a coefficient is undefined.
#[derive(Debug, Serialize, ToSchema)]
pub(super) struct SweepColumns {
    /// Slip ratio s (–).
    #[schema(value_type = Vec<f64>)]
    slip: Column,
    /// Sinkage z (m).
    #[schema(value_type = Vec<Option<f64>>)]
    sinkage_m: Column,
    /// Longitudinal force F_x, the drawbar pull (N).
    #[schema(value_type = Vec<Option<f64>>)]
    longitudinal_force_n: Column,
    /// Normal force F_z (N).
    #[schema(value_type = Vec<Option<f64>>)]
    normal_force_n: Column,
    /// Torque T about the axle (N·m).
    #[schema(value_type = Vec<Option<f64>>)]
    torque_n_m: Column,
    /// Shear stress along x (N).
    #[schema(value_type = Vec<Option<f64>>)]
    traction_n: Column,
    /// Normal stress against x (N).
    #[schema(value_type = Vec<Option<f64>>)]
    resistance_n: Column,
    /// Normal stress along z (N).
    #[schema(value_type = Vec<Option<f64>>)]
    normal_support_n: Column,
    /// Shear stress along z (N).
    #[schema(value_type = Vec<Option<f64>>)]
    shear_support_n: Column,
    /// F_x/F_z (–).
    #[schema(value_type = Vec<Option<f64>>)]
    drawbar_coefficient: Column,
    /// F_x v/(T ω) (–), while the wheel drives.
    #[schema(value_type = Vec<Option<f64>>)]
    tractive_efficiency: Column,
    /// Lateral force F_y (N), to the left, with the sign of the slip angle; present where a slip angle was sent.
    #[serde(skip_serializing_if = "Option::is_none")]
    #[schema(value_type = Vec<Option<f64>>, required = false)]
    lateral_force_n: Option<Column>,
    /// Overturning moment M_x = r F_y (N·m) about the axis ahead; present where a slip angle was sent.
    #[serde(skip_serializing_if = "Option::is_none")]
    #[schema(value_type = Vec<Option<f64>>, required = false)]
    overturning_moment_n_m: Option<Column>,
    /// Aligning moment M_z (N·m) of the lateral stresses about the axis upwards; present where a slip angle was sent.
    #[serde(skip_serializing_if = "Option::is_none")]
    #[schema(value_type = Vec<Option<f64>>, required = false)]
    aligning_moment_n_m: Option<Column>,
}

impl SweepReply {
    /// The forces at each slip.
    ///
    /// # Errors
    /// [`Stop`], where the work is to end.
    pub(crate) fn of(query: &SweepCase, pace: &Pace) -> Result<Self, Stop> {
        let SweepCase { operation, slips } = query;
        let is_light = operation.model.method.is_closed_form();
        let mut sweep = SlipSweep::with_capacity(slips.len());
        for &slip in slips {
            if is_light { pace.glance() } else { pace.look() }?;
            sweep.push(operation, slip);
        }
        let mut warnings = gap_warnings(&sweep, |error| error_pointer(error, &operation.sinkage));
        let mut cautious = RowCautions::default();
        for (row, &slip) in slips.iter().enumerate().filter(|(row, _)| sweep.sinkage[*row].is_finite()) {
            let outcome = Outcome {
                slip,
                sinkage: sweep.sinkage[row],
                normal: Some(sweep.normal[row]),
                integration_error: sweep.integration_error[row],
                mobilised_share: sweep.side.mobilised_share.get(row).copied(),
            };
            cautious.add(row, cautions(operation, &outcome));
        }
        warnings.extend(cautious.into_warnings(slips.len()));
        warnings.extend(system_warnings(&operation.system.wheel, operation.system.soil.params()));
        Ok(Self { method: method_name(&operation.model.method), columns: sweep.into(), warnings })
    }
}

impl From<SlipSweep> for SweepColumns {
    fn from(sweep: SlipSweep) -> Self {
        let SideColumns { lateral, overturning_moment, aligning_moment, .. } = sweep.side;
        let across = |column: Vec<f64>| (!column.is_empty()).then_some(Column(column));
        Self {
            slip: Column(sweep.slip),
            sinkage_m: Column(sweep.sinkage),
            longitudinal_force_n: Column(sweep.longitudinal),
            normal_force_n: Column(sweep.normal),
            torque_n_m: Column(sweep.torque),
            traction_n: Column(sweep.traction),
            resistance_n: Column(sweep.resistance),
            normal_support_n: Column(sweep.normal_support),
            shear_support_n: Column(sweep.shear_support),
            drawbar_coefficient: Column(sweep.drawbar_coefficient),
            tractive_efficiency: Column(sweep.tractive_efficiency),
            lateral_force_n: across(lateral),
            overturning_moment_n_m: across(overturning_moment),
            aligning_moment_n_m: across(aligning_moment),
        }
    }
}

/// One warning for each field at fault: the rows without a solution, and the reason of the first.
fn gap_warnings(sweep: &SlipSweep, pointer: impl Fn(&Error) -> &'static str) -> Vec<Warning> {
    let mut by_field: BTreeMap<&'static str, Vec<usize>> = BTreeMap::new();
    for (i, gap) in sweep.gaps.iter().enumerate() {
        by_field.entry(pointer(&gap.error)).or_default().push(i);
    }
    let warning = |(field, gaps): (&&'static str, &Vec<usize>)| {
        let rows: Vec<usize> = gaps.iter().map(|&i| sweep.gaps[i].row).collect();
        let first = &sweep.gaps[gaps[0]];
        let detail = format!(
            "no solution at indices {}; at slip {:.4}, field {field}: {}",
            rows_in_words(&rows),
            sweep.slip[first.row],
            first.error
        );
        Warning::new("no_solution", detail)
    };
    by_field.iter().map(warning).collect()
}

impl SweepColumns {
    /// The columns by name.
    pub(super) fn named(&self) -> [(&'static str, &[f64]); COLUMNS.len()] {
        let columns = [
            &self.slip,
            &self.sinkage_m,
            &self.longitudinal_force_n,
            &self.normal_force_n,
            &self.torque_n_m,
            &self.traction_n,
            &self.resistance_n,
            &self.normal_support_n,
            &self.shear_support_n,
            &self.drawbar_coefficient,
            &self.tractive_efficiency,
        ];
        std::array::from_fn(|i| (COLUMNS[i], columns[i].0.as_slice()))
    }
}

impl Reply for SweepReply {
    fn columns(&self) -> Vec<(Cow<'static, str>, &[f64])> {
        let SweepColumns { lateral_force_n, overturning_moment_n_m, aligning_moment_n_m, .. } = &self.columns;
        let across = SIDE_COLUMNS.into_iter().zip([lateral_force_n, overturning_moment_n_m, aligning_moment_n_m]);
        let across = across.filter_map(|(name, column)| Some((name, column.as_ref()?.0.as_slice())));
        self.columns.named().into_iter().chain(across).map(|(name, column)| (name.into(), column)).collect()
    }

    fn warnings(&self) -> &[Warning] {
        &self.warnings
    }
}
