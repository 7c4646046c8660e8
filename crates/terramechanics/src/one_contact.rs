//! Operating points of one contact at many slips, by quadrature.

use crate::forces::{ForceModel, Method, forces_at_slips};
use crate::operating_point::{NormalStressFrom, OperatingPoint, Sinkage};
use crate::patch::ContactPatch;
use crate::rolling::WheelOnSoil;
use crate::slip::Slip;

/// Points that are found in one go.
pub(crate) const AT_ONCE: usize = 32;

/// A contact that is the same at any slip, and the way to its forces.
pub(crate) struct OneContact<'a> {
    system: &'a WheelOnSoil,
    model: &'a ForceModel,
    sinkage: f64,
}

impl<'a> OneContact<'a> {
    /// None for another method than quadrature, and where the contact changes with slip.
    pub(crate) fn of(system: &'a WheelOnSoil, model: &'a ForceModel, sinkage: &Sinkage) -> Option<Self> {
        match *sinkage {
            Sinkage::Given(sinkage) if model.method == Method::Quadrature && !system.contact.peak_moves_with_slip() => {
                Some(Self { system, model, sinkage })
            }
            _ => None,
        }
    }

    /// The points at up to [`AT_ONCE`] `slips`, each handed to `take` with its place; those that are not found here are none.
    pub(crate) fn find(&self, slips: &[Slip], mut take: impl FnMut(usize, Option<OperatingPoint>)) {
        let mut rolling = [const { None }; AT_ONCE];
        for (rolling, &slip) in rolling.iter_mut().zip(slips) {
            *rolling = self.system.rolling(slip).ok().filter(|rolling| rolling.reversal.is_none());
        }
        let rolling = &rolling[..slips.len()];
        let mut patches = [const { None }; AT_ONCE];
        let mut first: Option<ContactPatch<'_>> = None;
        for (patch, rolling) in patches.iter_mut().zip(rolling) {
            let Some(rolling) = rolling else { continue };
            *patch = match &first {
                Some(first) => Some(rolling.same_contact(first)),
                None => rolling.contact(self.sinkage).ok(),
            };
            first = first.or(*patch);
        }
        let mut found = [const { None }; AT_ONCE];
        forces_at_slips(self.model, &patches[..slips.len()], &mut found[..slips.len()]);
        for (i, &slip) in slips.iter().enumerate() {
            let point = match (&patches[i], found[i]) {
                (Some(patch), Some(forces)) if forces.is_finite() => Some(OperatingPoint {
                    slip,
                    sinkage: patch.sinkage,
                    angles: patch.angles,
                    curve: patch.rolling.curve().ok().copied(),
                    granular_stiffness: None,
                    normal_stress_from: NormalStressFrom::Soil,
                    forces,
                }),
                _ => None,
            };
            take(i, point);
        }
    }
}
