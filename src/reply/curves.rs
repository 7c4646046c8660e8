//! The answers of `/v1/identify/plates` and `/v1/identify/shear`.

use std::borrow::Cow;

use serde::Serialize;
use terramechanics_identification::{Estimate, fit_plates, fit_shear_curves};
use utoipa::ToSchema;

use super::identify::{EstimateReply, implausible, words};
use super::{Column, Reply, Warning};
use crate::request::{PlatesCase, ShearTestsCase, name_of, plates_fault, shear_fault};
use terramechanics_reading::FieldFault;

/// Bekker's parameters from plate tests.
#[derive(Debug, Serialize, ToSchema)]
#[schema(as = PlatesIdentification)]
pub(crate) struct PlatesReply {
    /// Whether the data determine every parameter.
    identifiable: bool,
    /// k_c, k_phi and n0.
    estimates: Vec<EstimateReply>,
    /// Correlation of the estimates, in their order; null without degrees of freedom.
    correlation: Vec<Vec<Option<f64>>>,
    /// Points minus parameters.
    degrees_of_freedom: f64,
    /// Root of the mean squared residual of the pressure (Pa).
    rmse_pa: f64,
    /// One per plate.
    plates: Vec<PlateReply>,
    columns: PlateColumns,
    pressure_sinkage: BekkerBody,
    warnings: Vec<Warning>,
}

/// What one plate shows.
#[derive(Debug, Serialize, ToSchema)]
#[schema(as = FoundPlate)]
struct PlateReply {
    width_m: f64,
    /// k_c/b + k_phi as this plate alone shows it with the common exponent (Pa/m^n).
    modulus: f64,
    /// Exponent of this plate's curve alone; null where its sinkages are all alike.
    n0: Option<f64>,
}

/// Bekker's law, ready for a request.
#[derive(Debug, Serialize, ToSchema)]
#[schema(as = FoundBekker)]
struct BekkerBody {
    #[schema(example = "bekker")]
    law: &'static str,
    k_c: f64,
    k_phi: f64,
    n0: f64,
}

/// All curves, one after the other, as columns of one length.
#[derive(Debug, Default, Serialize, ToSchema)]
#[schema(as = FoundPlateColumns)]
struct PlateColumns {
    /// Width of the plate b (m).
    #[schema(value_type = Vec<f64>)]
    width_m: Column,
    /// Sinkage z (m).
    #[schema(value_type = Vec<f64>)]
    sinkage_m: Column,
    /// Measured pressure (Pa).
    #[schema(value_type = Vec<f64>)]
    measured_pressure_pa: Column,
    /// Predicted pressure (Pa).
    #[schema(value_type = Vec<f64>)]
    predicted_pressure_pa: Column,
    /// Predicted minus measured pressure (Pa).
    #[schema(value_type = Vec<f64>)]
    residual_pressure_pa: Column,
}

/// Strength of a soil from shear tests.
#[derive(Debug, Serialize, ToSchema)]
#[schema(as = ShearIdentification)]
pub(crate) struct ShearReply {
    /// Whether the data determine every parameter, if need be up to a bound.
    identifiable: bool,
    /// cohesion_pa, friction_angle_rad and shear_modulus_m.
    estimates: Vec<EstimateReply>,
    /// Correlation of the estimates, in their order; null with one that has no standard error.
    correlation: Vec<Vec<Option<f64>>>,
    /// Points minus parameters.
    degrees_of_freedom: f64,
    /// Root of the mean squared residual of the shear stress (Pa).
    rmse_pa: f64,
    columns: ShearColumns,
    warnings: Vec<Warning>,
}

/// All curves, one after the other, as columns of one length.
#[derive(Debug, Default, Serialize, ToSchema)]
#[schema(as = FoundShearColumns)]
struct ShearColumns {
    /// Normal stress σ (Pa).
    #[schema(value_type = Vec<f64>)]
    normal_stress_pa: Column,
    /// Shear displacement j (m).
    #[schema(value_type = Vec<f64>)]
    displacement_m: Column,
    /// Measured shear stress (Pa).
    #[schema(value_type = Vec<f64>)]
    measured_shear_stress_pa: Column,
    /// Predicted shear stress (Pa).
    #[schema(value_type = Vec<f64>)]
    predicted_shear_stress_pa: Column,
    /// Predicted minus measured shear stress (Pa).
    #[schema(value_type = Vec<f64>)]
    residual_shear_stress_pa: Column,
}

impl TryFrom<&PlatesCase> for PlatesReply {
    type Error = FieldFault;

