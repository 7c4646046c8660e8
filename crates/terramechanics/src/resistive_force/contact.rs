//! What does a method see of a wheel? Its motion and its contact, with the laws and rules that the method needs and no others.

use super::LeadingEdge;
use crate::error::Error;
use crate::forces::{ForceModel, Method};
use crate::patch::ContactPatch;
use crate::rolling::{Rolling, WheelOnSoil};
use crate::slip::Slip;
use crate::stress::Stresses;

impl ForceModel {
    /// The wheel of `system` rolling at `slip`, as this method sees it: by the resistive force method the laws of the soil are not
    /// asked for, and what follows is for this method alone.
    ///
    /// # Errors
    /// What [`WheelOnSoil::rolling`] refuses; nothing by the resistive force method.
    #[inline]
    pub fn rolling<'a>(&self, system: &'a WheelOnSoil, slip: Slip) -> Result<Rolling<'a>, Error> {
        match self.method {
            Method::ResistiveForce => Ok(system.rolling_in_grains(slip)),
            Method::Quadrature | Method::SideSlipping(_) | Method::Linearised { .. } | Method::Explicit { .. } => {
                system.rolling(slip)
            }
        }
    }

    /// The contact at `sinkage` z (m), as this method sees it. By the resistive force method it is the leading edge, from the entry
    /// to the lowest point, and θm is where its normal stress is largest: the rules of the contact have no part in it, and θm may be
    /// 0, the exit itself.
    ///
    /// # Errors
    /// What [`Rolling::contact`] refuses; by the resistive force method [`Error::SinkageOutsideWheel`] unless 0 < z ≤ r.
    #[inline]
    pub fn contact<'a>(&self, rolling: &'a Rolling<'a>, sinkage: f64) -> Result<ContactPatch<'a>, Error> {
        match self.method {
            Method::ResistiveForce => {
                let edge = LeadingEdge::of_unit_stiffness(rolling, sinkage)?; // θm does not depend on the stiffness
                rolling.leading_contact(sinkage, edge.peak())
            }
            Method::Quadrature | Method::SideSlipping(_) | Method::Linearised { .. } | Method::Explicit { .. } => {
                rolling.contact(sinkage)
            }
        }
    }

    /// Stresses (Pa) at `theta` (rad) of the rim by this method; 0 outside the contact.
    ///
    /// # Errors
    /// [`Error::MissingLaw`] for what the method needs of the soil.
    ///
    /// ```
    /// use terramechanics::*;
    /// // A locked wheel moves level, γ = π, at its lowest point: α_z = 0.206 + 0.169 and α_x = 0.124 − 0.253 − 0.007, times
    /// // ξ z = 2e6 · 0.02 Pa.
    /// let soil = Soil::new(SoilParams { granular_stiffness: Some(2e6), ..SoilParams::BARE })?;
    /// let wheel = Wheel::new(WheelParams { radius: 0.2, width: 0.1, lug_height: 0.0, lug_coefficient: 0.5 })?;
    /// let system = WheelOnSoil { wheel, soil, contact: Contact::MIDPOINT };
    /// let model = ForceModel::at_rim(Method::ResistiveForce);
    /// let rolling = model.rolling(&system, Slip::LOCKED)?;
    /// let stresses = model.stresses_at(&model.contact(&rolling, 0.02)?, 0.0)?;
    /// assert!((stresses.normal - 15_000.0).abs() < 1e-9 && (stresses.shear + 5440.0).abs() < 1e-9);
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    pub fn stresses_at(&self, patch: &ContactPatch<'_>, theta: f64) -> Result<Stresses, Error> {
        match self.method {
            Method::ResistiveForce => {
                let edge = LeadingEdge::of(patch.rolling, patch.sinkage)?;
                Ok(edge.at_angle(theta).map_or(Stresses { normal: 0.0, shear: 0.0 }, |place| edge.stresses(&place)))
            }
            Method::Quadrature | Method::SideSlipping(_) | Method::Linearised { .. } | Method::Explicit { .. } => {
                Ok(patch.stresses()?.at(theta))
            }
        }
    }
}
