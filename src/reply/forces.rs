//! The answer of `/v1/forces`.

use std::borrow::Cow;

use serde::Serialize;
use terramechanics::{Error, Heading, Method, Outcome, cautions};
use utoipa::ToSchema;

use super::warning::system_warnings;
use super::{AnglesReply, Reply, Warning};
use crate::request::ForcesCase;

/// The name of a method on the wire.
pub(crate) fn method_name(method: &Method) -> &'static str {
    match method {
        Method::Quadrature | Method::SideSlipping(_) => "quadrature",
        Method::Linearised { .. } => "linearised",
        Method::Explicit { .. } => "explicit",
    }
}

/// Forces and torque on the wheel.
#[derive(Debug, Serialize, ToSchema)]
#[schema(as = Forces)]
pub(crate) struct ForcesReply {
    /// Slip ratio s (–).
    slip: f64,
    /// Sinkage z (m).
    sinkage_m: f64,
    /// The method by which the forces were found.
    method: &'static str,
    angles: AnglesReply,
    /// Longitudinal force F_x, the drawbar pull (N).
    longitudinal_force_n: f64,
    /// Normal force F_z (N).
    normal_force_n: f64,
    /// Torque T about the axle (N·m).
    torque_n_m: f64,
    components: ComponentsReply,
    /// Lateral force F_y (N), to the left, with the sign of the slip angle; present where a slip angle was sent.
    #[serde(skip_serializing_if = "Option::is_none")]
    #[schema(nullable = false)]
    lateral_force_n: Option<f64>,
    /// Overturning moment M_x = r F_y (N·m) about the axis ahead; present where a slip angle was sent.
    #[serde(skip_serializing_if = "Option::is_none")]
    #[schema(nullable = false)]
    overturning_moment_n_m: Option<f64>,
    /// Aligning moment M_z (N·m) of the lateral stresses about the axis upwards; present where a slip angle was sent.
    #[serde(skip_serializing_if = "Option::is_none")]
    #[schema(nullable = false)]
    aligning_moment_n_m: Option<f64>,
    /// F_x/F_z (–); null where F_z is not positive.
    drawbar_coefficient: Option<f64>,
    /// F_x v/(T ω) (–), the power at the axle over that of the torque; null unless the wheel drives. Negative where a driven wheel has to be pulled all the same, and then it has no lower bound.
    tractive_efficiency: Option<f64>,
    /// Sinkage modulus K_s (Pa/m^N).
    sinkage_modulus: f64,
    /// Sinkage exponent N (–).
    sinkage_exponent: f64,
    /// Shearing radius r_s (m).
    shearing_radius_m: f64,
    warnings: Vec<Warning>,
    /// The numbers once more, as the one row of a table.
    #[serde(skip)]
    row: Vec<f64>,
}

/// The four parts of the forces: F_x = traction − resistance, F_z = normal support + shear support.
#[derive(Debug, Serialize, ToSchema)]
#[schema(as = Components)]
struct ComponentsReply {
    /// Shear stress along x (N).
    traction_n: f64,
    /// Normal stress against x (N).
    resistance_n: f64,
    /// Normal stress along z (N).
    normal_support_n: f64,
    /// Shear stress along z (N).
    shear_support_n: f64,
}

/// Names of the columns of forces, here and in a sweep.
pub(super) const COLUMNS: [&str; 11] = [
    "slip",
    "sinkage_m",
    "longitudinal_force_n",
    "normal_force_n",
    "torque_n_m",
    "traction_n",
    "resistance_n",
    "normal_support_n",
    "shear_support_n",
    "drawbar_coefficient",
    "tractive_efficiency",
];

/// Names of the further columns where a slip angle was sent.
pub(super) const SIDE_COLUMNS: [&str; 3] = ["lateral_force_n", "overturning_moment_n_m", "aligning_moment_n_m"];

impl TryFrom<&ForcesCase> for ForcesReply {
    type Error = Error;

    fn try_from(query: &ForcesCase) -> Result<Self, Error> {
        let ForcesCase { operation, motion } = query;
        let wheel = &operation.system.wheel;
        let point = operation.at(motion.slip)?;
        let forces = point.forces.heading(motion.heading);
        let parts = &forces.components;
        let mut warnings: Vec<Warning> = cautions(operation, &Outcome::from(&point)).map(Warning::from).collect();
        warnings.extend(system_warnings(wheel, operation.system.soil.params()));
        if motion.heading == Heading::Backward {
            warnings.push(Warning::mirrored());
        }
        let drawbar_coefficient = forces.drawbar_coefficient();
        let efficiency = || forces.tractive_efficiency(wheel, motion.slip, motion.heading);
        let tractive_efficiency = if motion.at_rest { None } else { efficiency() }; // 0/0
        let side = forces.side;
        let mut row = vec![
            motion.slip.ratio(),
            point.sinkage,
            forces.longitudinal,
            forces.normal,
            forces.torque,
            parts.traction,
            parts.resistance,
            parts.normal_support,
            parts.shear_support,
            drawbar_coefficient.unwrap_or(f64::NAN),
            tractive_efficiency.unwrap_or(f64::NAN),
        ];
        row.extend(side.iter().flat_map(|side| [side.lateral, side.overturning_moment, side.aligning_moment]));
        Ok(Self {
            slip: motion.slip.ratio(),
            sinkage_m: point.sinkage,
            method: method_name(&operation.model.method),
            angles: point.angles.into(),
            longitudinal_force_n: forces.longitudinal,
            normal_force_n: forces.normal,
            torque_n_m: forces.torque,
            components: ComponentsReply {
                traction_n: parts.traction,
                resistance_n: parts.resistance,
                normal_support_n: parts.normal_support,
                shear_support_n: parts.shear_support,
            },
            lateral_force_n: side.map(|side| side.lateral),
            overturning_moment_n_m: side.map(|side| side.overturning_moment),
            aligning_moment_n_m: side.map(|side| side.aligning_moment),
            drawbar_coefficient,
            tractive_efficiency,
            sinkage_modulus: point.sinkage_modulus,
            sinkage_exponent: point.sinkage_exponent,
            shearing_radius_m: wheel.shearing_radius(),
            warnings,
            row,
        })
    }
}

impl Reply for ForcesReply {
    fn columns(&self) -> Vec<(Cow<'static, str>, &[f64])> {
        COLUMNS.into_iter().chain(SIDE_COLUMNS).map(Cow::from).zip(self.row.chunks(1)).collect()
    }

    fn warnings(&self) -> &[Warning] {
        &self.warnings
    }
}
