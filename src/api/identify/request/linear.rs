//! What the linear estimator needs, and what it cannot take.

use terramechanics::ShearLaw;
use terramechanics_identification::{Quantity, Unknown};
use terramechanics_reading::{Declared, Field, Kind, Reader, Scope};

use super::data::{DATA, NORMAL, STANDARD_DEVIATION};
use super::{FIT, LOSS, LinearCase, PARTIAL_SOIL, STARTS, column_name};
use crate::request::method::{LAMBDA_A, LAMBDA_B, METHOD_FIELD, MethodName, PEAK_SINKAGE};
use crate::request::soil::SHEAR;
use crate::request::unknowns::{BOUNDS_FIELD, START};

/// Whether the linear estimator can do it; what stands in its way is reported.
pub(super) fn check(object: &Reader<'_>, fitted: &[Unknown], case: &LinearCase) -> bool {
    let LinearCase { setup, observations, .. } = case;
    let mut is_sound = true;
    let mut report = |place: Scope<'_>, detail: &str| {
        place.fault(detail);
        is_sound = false;
    };
    if !(fitted.len() == 2 && fitted.contains(&Unknown::COHESION) && fitted.contains(&Unknown::FRICTION_ANGLE)) {
        report(object.place_of(&FIT), "the linear estimator finds `cohesion_pa` and `friction_angle_rad`, both and no other");
    }
    let data = object.place_of(&DATA);
    for quantity in [Quantity::Sinkage, Quantity::Normal, Quantity::Torque] {
        if observations.column(quantity).is_none() {
            report(data.field(column_name(quantity)), "the linear estimator needs it");
        }
    }
    if let Some(loads) = observations.column(Quantity::Normal)
        && let Some(row) = loads.values.iter().position(|&load| load <= 0.0)
    {
        let place = data.field(NORMAL.name).item(row);
        report(place, "is not greater than 0: the linear estimator takes it as the load");
    }
    if object.optional(&METHOD_FIELD).flatten().is_some_and(|method| method != MethodName::Linearised) {
        let detail = "has no meaning for the linear estimator, whose stresses are those of `linearised`";
        report(object.place_of(&METHOD_FIELD), detail);
    }
    let idle = [
        idle(object, &START),
        idle(object, &BOUNDS_FIELD),
        idle(object, &STARTS),
        idle(object, &LOSS),
        idle(object, &PEAK_SINKAGE),
        idle(object, &LAMBDA_A),
        idle(object, &LAMBDA_B),
        idle(object, &STANDARD_DEVIATION),
    ];
    for name in idle.into_iter().flatten() {
        report(object.place().field(name), "has no meaning for the linear estimator");
    }
    if !matches!(setup.soil.shear, Some(ShearLaw::JanosiHanamoto(_))) {
        let soil = object.place_of(&PARTIAL_SOIL);
        report(soil.field(SHEAR.name), "the linear estimator needs janosi_hanamoto");
    }
    is_sound
}

/// The name of a field that was sent.
fn idle<K: Kind>(object: &Reader<'_>, field: &Field<K>) -> Option<&'static str> {
    object.has(field).then(|| field.name())
}
