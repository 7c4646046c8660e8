//! The requests of `/v1/identify/plates` and `/v1/identify/shear`: lists of curves.

use terramechanics_identification::{MOST_CURVES, MOST_PLATES, PlateCurve, PlatesError, ShearCurve, ShearError};
use terramechanics_reading::{Field, FieldFault, Number, Numbers, Object, Objects, Reader};

use super::Request;

/// Numbers that a column has at most.
const MOST: usize = 10_001;

const fn column(name: &'static str, meaning: &'static str, number: Number) -> Field<Numbers> {
    Field::required(name, meaning, Numbers::new(number, 1, MOST))
}

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

const DISPLACEMENT: Field<Numbers> = column("displacement_m", "Shear displacement j (m).", Number::new("m", 0.0, 100.0));
const SHEAR_STRESS: Field<Numbers> = column("shear_stress_pa", "Shear stress τ (Pa).", Number::new("Pa", -1e12, 1e12));
const SHEAR_CURVE: Object = Object {
    name: "ShearColumns",
    doc: "Shear stress over displacement, as columns of one length.",
    groups: &[&[&DISPLACEMENT, &SHEAR_STRESS]],
};
const NORMAL_STRESS: Field<Number> = Field::required("normal_stress_pa", "Normal stress σ (Pa).", Number::new("Pa", 0.0, 1e12));
const SHEAR_COLUMNS: Field<&Object> = Field::required("columns", "The measured curve.", &SHEAR_CURVE);
const SHEAR_TEST: Object =
    Object { name: "ShearCurve", doc: "A shear test under one normal stress.", groups: &[&[&NORMAL_STRESS, &SHEAR_COLUMNS]] };
const CURVES: Field<Objects> = Field::required(
    "curves",
    "The tests, under at least two normal stresses.",
    Objects { object: &SHEAR_TEST, fewest: 2, most: MOST_CURVES },
);

/// Two columns of one length.
fn pair<'r>(columns: &'r Reader<'_>, first: &Field<Numbers>, second: &Field<Numbers>) -> Option<(&'r [f64], &'r [f64])> {
    let (values, others) = (columns.required(first), columns.required(second));
    let (values, others) = (values?, others?);
    if values.len() != others.len() {
        let (found, expected) = (others.len(), values.len());
        columns.place_of(second).fault(format_args!("has {found} values where `{}` has {expected}", first.name));
        return None;
    }
    Some((values, others))
}

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

fn shear_test(object: &Reader<'_>) -> Option<ShearCurve> {
    let normal = object.required(&NORMAL_STRESS);
    let columns = object.required(&SHEAR_COLUMNS)?;
    let (displacement, shear) = pair(&columns, &DISPLACEMENT, &SHEAR_STRESS)?;
    Some(ShearCurve { normal: normal?, displacement: displacement.to_vec(), shear: shear.to_vec() })
}

/// Plate tests, checked.
pub(crate) struct PlatesCase {
    pub(crate) curves: Vec<PlateCurve>,
    /// Rows without sinkage.
    pub(crate) left_out: usize,
}

/// Shear tests, checked.
pub(crate) struct ShearTestsCase(pub(crate) Vec<ShearCurve>);

impl Request for PlatesCase {
    const OBJECT: &'static Object =
        &Object { name: "PlatesRequest", doc: "Curves of two or more plates of different width.", groups: &[&[&PLATES]] };

    fn read(object: &Reader<'_>) -> Option<Self> {
        let plates = object.required(&PLATES)?.each(|object, _| plate(object))?;
        let left_out = plates.iter().map(|(_, left_out)| left_out).sum();
        Some(Self { curves: plates.into_iter().map(|(curve, _)| curve).collect(), left_out })
    }
}

impl Request for ShearTestsCase {
    const OBJECT: &'static Object =
        &Object { name: "ShearTestsRequest", doc: "Shear tests under two or more normal stresses.", groups: &[&[&CURVES]] };

    fn read(object: &Reader<'_>) -> Option<Self> {
        object.required(&CURVES)?.each(|object, _| shear_test(object)).map(Self)
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

/// What shear tests whose fields are each right do not tell.
pub(crate) fn shear_fault(error: ShearError) -> FieldFault {
    let pointer = match error {
        ShearError::Curve(curve) => format!("/curves/{curve}"),
        ShearError::Count
        | ShearError::OneStress
        | ShearError::NoShear
        | ShearError::Displacements
        | ShearError::Stresses
        | ShearError::NotFinite
        | ShearError::Stopped => "/curves".to_owned(),
    };
    FieldFault::new(pointer, error)
}
