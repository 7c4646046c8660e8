//! Motion at an angle to the plane of the wheel.

use terramechanics::{Bulldozing, Method, ShearCoupling, SideSlip, SlipAngle};
use terramechanics_reading::{Field, Group, Number, Reader, Word};

use super::laws::field;

const SLIP_ANGLE: Field<Number> = field(
    &SlipAngle::ANGLE,
    "Slip angle β (rad) from the velocity to the heading, positive where the wheel moves to its right; quadrature only. Where it is sent, the answer has the lateral force and its moments; otherwise the wheel goes straight ahead.",
);
pub(super) const SHEAR_COUPLING: Field<Word<ShearCoupling>> = Field::new(
    "shear_coupling",
    "Shear stresses along and across the wheel: independent of each other (Ishigami et al.), or coupled into one along the slip velocity (Pavlov & Johnson), which is nearer to the measurements of `/v1/validation`.",
    Word::new(&[("independent", ShearCoupling::Independent), ("coupled", ShearCoupling::Coupled)]).or(ShearCoupling::Independent),
);
pub(super) const BULLDOZING: Field<Word<Bulldozing>> = Field::new(
    "bulldozing",
    "Pressure of the soil on the side wall: full, however small the slip angle (Ishigami et al.), or the share that the sideways displacement has mobilised, which is nearer to the measurements of `/v1/validation`.",
    Word::new(&[("full", Bulldozing::Full), ("mobilised", Bulldozing::Mobilised)]).or(Bulldozing::Full),
);

pub(crate) const SIDE_SLIP: Group = &[&SLIP_ANGLE, &SHEAR_COUPLING, &BULLDOZING];

/// The method at the slip angle, if one was sent; a closed form has none, but goes straight ahead as well as any.
pub(crate) fn read(object: &Reader<'_>, method: Option<Method>) -> Option<Method> {
    let coupling = object.or_default(&SHEAR_COUPLING);
    let bulldozing = object.or_default(&BULLDOZING);
    let angle = object.optional(&SLIP_ANGLE);
    let (coupling, bulldozing, method) = (coupling?, bulldozing?, method?);
    let Some(angle) = angle? else { return Some(method) };
    match method {
        Method::Quadrature => {
            let angle = SlipAngle::new(angle).map_err(|error| object.place_of(&SLIP_ANGLE).fault(error)).ok()?;
            Some(Method::SideSlipping(SideSlip { angle, coupling, bulldozing }))
        }
        _ if angle != 0.0 => {
            let of_others = match method {
                Method::ResistiveForce => "the stresses of dry grains are known in the plane of the wheel alone",
                _ => "the closed forms have no lateral force",
            };
            object.place_of(&SLIP_ANGLE).fault(format_args!("is taken by the method `quadrature` only: {of_others}"));
            Some(method)
        }
        method => Some(method),
    }
}
