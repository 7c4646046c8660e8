//! Measured and predicted columns side by side.

use terramechanics_identification::{FittedColumn, Observations, Quantity};

use crate::quantity::{About, Columns, Field, Shape, Values};

/// Columns of a fit.
#[derive(Debug)]
pub(super) struct OfFit;

pub(super) type IdentifyColumns = Columns<OfFit>;

static SLIP: About = About::new("slip", "s", "1", "slip ratio");
static SINKAGE: About = About::new("sinkage_m", "z", "m", "sinkage at which the forces are predicted");

/// What there is of a fitted quantity: measured, predicted, and predicted minus measured.
macro_rules! three {
    ($name:literal, $symbol:literal, $unit:literal, $what:literal) => {
        [
            About::new(concat!("measured_", $name), $symbol, $unit, concat!("measured ", $what)),
            About::new(concat!("predicted_", $name), $symbol, $unit, concat!("predicted ", $what)),
            About::new(concat!("residual_", $name), "", $unit, concat!("predicted minus measured ", $what)),
        ]
    };
}

/// The quantities that can be fitted, in the order of their columns.
static FITTED: [(Quantity, [About; 3]); 4] = [
    (Quantity::Sinkage, three!("sinkage_m", "z", "m", "sinkage")),
    (Quantity::Longitudinal, three!("longitudinal_force_n", "F_x", "N", "longitudinal force")),
    (Quantity::Normal, three!("normal_force_n", "F_z", "N", "normal force")),
    (Quantity::Torque, three!("torque_n_m", "T", "N.m", "torque")),
];

impl Shape for OfFit {
    const NAME: &'static str = "IdentifyColumns";
    const DOC: &'static str = "Columns of one length: what was measured, what the model predicts with the estimates, and predicted \
                               minus measured; only for the quantities that were fitted.";

    fn fields() -> Vec<Field> {
        let fitted = FITTED.iter().flat_map(|(_, three)| three);
        let fitted = fitted.map(|about| Field { present: Some("where it was fitted"), ..Field::always(about) });
        [&SLIP, &SINKAGE].map(Field::always).into_iter().chain(fitted).collect()
    }
}

/// The columns of `observations` with what was fitted.
pub(super) fn columns(observations: &Observations, sinkage: Vec<f64>, fitted: &[FittedColumn]) -> IdentifyColumns {
    let slip = observations.slip.iter().map(|slip| slip.ratio()).collect();
    let mut list = vec![(&SLIP, Values::Numbers(slip)), (&SINKAGE, Values::Numbers(sinkage))];
    for (quantity, three) in &FITTED {
        for column in fitted.iter().filter(|column| column.quantity == *quantity) {
            let residual = column.predicted.iter().zip(&column.measured).map(|(predicted, measured)| predicted - measured);
            let values = [column.measured.clone(), column.predicted.clone(), residual.collect()];
            list.extend(three.iter().zip(values.map(Values::Numbers)));
        }
    }
    Columns::new(list)
}
