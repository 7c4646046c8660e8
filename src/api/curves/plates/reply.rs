//! The answer of `/v1/identify/plates`.

use serde::Serialize;
use terramechanics_identification::{FittedPlate, PlateCurve, PlatesFit};
use utoipa::ToSchema;

use super::found::FoundPlates;
use crate::api::curves::{Curve, one_after_the_other};
use crate::quantity::{About, Columns, Field, Shape};
use crate::reply::soil::{self, Spelled};
use crate::reply::{EstimateReply, in_columns};
use crate::request::system::PressureSinkageObject;
use crate::warning::Warning;

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
    /// The law, ready for a request; absent where its parameters are beyond what a request takes.
    #[serde(skip_serializing_if = "Option::is_none")]
    #[schema(value_type = Option<PressureSinkageObject>, nullable = false)]
    pressure_sinkage: Option<Spelled>,
    warnings: Vec<Warning>,
}

/// The results of one plate.
#[derive(Debug, Serialize, ToSchema)]
#[schema(as = FoundPlate)]
struct PlateReply {
    width_m: f64,
    /// k_c/b + k_phi from this plate alone, with the common exponent (Pa/m^n).
    modulus: f64,
    /// Exponent of this plate's curve alone; null where all its sinkages are equal.
    n0: Option<f64>,
}

/// Columns of plate tests.
#[derive(Debug)]
struct OfPlates;

type PlateColumns = Columns<OfPlates>;

static PLATE_COLUMNS: [About; 5] = [
    About::new("width_m", "b", "m", "width of the plate"),
    About::new("sinkage_m", "z", "m", "sinkage"),
    About::new("measured_pressure_pa", "p", "Pa", "measured pressure"),
    About::new("predicted_pressure_pa", "p", "Pa", "predicted pressure"),
    About::new("residual_pressure_pa", "", "Pa", "predicted minus measured pressure"),
];

impl Shape for OfPlates {
    const NAME: &'static str = "FoundPlateColumns";
    const DOC: &'static str = "All curves, one after the other, as columns of one length.";

    fn fields() -> Vec<Field> {
        PLATE_COLUMNS.iter().map(Field::always).collect()
    }
}

impl From<FoundPlates> for PlatesReply {
    fn from(FoundPlates { curves, fitted, warnings }: FoundPlates) -> Self {
        let PlatesFit { estimates, correlation, degrees_of_freedom, rmse, plates } = fitted;
        let [k_c, k_phi, n0] = estimates.each_ref().map(|estimate| estimate.value);
        let pairs: Vec<(&PlateCurve, &FittedPlate)> = curves.iter().zip(&plates).collect();
        let columns = one_after_the_other(pairs.iter().map(|(curve, plate)| Curve {
            held: curve.width,
            set: &curve.sinkage,
            measured: &curve.pressure,
            predicted: &plate.predicted,
        }));
        let plate = |(curve, plate): &(&PlateCurve, &FittedPlate)| PlateReply {
            width_m: curve.width,
            modulus: plate.modulus,
            n0: plate.own_exponent,
        };
        Self {
            identifiable: estimates.iter().all(|estimate| estimate.identifiability.is_determined()),
            estimates: estimates.iter().map(EstimateReply::from).collect(),
            correlation: correlation.iter().map(|row| row.to_vec()).collect(),
            degrees_of_freedom,
            rmse_pa: rmse,
            plates: pairs.iter().map(plate).collect(),
            columns: Columns::of_numbers(&PLATE_COLUMNS, columns),
            pressure_sinkage: soil::bekker(k_c, k_phi, n0),
            warnings,
        }
    }
}

in_columns!(PlatesReply);
