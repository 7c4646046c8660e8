//! Forces on a wheel in the rut of another one: the same integrals, under another pressure over depth (Wong, Theory of Ground Vehicles, source 19).
//!
//! A wheel that went before has pressed the soil down to z_u, where its pressure was p_u. The soil has come back to z_r = z_u − p_u/k_u,
//! which is the surface for the next wheel. Under that wheel the pressure is
//!
//! p = p_u − k_u (z_u − z) = k_u (z − z_r) for z_r ≤ z ≤ z_u, and the soil's own K_s z^N beyond z_u,
//!
//! with z counted from the undisturbed surface. Both agree at z_u.

use super::panels::Edges;
use super::quadrature::{self, OneZone};
use super::shearing::{Pressing, Rim, Shearing};
use super::{ForceModel, Forces};
use crate::contact::angle_at_depth;
use crate::error::Error;
use crate::numerics::elementary::Number;
use crate::patch::ContactPatch;
use crate::pressure_sinkage::PressureCurve;
use crate::rim::RimPoint;

/// Pressure over depth below the floor of a rut.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct RutCurve {
    /// Depth z_r of the floor (m) below the undisturbed surface.
    pub(crate) floor: f64,
    /// Depth z_u − z_r (m) below the floor up to which the soil has been pressed before.
    pub(crate) rebound: f64,
    /// k_u (N/m³).
    pub(crate) stiffness: f64,
    /// The soil's own curve.
    pub(crate) curve: PressureCurve,
}

impl Pressing for RutCurve {
    fn pressure(&self, depth: f64) -> f64 {
        if depth <= self.rebound { self.stiffness * depth } else { self.curve.pressure(self.floor + depth) }
    }
}

/// One zone, with an end of a panel where the pressure has its kink.
struct InRut<'a>(OneZone<'a>);

impl Shearing<RutCurve> for InRut<'_> {
    #[inline(always)]
    fn ahead<F: Number>(&self, point: &RimPoint<F>) -> F {
        Shearing::<RutCurve>::ahead(&self.0, point)
    }

    #[inline(always)]
    fn behind<F: Number>(&self, point: &RimPoint<F>) -> F {
        Shearing::<RutCurve>::behind(&self.0, point)
    }

    fn edges(&self, rim: &Rim<'_, RutCurve>) -> Edges {
        let mut edges = self.0.open_edges(rim);
        let (patch, radius) = (rim.patch, rim.patch.rolling.system.wheel.radius());
        let beyond = patch.sinkage - rim.curve.rebound;
        if beyond > 0.0 {
            // Ahead of the peak at its own depth, behind it at the mirrored one: the same place in t.
            edges.split((patch.angles.entry - angle_at_depth(beyond / radius)) / rim.front, 0.0..1.0);
        }
        edges.close()
    }
}

/// The forces in a contact whose sinkage counts from the floor of the rut.
///
/// # Errors
/// [`Error::NotFinite`] where a result overflows.
pub(crate) fn forces_in_rut(model: &ForceModel, patch: &ContactPatch<'_>, curve: &RutCurve) -> Result<Forces, Error> {
    const FEW: usize = OneZone::FEW + 1;
    let rim = Rim::pressed(patch, curve);
    let forces = quadrature::forces_by::<_, _, FEW>(model, &rim, &InRut(OneZone(patch)));
    if forces.is_finite() { Ok(forces) } else { Err(Error::NotFinite) }
}