    fn try_from(PlatesCase { curves, left_out }: &PlatesCase) -> Result<Self, FieldFault> {
        let found = fit_plates(curves).map_err(plates_fault)?;
        let [k_c, k_phi, n0] = found.estimates.each_ref().map(|estimate| estimate.value);
        let mut warnings = open(&found.estimates);
        warnings.extend(implausible(&found.estimates, n0));
        let mut warn = |code, detail: String| warnings.push(Warning::new(code, detail));
        if let Some(least_width) = found.least_width() {
            let narrowest = curves.iter().map(|curve| curve.width).fold(f64::INFINITY, f64::min);
            let detail = format!(
                "k_c is negative, which least squares may give; the law then holds for widths above {} m only, and the narrowest plate has {} m",
                words::number(least_width),
                words::number(narrowest)
            );
            warn("fitted_k_c_negative", detail);
        }
        if let Some([least, largest]) = found.exponents_apart().map(|ends| ends.map(words::number)) {
            warn(
                "exponents_differ",
                format!("the plates' own exponents run from {least} to {largest}: one exponent does not describe them"),
            );
        }
        if *left_out > 0 {
            let rows = if *left_out == 1 { "row" } else { "rows" };
            warn(
                "rows_without_sinkage",
                format!("{left_out} {rows} without sinkage: a power of it tells nothing there, left out"),
            );
        }
        if !found.is_a_soil() {
            warn("law_not_usable", "k_phi or n0 is not positive: no soil is described by such a law".to_owned());
        }
        let mut columns = PlateColumns::default();
        for (curve, plate) in curves.iter().zip(&found.plates) {
            columns.width_m.0.extend(std::iter::repeat_n(curve.width, curve.sinkage.len()));
            columns.sinkage_m.0.extend(&curve.sinkage);
            columns.measured_pressure_pa.0.extend(&curve.pressure);
            columns.predicted_pressure_pa.0.extend(&plate.predicted);
            columns.residual_pressure_pa.0.extend(plate.predicted.iter().zip(&curve.pressure).map(|(p, m)| p - m));
        }
        let plate =
            |(curve, plate): (&terramechanics_identification::PlateCurve, &terramechanics_identification::FittedPlate)| {
                PlateReply { width_m: curve.width, modulus: plate.modulus, n0: plate.own_exponent }
            };
        Ok(Self {
            identifiable: found.estimates.iter().all(|estimate| estimate.identifiability.is_determined()),
            estimates: found.estimates.iter().map(EstimateReply::from).collect(),
            correlation: found.correlation.iter().map(|row| row.to_vec()).collect(),
            degrees_of_freedom: found.degrees_of_freedom,
            rmse_pa: found.rmse,
            plates: curves.iter().zip(&found.plates).map(plate).collect(),
            columns,
            pressure_sinkage: BekkerBody { law: "bekker", k_c, k_phi, n0 },
            warnings,
        })
    }
}

impl TryFrom<&ShearTestsCase> for ShearReply {
    type Error = FieldFault;

    fn try_from(ShearTestsCase(curves): &ShearTestsCase) -> Result<Self, FieldFault> {
        let found = fit_shear_curves(curves).map_err(shear_fault)?;
        let mut columns = ShearColumns::default();
        for (curve, predicted) in curves.iter().zip(&found.predicted) {
            columns.normal_stress_pa.0.extend(std::iter::repeat_n(curve.normal, curve.shear.len()));
            columns.displacement_m.0.extend(&curve.displacement);
            columns.measured_shear_stress_pa.0.extend(&curve.shear);
            columns.predicted_shear_stress_pa.0.extend(predicted);
            columns.residual_shear_stress_pa.0.extend(predicted.iter().zip(&curve.shear).map(|(p, m)| p - m));
        }
        Ok(Self {
            identifiable: found.estimates.iter().all(|estimate| estimate.identifiability.is_determined()),
            estimates: found.estimates.iter().map(EstimateReply::from).collect(),
            correlation: found.correlation,
            degrees_of_freedom: found.degrees_of_freedom,
            rmse_pa: found.rmse,
            columns,
            warnings: open(&found.estimates).into_iter().chain(implausible(&found.estimates, f64::NAN)).collect(),
        })
    }
}

/// Warns of parameters that the data leave open or that lie at a bound.
fn open(estimates: &[Estimate]) -> Vec<Warning> {
    let mut warnings = Vec::new();
    let open: Vec<&str> = estimates
        .iter()
        .filter(|estimate| !estimate.identifiability.is_determined())
        .map(|estimate| name_of(estimate.unknown))
        .collect();
    if !open.is_empty() {
        let detail = format!("the data do not determine {}; see each one's `identifiability`", open.join(", "));
        warnings.push(Warning::new("not_identifiable", detail));
    }
    for estimate in estimates.iter().filter(|estimate| estimate.at_bound.is_some()) {
        let detail = format!("{} lies at its lower bound 0", name_of(estimate.unknown));
        warnings.push(Warning::new("at_bound", detail));
    }
    warnings
}

impl Reply for PlatesReply {
    fn columns(&self) -> Vec<(Cow<'static, str>, &[f64])> {
        let columns = &self.columns;
        vec![
            ("width_m".into(), &columns.width_m.0),
            ("sinkage_m".into(), &columns.sinkage_m.0),
            ("measured_pressure_pa".into(), &columns.measured_pressure_pa.0),
            ("predicted_pressure_pa".into(), &columns.predicted_pressure_pa.0),
            ("residual_pressure_pa".into(), &columns.residual_pressure_pa.0),
        ]
    }

    fn warnings(&self) -> &[Warning] {
        &self.warnings
    }
}

impl Reply for ShearReply {
    fn columns(&self) -> Vec<(Cow<'static, str>, &[f64])> {
        let columns = &self.columns;
        vec![
            ("normal_stress_pa".into(), &columns.normal_stress_pa.0),
            ("displacement_m".into(), &columns.displacement_m.0),
            ("measured_shear_stress_pa".into(), &columns.measured_shear_stress_pa.0),
            ("predicted_shear_stress_pa".into(), &columns.predicted_shear_stress_pa.0),
            ("residual_shear_stress_pa".into(), &columns.residual_shear_stress_pa.0),
        ]
    }

    fn warnings(&self) -> &[Warning] {
        &self.warnings
    }
}
