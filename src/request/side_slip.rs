//! Motion at an angle to the plane of the wheel.

use terramechanics::{Bulldozing, Method, ShearCoupling, SideSlip, SlipAngle};

use super::operation::or_none;
use crate::wire::{Choice, Entry, Number, Scope};

pub(super) const SLIP_ANGLE: Number = Number::within(
    &SlipAngle::ANGLE,
    "Slip angle β (rad) from the velocity to the heading, positive where the wheel moves to its right; quadrature only. Straight ahead unless sent; where it is, the answer has the lateral force and its moments.",
)
.angle();
pub(super) const SHEAR_COUPLING: Choice = Choice {
    doc: "Shear stresses along and across the wheel: independent of each other (Ishigami et al.), or coupled into one along the slip velocity (Pavlov & Johnson), which is nearer to the measurements of `/v1/validation`.",
    words: || vec!["independent", "coupled"],
    default: Some("independent"),
};
pub(super) const BULLDOZING: Choice = Choice {
    doc: "Pressure of the soil on the side wall: full, however small the slip angle (Ishigami et al.), or the share that the sideways displacement has mobilised, which is nearer to the measurements of `/v1/validation`.",
    words: || vec!["full", "mobilised"],
    default: Some("full"),
};

/// The fields that make a wheel move sideways; none of them means that it goes straight ahead.
pub(super) struct SideSlipEntries<'a> {
    pub(super) slip_angle: Entry<'a, f64>,
    pub(super) shear_coupling: Entry<'a, String>,
    pub(super) bulldozing: Entry<'a, String>,
}

impl SideSlipEntries<'_> {
    /// The method at the slip angle, if one was sent; a closed form has none, but goes straight ahead as well as any.
    pub(super) fn check(&self, place: &Scope<'_>, method: Option<Method>) -> Option<Method> {
        let coupling = or_none(&self.shear_coupling, place, |word| match word {
            "independent" => Some(ShearCoupling::Independent),
            "coupled" => Some(ShearCoupling::Coupled),
            _ => None,
        });
        let bulldozing = or_none(&self.bulldozing, place, |word| match word {
            "full" => Some(Bulldozing::Full),
            "mobilised" => Some(Bulldozing::Mobilised),
            _ => None,
        });
        if !self.slip_angle.is_present() {
            return coupling.and(bulldozing).and(method);
        }
        let angle = self.slip_angle.checked(place)?;
        match method? {
            Method::Quadrature => {
                let angle = SlipAngle::new(angle).map_err(|error| place.field(self.slip_angle.name).fault(error)).ok()?;
                Some(Method::SideSlipping(SideSlip {
                    angle,
                    coupling: coupling?.unwrap_or(ShearCoupling::Independent),
                    bulldozing: bulldozing?.unwrap_or(Bulldozing::Full),
                }))
            }
            _ if angle != 0.0 => {
                place
                    .field(self.slip_angle.name)
                    .fault("is taken by the method `quadrature` only: the closed forms have no lateral force");
                None
            }
            method => coupling.and(bulldozing).map(|_| method),
        }
    }
}
