//! How do the forces change with slip? The same operation at many slips, as columns.

use crate::error::Error;
use crate::forces::Method;
use crate::lateral::SideForce;
use crate::operation::Operation;
use crate::slip::{Heading, Slip};

/// A slip at which the operation has no answer.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Gap {
    /// Row of the sweep.
    pub row: usize,
    /// Why it has none.
    pub error: Error,
}

/// Forces across the wheel over slip, as columns of one length; NaN where a row has no answer.
#[derive(Debug, Clone, Default, PartialEq)]
pub struct SideColumns {
    /// Lateral force F_y (N).
    pub lateral: Vec<f64>,
    /// Overturning moment M_x (N·m).
    pub overturning_moment: Vec<f64>,
    /// Aligning moment M_z (N·m).
    pub aligning_moment: Vec<f64>,
    /// Share of the pressure on the side wall that is mobilised (–).
    pub mobilised_share: Vec<f64>,
}

impl SideColumns {
    fn clear(&mut self) {
        for column in [&mut self.lateral, &mut self.overturning_moment, &mut self.aligning_moment, &mut self.mobilised_share] {
            column.clear();
        }
    }

    fn push(&mut self, side: Option<SideForce>) {
        let value = |value: fn(&SideForce) -> f64| side.as_ref().map_or(f64::NAN, value);
        self.lateral.push(value(|side| side.lateral));
        self.overturning_moment.push(value(|side| side.overturning_moment));
        self.aligning_moment.push(value(|side| side.aligning_moment));
        self.mobilised_share.push(value(|side| side.mobilised_share));
    }
}

/// Forces over slip, as columns of one length.
///
/// A row listed in `gaps` is NaN in every column but `slip`; a coefficient that is undefined at a slip is NaN there.
#[derive(Debug, Clone, Default, PartialEq)]
pub struct SlipSweep {
    /// Slip s (–).
    pub slip: Vec<f64>,
    /// Sinkage z (m).
    pub sinkage: Vec<f64>,
    /// Longitudinal force F_x (N).
    pub longitudinal: Vec<f64>,
    /// Normal force F_z (N).
    pub normal: Vec<f64>,
    /// Torque T (N·m).
    pub torque: Vec<f64>,
    /// Traction AY (N).
    pub traction: Vec<f64>,
    /// Resistance BX (N).
    pub resistance: Vec<f64>,
    /// Normal support AX (N).
    pub normal_support: Vec<f64>,
    /// Shear support BY (N).
    pub shear_support: Vec<f64>,
    /// Drawbar coefficient F_x/F_z (–).
    pub drawbar_coefficient: Vec<f64>,
    /// Tractive efficiency (–).
    pub tractive_efficiency: Vec<f64>,
    /// Estimate of the relative error of the integrals (–).
    pub integration_error: Vec<f64>,
    /// The forces across the wheel; empty where no slip angle was asked for.
    pub side: SideColumns,
    /// Rows without an answer, ascending.
    pub gaps: Vec<Gap>,
}

impl SlipSweep {
    /// Columns of the sweep, `slip` first.
    const COLUMNS: usize = 12;

    /// The forces of `operation` at each of `slips`.
    #[must_use]
    pub fn of(operation: &Operation, slips: &[Slip]) -> Self {
        let mut sweep = Self::default();
        sweep.fill(operation, slips);
        sweep
    }

    /// Columns without rows, with room for `rows`.
    #[must_use]
    pub fn with_capacity(rows: usize) -> Self {
        let mut sweep = Self::default();
        for column in sweep.columns_mut() {
            column.reserve_exact(rows);
        }
        sweep
    }

    /// The same into columns that are there already, without allocating where they are long enough.
    pub fn fill(&mut self, operation: &Operation, slips: &[Slip]) {
        self.gaps.clear();
        self.side.clear();
        for column in self.columns_mut() {
            column.clear();
            column.reserve(slips.len());
        }
        for &slip in slips {
            self.push(operation, slip);
        }
    }

    /// Adds the row of `slip`, for a caller that has to look up between rows. All rows of a sweep are of one `operation`.
    pub fn push(&mut self, operation: &Operation, slip: Slip) {
        let point = operation.at(slip);
        if matches!(operation.model.method, Method::SideSlipping(_)) {
            self.side.push(point.as_ref().ok().and_then(|point| point.forces.side));
        }
        let values = match point {
            Ok(point) => {
                let forces = &point.forces;
                let parts = &forces.components;
                [
                    slip.ratio(),
                    point.sinkage,
                    forces.longitudinal,
                    forces.normal,
                    forces.torque,
                    parts.traction,
                    parts.resistance,
                    parts.normal_support,
                    parts.shear_support,
                    forces.drawbar_coefficient().unwrap_or(f64::NAN),
                    forces.tractive_efficiency(&operation.system.wheel, slip, Heading::Forward).unwrap_or(f64::NAN),
                    forces.integration_error,
                ]
            }
            Err(error) => {
                self.gaps.push(Gap { row: self.slip.len(), error });
                let mut values = [f64::NAN; Self::COLUMNS];
                values[0] = slip.ratio();
                values
            }
        };
        for (column, value) in self.columns_mut().into_iter().zip(values) {
            column.push(value);
        }
    }

    fn columns_mut(&mut self) -> [&mut Vec<f64>; Self::COLUMNS] {
        [
            &mut self.slip,
            &mut self.sinkage,
            &mut self.longitudinal,
            &mut self.normal,
            &mut self.torque,
            &mut self.traction,
            &mut self.resistance,
            &mut self.normal_support,
            &mut self.shear_support,
            &mut self.drawbar_coefficient,
            &mut self.tractive_efficiency,
            &mut self.integration_error,
        ]
    }
}
