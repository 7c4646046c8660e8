//! The request of `/v1/identify/plates`.

use terramechanics_identification::{MOST_PLATES, PlateCurve, PlatesError};
use terramechanics_reading::{Field, FieldFault, Number, Numbers, Object, Objects, Reader};

use crate::api::curves::{column, pair};
use crate::request::{Documented, Request};

const SINKAGE: Field<Numbers> = column("sinkage_m", "Sinkage z (m).", Number::new("m", 0.0, 100.0));
const PRESSURE: Field<Numbers> = column("pressure_pa", "Pressure p (Pa).", Number::new("Pa", 0.0, 1e12));
const PLATE_CURVE: Object = Object {
    name: "PlateColumns",
    doc: "Pressure over sinkage, as columns of one length. Rows at zero sinkage are left out, because the law says nothing about the moduli there; at least one other row needs a pressure above 0.",
    groups: &[&[&SINKAGE, &PRESSURE]],
};
const WIDTH: Field<Number> =
    Field::required("width_m", "Smaller side, or radius of a round plate, b (m).", Number::new("m", 1e-3, 100.0));
const PLATE_COLUMNS: Field<&Object> = Field::required("columns", "The measured curve.", &PLATE_CURVE);
const PLATE: Object =
    Object { name: "Plate", doc: "A plate and what was measured under it.", groups: &[&[&WIDTH, &PLATE_COLUMNS]] };
const PLATES: Field<Objects> =
    Field::required("plates", "The plates, of at least two widths.", Objects { object: &PLATE, fewest: 2, most: MOST_PLATES });

/// The curve of a plate, and how many rows without sinkage were left out of it.
fn plate(object: &Reader<'_>) -> Option<(PlateCurve, usize)> {
    let width = object.required(&WIDTH);
    let columns = object.required(&PLATE_COLUMNS)?;
    let (all, pressure) = pair(&columns, &SINKAGE, &PRESSURE)?;
    let rows = all.iter().copied().zip(pressure.iter().copied());
    let (sinkage, pressure): (Vec<f64>, Vec<f64>) = rows.filter(|(z, _)| *z > 0.0).unzip();
    if sinkage.is_empty() {
        columns.place_of(&SINKAGE).fault("has no value greater than 0");
        return None;
    }
    let left_out = all.len() - sinkage.len();
    Some((PlateCurve { width: width?, sinkage, pressure }, left_out))
}

/// Plate tests, checked.
pub(crate) struct PlatesCase {
    pub(crate) curves: Vec<PlateCurve>,
    /// Rows without sinkage.
    pub(crate) left_out: usize,
}

pub(super) type PlatesRequest = Documented<PlatesCase>;

impl Request for PlatesCase {
    const OBJECT: &'static Object =
        &Object { name: "PlatesRequest", doc: "Curves of two or more plates of different width.", groups: &[&[&PLATES]] };

    fn read(object: &Reader<'_>) -> Option<Self> {
        let plates = object.required(&PLATES)?.each(|object, _| plate(object))?;
        let left_out = plates.iter().map(|(_, left_out)| left_out).sum();
        Some(Self { curves: plates.into_iter().map(|(curve, _)| curve).collect(), left_out })
    }
}

/// What plate tests whose fields are each right do not tell.
pub(crate) fn plates_fault(error: PlatesError) -> FieldFault {
    let pointer = match error {
        PlatesError::Curve(plate) | PlatesError::Size(plate) => format!("/plates/{plate}"),
        PlatesError::Count | PlatesError::OneWidth | PlatesError::OneSinkage | PlatesError::NotFinite | PlatesError::Stopped => {
            "/plates".to_owned()
        }
    };
    FieldFault::new(pointer, error)
}
