//! What all requests for forces have in common: a system, the stresses, a law of braking and a sinkage.

use terramechanics::{Circles, ForceModel, Method, Operation, PeakDepth, Sinkage, Wheel};
use terramechanics_reading::Reader;

use super::method::{self, BRAKING_FIELD, NORMAL_STRESS_RADIUS, PEAK_SINKAGE, takes_two_zones};
use super::sinkage::is_under_load;
use super::soil::{FoundSoil, Needs};
use super::system::{self, SOIL, System};

/// An operation as far as it could be read.
pub(crate) struct Found {
    pub(crate) operation: Option<Operation>,
    pub(crate) wheel: Option<Wheel>,
    pub(crate) soil: Option<FoundSoil>,
    pub(crate) circles: Option<Circles>,
    pub(crate) method: Option<Method>,
    /// The depth under the peak that was asked for.
    pub(crate) peak_depth: Option<PeakDepth>,
}

/// What a request needs of its soil before the method is read: where the load is known beside the sinkage, a closed form needs no
/// pressure–sinkage law.
pub(crate) fn needs(object: &Reader<'_>) -> Needs<'static> {
    beside_load(object, method::needs(object))
}

/// The same of what the methods of a request need.
pub(crate) fn beside_load(object: &Reader<'_>, needs: Needs<'static>) -> Needs<'static> {
    let is_open = !is_under_load(object);
    Needs {
        pressure_sinkage: needs.pressure_sinkage && is_open,
        // The quadrature still needs the exponent of a law, so one is assumed where that is allowed.
        perhaps_pressure_sinkage: needs.pressure_sinkage && !is_open,
        granular_stiffness: needs.granular_stiffness && is_open,
        ..needs
    }
}

/// Reports that the soil lacks the pressure–sinkage law that the method needs; false where it did.
pub(crate) fn has_its_law(object: &Reader<'_>, method: &Method, soil: &FoundSoil) -> bool {
    let enough = if is_under_load(object) { "; `{\"n0\": …}` is enough, because the load is known" } else { "" };
    method.is_closed_form() || *method == Method::ResistiveForce || soil.has_law(&object.place_of(&SOIL), enough)
}

/// The operation of a request with the groups of a system, of the stresses and of braking, with the sinkage and by the method that
/// are found in it.
pub(crate) fn read(
    object: &Reader<'_>,
    sinkage: impl FnOnce(&Reader<'_>, Option<&Wheel>) -> Option<Sinkage>,
    method: impl FnOnce(&Reader<'_>, Option<PeakDepth>) -> Option<Method>,
) -> Found {
    let found = read_with(object, system::read(object, needs(object)), sinkage, method);
    let has_law = match (&found.method, &found.soil) {
        (Some(method), Some(soil)) => has_its_law(object, method, soil),
        _ => true,
    };
    Found { operation: found.operation.filter(|_| has_law), ..found }
}

/// The same with a system that was read in another way, and whether or not its soil has the law that the method needs.
pub(crate) fn read_with(
    object: &Reader<'_>,
    system: System,
    sinkage: impl FnOnce(&Reader<'_>, Option<&Wheel>) -> Option<Sinkage>,
    method: impl FnOnce(&Reader<'_>, Option<PeakDepth>) -> Option<Method>,
) -> Found {
    let System { wheel, soil, circles, .. } = system;
    let braking = object.or_default(&BRAKING_FIELD);
    let sinkage = sinkage(object, wheel.as_ref());
    let peak_depth = object.optional(&PEAK_SINKAGE);
    let normal_stress_radius = object.or_default(&NORMAL_STRESS_RADIUS);
    let method = method(object, peak_depth.flatten());
    let operation = || {
        let model = ForceModel { method: method?, normal_stress_radius: normal_stress_radius? };
        let contact = system.contact?.with_braking(braking?);
        peak_depth?;
        if !takes_two_zones(object, model.method, &contact) {
            return None;
        }
        Some(Operation { system: system.whole(braking?)?, model, sinkage: sinkage? })
    };
    Found { operation: operation(), wheel, soil, circles, method, peak_depth: peak_depth.flatten() }
}
