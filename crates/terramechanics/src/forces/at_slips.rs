//! The forces of one contact at many slips: places and depths once, the normal stress where it changes, the shear stress for each.

use super::panels::{Resolved, TOLERANCE};
use super::quadrature::{OneZone, forces_of};
use super::shearing::{Rim, Shearing, log_share};
use super::{ForceModel, Forces};
use crate::contact::AngleRates;
use crate::numerics::gauss_legendre::FINE;
use crate::numerics::level::level;
use crate::patch::ContactPatch;
use crate::pressure_sinkage::PressureCurve;
use crate::stress::StressField;
use fearless_simd::{Simd, dispatch};

/// The forces by quadrature in contacts of one zone that differ in the slip alone; none where one panel does not resolve the stresses,
/// or where there are no such contacts.
pub(crate) fn forces_at_slips(model: &ForceModel, patches: &[Option<ContactPatch<'_>>], found: &mut [Option<Forces>]) {
    dispatch!(level(), simd => in_lanes(simd, model, patches, found));
}

#[inline(always)]
fn in_lanes<L: Simd>(simd: L, model: &ForceModel, patches: &[Option<ContactPatch<'_>>], found: &mut [Option<Forces>]) {
    found.fill(None);
    let Some(first) = patches.iter().flatten().next() else { return };
    let Ok(stresses) = first.stresses() else { return };
    let contact = Rim::of(&stresses);
    let mut spots = contact.spots(simd, &FINE, [0.0, 1.0]);
    let mut logs = [spots[0].normal; FINE.len()];
    for (log, spot) in logs.iter_mut().zip(&spots) {
        *log = log_share(first.geometric_depth(&spot.front), first.sinkage); // Eqs. (3), (4)
    }
    let mut pressed: Option<PressureCurve> = None;
    for (patch, found) in patches.iter().zip(found) {
        let Some(patch) = patch else { continue };
        let Ok(StressField { curve, .. }) = patch.stresses() else { continue };
        let (rim, shearing) = (Rim { patch, curve, ..contact }, OneZone(patch));
        if !shearing.edges(&rim).are_of_one_panel() {
            continue;
        }
        if pressed != Some(*curve) {
            let deepest = curve.pressure(patch.sinkage);
            for (log, spot) in logs.iter().zip(&mut spots) {
                spot.normal = curve.pressures_by(*log, deepest);
            }
            pressed = Some(*curve);
        }
        let (sums, _) = rim.sums_over::<_, _, _, false>(simd, &FINE, &mut spots, &shearing, &AngleRates::FIXED);
        let error = sums.relative_error();
        if error <= TOLERANCE {
            *found = Some(forces_of(model, patch, &sums.integrals, error));
        }
    }
}
