//! What all requests for forces have in common: a system, the stresses, a law of braking and a sinkage.

use terramechanics::{ForceModel, Method, Operation, PeakDepth, Sinkage, Wheel};
use terramechanics_reading::Reader;

use super::method::{self, BRAKING_FIELD, NORMAL_STRESS_RADIUS, PEAK_SINKAGE, takes_two_zones};
use super::system::{self, System};

/// An operation as far as it could be read.
pub(crate) struct Found {
    pub(crate) operation: Option<Operation>,
    pub(crate) wheel: Option<Wheel>,
    /// The depth under the peak that was asked for.
    pub(crate) peak_depth: Option<PeakDepth>,
}

/// The operation of a request with the groups of a system, of the stresses and of braking, with the sinkage and by the method that
/// are found in it.
pub(crate) fn read(
    object: &Reader<'_>,
    sinkage: impl FnOnce(&Reader<'_>, Option<&Wheel>) -> Option<Sinkage>,
    method: impl FnOnce(&Reader<'_>, Option<PeakDepth>) -> Option<Method>,
) -> Found {
    read_with(object, system::read(object, method::needs(object)), sinkage, method)
}

/// The same with a system that was read in another way.
pub(crate) fn read_with(
    object: &Reader<'_>,
    system: System,
    sinkage: impl FnOnce(&Reader<'_>, Option<&Wheel>) -> Option<Sinkage>,
    method: impl FnOnce(&Reader<'_>, Option<PeakDepth>) -> Option<Method>,
) -> Found {
    let wheel = system.wheel;
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
    Found { operation: operation(), wheel, peak_depth: peak_depth.flatten() }
}
