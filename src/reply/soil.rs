//! A soil and a contact as a request would spell them out.

use serde::Serialize;
use terramechanics::{ContactParams, PeakRule, PressureSinkage, ShearLaw, SoilParams};
use utoipa::ToSchema;

/// A soil, ready for a request.
#[derive(Debug, Serialize, ToSchema)]
#[schema(as = FoundSoil)]
pub(super) struct SoilBody {
    /// Cohesion c (Pa).
    cohesion_pa: f64,
    /// Internal friction angle φ (rad).
    friction_angle_rad: f64,
    /// Shear deformation modulus K (m), where the shear law has it.
    #[serde(skip_serializing_if = "Option::is_none")]
    #[schema(nullable = false)]
    shear_modulus_m: Option<f64>,
    /// Pressure–sinkage law, where it is known.
    #[serde(skip_serializing_if = "Option::is_none")]
    #[schema(nullable = false)]
    pressure_sinkage: Option<LawBody>,
    /// Shear law, where it is another than Janosi–Hanamoto's.
    #[serde(skip_serializing_if = "Option::is_none")]
    #[schema(nullable = false)]
    shear: Option<ShearBody>,
    /// Shear deformation modulus K_y across the direction of travel (m), where it is known.
    #[serde(skip_serializing_if = "Option::is_none")]
    #[schema(nullable = false)]
    lateral_shear_modulus_m: Option<f64>,
    /// Unit weight γ (N/m³), where it is known.
    #[serde(skip_serializing_if = "Option::is_none")]
    #[schema(nullable = false)]
    unit_weight_n_m3: Option<f64>,
}

/// A pressure–sinkage law, ready for a request.
#[derive(Debug, Serialize, ToSchema)]
#[serde(tag = "law", rename_all = "snake_case")]
#[schema(as = FoundLaw)]
enum LawBody {
    /// Bekker's.
    #[schema(title = "FoundLaw bekker")]
    Bekker {
        k_c: f64,
        k_phi: f64,
        n0: f64,
        n1: f64,
        #[serde(skip_serializing_if = "Option::is_none")]
        #[schema(nullable = false)]
        n2: Option<f64>,
    },
    /// A modulus as it is.
    #[schema(title = "FoundLaw direct")]
    Direct {
        k_s: f64,
        n0: f64,
        n1: f64,
        #[serde(skip_serializing_if = "Option::is_none")]
        #[schema(nullable = false)]
        n2: Option<f64>,
    },
    /// Reece's.
    #[schema(title = "FoundLaw reece")]
    Reece {
        k_c: f64,
        k_phi: f64,
        unit_weight_n_m3: f64,
        n0: f64,
        n1: f64,
        #[serde(skip_serializing_if = "Option::is_none")]
        #[schema(nullable = false)]
        n2: Option<f64>,
    },
    /// Meirion-Griffith & Spenko's.
    #[schema(title = "FoundLaw diameter")]
    Diameter {
        k: f64,
        m: f64,
        n0: f64,
        n1: f64,
        #[serde(skip_serializing_if = "Option::is_none")]
        #[schema(nullable = false)]
        n2: Option<f64>,
    },
}

/// A shear law, ready for a request.
#[derive(Debug, Serialize, ToSchema)]
#[serde(tag = "law", rename_all = "snake_case")]
#[schema(as = FoundShear)]
enum ShearBody {
    /// Over a hump to a residual.
    #[schema(title = "FoundShear wong_residual")]
    WongResidual { residual_ratio: f64, peak_displacement_m: f64 },
    /// Over a peak to nothing.
    #[schema(title = "FoundShear wong_peak")]
    WongPeak { peak_displacement_m: f64 },
}

/// A contact, ready for a request.
#[derive(Debug, Serialize, ToSchema)]
#[serde(tag = "rule", rename_all = "snake_case")]
#[schema(as = FoundContact)]
pub(super) enum ContactBody {
    /// θm = (θ1 + θ2)/2.
    #[schema(title = "FoundContact midpoint")]
    Midpoint { c3: f64 },
    /// θm = (c1 + c2 s) θ1.
    #[schema(title = "FoundContact wong_reece")]
    WongReece { c1: f64, c2: f64, c3: f64 },
    /// θm = arccos(1 − z/(2r)).
    #[schema(title = "FoundContact half_sinkage")]
    HalfSinkage { c3: f64 },
}

impl From<&SoilParams> for SoilBody {
    fn from(soil: &SoilParams) -> Self {
        let pressure_sinkage = soil.pressure_sinkage.as_ref().map(LawBody::from);
        let (shear_modulus_m, shear) = match soil.shear {
            None => (None, None),
            Some(ShearLaw::JanosiHanamoto(law)) => (Some(law.modulus), None),
            Some(ShearLaw::WongResidual(law)) => {
                let (residual_ratio, peak_displacement_m) = (law.residual_ratio, law.peak_displacement);
                (None, Some(ShearBody::WongResidual { residual_ratio, peak_displacement_m }))
            }
            Some(ShearLaw::WongPeak(law)) => (None, Some(ShearBody::WongPeak { peak_displacement_m: law.peak_displacement })),
        };
        let (cohesion_pa, friction_angle_rad) = (soil.cohesion, soil.friction_angle);
        let (lateral_shear_modulus_m, unit_weight_n_m3) = (soil.lateral_shear_modulus, soil.unit_weight);
        Self {
            cohesion_pa,
            friction_angle_rad,
            shear_modulus_m,
            pressure_sinkage,
            shear,
            lateral_shear_modulus_m,
            unit_weight_n_m3,
        }
    }
}

impl From<&PressureSinkage> for LawBody {
    fn from(law: &PressureSinkage) -> Self {
        let exponent = law.exponent();
        let (n0, n1, n2) = (exponent.base, exponent.slip_gain, exponent.skid_gain);
        match law {
            PressureSinkage::Bekker(law) => Self::Bekker { k_c: law.k_c, k_phi: law.k_phi, n0, n1, n2 },
            PressureSinkage::Direct(law) => Self::Direct { k_s: law.k_s, n0, n1, n2 },
            PressureSinkage::Reece(law) => {
                Self::Reece { k_c: law.k_c, k_phi: law.k_phi, unit_weight_n_m3: law.unit_weight, n0, n1, n2 }
            }
            PressureSinkage::Diameter(law) => Self::Diameter { k: law.k, m: law.m, n0, n1, n2 },
        }
    }
}

impl From<&ContactParams> for ContactBody {
    fn from(contact: &ContactParams) -> Self {
        let c3 = contact.exit_ratio;
        match contact.rule {
            PeakRule::Midpoint => Self::Midpoint { c3 },
            PeakRule::WongReece(rule) => Self::WongReece { c1: rule.c1, c2: rule.c2, c3 },
            PeakRule::HalfSinkage => Self::HalfSinkage { c3 },
        }
    }
}
