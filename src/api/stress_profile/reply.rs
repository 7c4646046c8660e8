//! The answer of `/v1/stress-profile`.

use serde::Serialize;
use terramechanics::StressProfile;
use utoipa::ToSchema;

use super::found::FoundProfile;
use crate::quantity::{About, Columns, Field, Shape};
use crate::reply::{AnglesReply, in_columns};
use crate::request::circles::words;
use crate::warning::Warning;

/// Stresses along the rim, exact and linearised.
#[derive(Debug, Serialize, ToSchema)]
#[schema(as = StressProfile)]
pub(crate) struct ProfileReply {
    /// Slip ratio s (–).
    slip: f64,
    /// Sinkage z (m).
    sinkage_m: f64,
    /// Circle on which the shear displacement was counted: shearing or rim; null where the method counts none.
    #[schema(required = true, example = "shearing")]
    shear_displacement_radius: Option<&'static str>,
    /// Circle on which the slip was counted: rim, shearing or lug_tip.
    #[schema(example = "rim")]
    slip_radius: &'static str,
    /// What the normal stress follows from: the pressure–sinkage law of the soil, or the load, which was known beside the sinkage.
    #[schema(example = "soil")]
    normal_stress_from: &'static str,
    /// Sinkage modulus K_s (Pa/m^N): the soil's, or the one that the load shows; null by the method resistive_force.
    sinkage_modulus: Option<f64>,
    /// Sinkage exponent N (–) at this slip; null by the method resistive_force.
    sinkage_exponent: Option<f64>,
    angles: AnglesReply,
    peak: PeakReply,
    /// Granular stiffness ξ (N/m³); present by the method resistive_force.
    #[serde(skip_serializing_if = "Option::is_none")]
    #[schema(nullable = false)]
    granular_stiffness_n_m3: Option<f64>,
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

/// Columns along the rim.
#[derive(Debug)]
struct AlongRim;

type ProfileColumns = Columns<AlongRim>;

static COLUMNS: [About; 6] = [
    About::new("theta_rad", "θ", "rad", "place on the rim, ascending"),
    About::new("sinkage_m", "z(θ)", "m", "depth that sets the normal stress there"),
    About::new("normal_stress_pa", "σ", "Pa", "normal stress"),
    About::new("shear_stress_pa", "τ", "Pa", "shear stress"),
    About::new(
        "normal_stress_linear_pa",
        "σ",
        "Pa",
        "linearised normal stress; null where a braking wheel has two zones, and by the method resistive_force",
    ),
    About::new(
        "shear_stress_linear_pa",
        "τ",
        "Pa",
        "linearised shear stress; null where a braking wheel has two zones, and by the method resistive_force",
    ),
];

impl Shape for AlongRim {
    const NAME: &'static str = "ProfileColumns";
    const DOC: &'static str = "Columns of one length, from exit to entry.";

    fn fields() -> Vec<Field> {
        let (exact, linear) = COLUMNS.split_at(4);
        exact.iter().map(Field::always).chain(linear.iter().map(Field::or_null)).collect()
    }
}

impl From<FoundProfile> for ProfileReply {
    fn from(found: FoundProfile) -> Self {
        let FoundProfile { circles, point, peak, profile, warnings } = found;
        let (shear_displacement_radius, slip_radius) = words(circles);
        let StressProfile { theta, depth, normal, shear, normal_linear, shear_linear } = profile;
        Self {
            slip: point.slip.ratio(),
            sinkage_m: point.sinkage,
            shear_displacement_radius,
            slip_radius,
            normal_stress_from: point.normal_stress_from.name(),
            sinkage_modulus: point.sinkage_modulus(),
            sinkage_exponent: point.sinkage_exponent(),
            angles: point.angles.into(),
            peak: PeakReply { normal_stress_pa: peak.normal, shear_stress_pa: peak.shear },
            granular_stiffness_n_m3: point.granular_stiffness,
            columns: Columns::of_numbers(&COLUMNS, [theta, depth, normal, shear, normal_linear, shear_linear]),
            warnings,
        }
    }
}

in_columns!(ProfileReply);
