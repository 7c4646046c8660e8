//! The answer of `/v1/stress-profile`.

use std::borrow::Cow;

use serde::Serialize;
use terramechanics::{Error, Heading, Outcome, StressProfile, cautions};
use utoipa::ToSchema;

use super::warning::system_warnings;
use super::{AnglesReply, Column, Reply, Warning};
use crate::request::ProfileCase;

/// Stresses along the rim, exact and linearised.
#[derive(Debug, Serialize, ToSchema)]
#[schema(as = StressProfile)]
pub(crate) struct ProfileReply {
    /// Slip ratio s (–).
    slip: f64,
    /// Sinkage z (m).
    sinkage_m: f64,
    angles: AnglesReply,
    peak: PeakReply,
    columns: ProfileColumns,
    warnings: Vec<Warning>,
}

/// The exact stresses at the angle of maximum stress.
#[derive(Debug, Serialize, ToSchema)]
#[schema(as = Peak)]
struct PeakReply {
    /// Normal stress σ (Pa).
    normal_stress_pa: f64,
    /// Shear stress τ (Pa).
    shear_stress_pa: f64,
}

/// Columns of one length, from exit to entry.
#[derive(Debug, Serialize, ToSchema)]
struct ProfileColumns {
    /// θ (rad), ascending.
    #[schema(value_type = Vec<f64>)]
    theta_rad: Column,
    /// Depth that presses there (m).
    #[schema(value_type = Vec<f64>)]
    sinkage_m: Column,
    /// Normal stress σ (Pa).
    #[schema(value_type = Vec<f64>)]
    normal_stress_pa: Column,
    /// Shear stress τ (Pa).
    #[schema(value_type = Vec<f64>)]
    shear_stress_pa: Column,
    /// Linearised normal stress (Pa); null where a braking wheel has two zones.
    #[schema(value_type = Vec<Option<f64>>)]
    normal_stress_linear_pa: Column,
    /// Linearised shear stress (Pa); null where a braking wheel has two zones.
    #[schema(value_type = Vec<Option<f64>>)]
    shear_stress_linear_pa: Column,
}

impl TryFrom<&ProfileCase> for ProfileReply {
    type Error = Error;

    fn try_from(query: &ProfileCase) -> Result<Self, Error> {
        let ProfileCase { operation, motion, peak_depth, points } = query;
        let rolling = operation.system.rolling(motion.slip)?;
        let (sinkage, solved) = operation.sinkage_of(&rolling)?;
        let patch = rolling.contact(sinkage)?;
        let stresses = patch.stresses()?;
        let peak = stresses.at(patch.angles.peak);
        let profile = StressProfile::of(&stresses, *points, *peak_depth);
        let StressProfile { theta, depth, normal, shear, normal_linear, shear_linear } = profile;
        let parted = patch.has_two_zones();
        let finite = |columns: [&[f64]; 5]| columns.iter().all(|column| column.iter().all(|value| value.is_finite()));
        let (normal_stated, shear_stated): (&[f64], &[f64]) = if parted { (&[], &[]) } else { (&normal_linear, &shear_linear) };
        if !finite([&depth, &normal, &shear, normal_stated, shear_stated]) {
            return Err(Error::NotFinite);
        }
        let outcome = Outcome {
            slip: motion.slip,
            sinkage,
            normal: solved.map(|forces| forces.normal),
            integration_error: solved.map_or(0.0, |forces| forces.integration_error),
            mobilised_share: None,
        };
        let mut warnings: Vec<Warning> = cautions(operation, &outcome).map(Warning::from).collect();
        warnings.extend(system_warnings(&operation.system.wheel, operation.system.soil.params()));
        if motion.heading == Heading::Backward {
            warnings.push(Warning::mirrored());
        }
        if parted {
            let detail = "two zones have no linear stresses: no shear stress acts at their peak";
            warnings.push(Warning::new("no_linear_stresses", detail));
        }
        if *points < StressProfile::FEWEST_POINTS {
            let detail =
                format!("the exit, the peak and the entry are always among the places, so there are {} of them", theta.len());
            warnings.push(Warning::new("points_raised", detail));
        }
        Ok(Self {
            slip: motion.slip.ratio(),
            sinkage_m: sinkage,
            angles: patch.angles.into(),
            peak: PeakReply { normal_stress_pa: peak.normal, shear_stress_pa: peak.shear },
            columns: ProfileColumns {
                theta_rad: Column(theta),
                sinkage_m: Column(depth),
                normal_stress_pa: Column(normal),
                shear_stress_pa: Column(shear),
                normal_stress_linear_pa: Column(normal_linear),
                shear_stress_linear_pa: Column(shear_linear),
            },
            warnings,
        })
    }
}

impl Reply for ProfileReply {
    fn columns(&self) -> Vec<(Cow<'static, str>, &[f64])> {
        let columns = &self.columns;
        vec![
            ("theta_rad".into(), &columns.theta_rad.0),
            ("sinkage_m".into(), &columns.sinkage_m.0),
            ("normal_stress_pa".into(), &columns.normal_stress_pa.0),
            ("shear_stress_pa".into(), &columns.shear_stress_pa.0),
            ("normal_stress_linear_pa".into(), &columns.normal_stress_linear_pa.0),
            ("shear_stress_linear_pa".into(), &columns.shear_stress_linear_pa.0),
        ]
    }

    fn warnings(&self) -> &[Warning] {
        &self.warnings
    }
}
