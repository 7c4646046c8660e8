//! The request of `/v1/identify/shear`.

use terramechanics_identification::{MOST_CURVES, ShearCurve, ShearError};
use terramechanics_reading::{Field, FieldFault, Number, Numbers, Object, Objects, Reader};

use crate::api::curves::{column, pair};
use crate::request::{Documented, Request};

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

fn shear_test(object: &Reader<'_>) -> Option<ShearCurve> {
    let normal = object.required(&NORMAL_STRESS);
    let columns = object.required(&SHEAR_COLUMNS)?;
    let (displacement, shear) = pair(&columns, &DISPLACEMENT, &SHEAR_STRESS)?;
    Some(ShearCurve { normal: normal?, displacement: displacement.to_vec(), shear: shear.to_vec() })
}

/// Shear tests, checked.
pub(crate) struct ShearTestsCase(pub(crate) Vec<ShearCurve>);

pub(super) type ShearTestsRequest = Documented<ShearTestsCase>;

impl Request for ShearTestsCase {
    const OBJECT: &'static Object =
        &Object { name: "ShearTestsRequest", doc: "Shear tests under two or more normal stresses.", groups: &[&[&CURVES]] };

    fn read(object: &Reader<'_>) -> Option<Self> {
        object.required(&CURVES)?.each(|object, _| shear_test(object)).map(Self)
    }
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
