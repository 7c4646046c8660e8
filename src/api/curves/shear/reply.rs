//! The answer of `/v1/identify/shear`.

use serde::Serialize;
use terramechanics_identification::ShearFit;
use utoipa::ToSchema;

use super::found::FoundShear;
use crate::api::curves::{Curve, one_after_the_other};
use crate::quantity::{About, Columns, Field, Shape};
use crate::reply::{EstimateReply, in_columns};
use crate::warning::Warning;

/// Strength of a soil from shear tests.
#[derive(Debug, Serialize, ToSchema)]
#[schema(as = ShearIdentification)]
pub(crate) struct ShearReply {
    /// Whether the data determine every parameter, if need be up to a bound.
    identifiable: bool,
    /// cohesion_pa, friction_angle_rad and shear_modulus_m.
    estimates: Vec<EstimateReply>,
    /// Correlation of the estimates, in their order; null for an estimate without a standard error.
    correlation: Vec<Vec<Option<f64>>>,
    /// Points minus parameters.
    degrees_of_freedom: f64,
    /// Root of the mean squared residual of the shear stress (Pa).
    rmse_pa: f64,
    columns: ShearColumns,
    warnings: Vec<Warning>,
}

/// Columns of shear tests.
#[derive(Debug)]
struct OfShearTests;

type ShearColumns = Columns<OfShearTests>;

static SHEAR_COLUMNS: [About; 5] = [
    About::new("normal_stress_pa", "σ", "Pa", "normal stress"),
    About::new("displacement_m", "j", "m", "shear displacement"),
    About::new("measured_shear_stress_pa", "τ", "Pa", "measured shear stress"),
    About::new("predicted_shear_stress_pa", "τ", "Pa", "predicted shear stress"),
    About::new("residual_shear_stress_pa", "", "Pa", "predicted minus measured shear stress"),
];

impl Shape for OfShearTests {
    const NAME: &'static str = "FoundShearColumns";
    const DOC: &'static str = "All curves, one after the other, as columns of one length.";

    fn fields() -> Vec<Field> {
        SHEAR_COLUMNS.iter().map(Field::always).collect()
    }
}

impl From<FoundShear> for ShearReply {
    fn from(FoundShear { curves, fitted, warnings }: FoundShear) -> Self {
        let ShearFit { estimates, correlation, degrees_of_freedom, rmse, predicted } = fitted;
        let columns = one_after_the_other(curves.iter().zip(&predicted).map(|(curve, predicted)| Curve {
            held: curve.normal,
            set: &curve.displacement,
            measured: &curve.shear,
            predicted,
        }));
        Self {
            identifiable: estimates.iter().all(|estimate| estimate.identifiability.is_determined()),
            estimates: estimates.iter().map(EstimateReply::from).collect(),
            correlation,
            degrees_of_freedom,
            rmse_pa: rmse,
            columns: Columns::of_numbers(&SHEAR_COLUMNS, columns),
            warnings,
        }
    }
}

in_columns!(ShearReply);
