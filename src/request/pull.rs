//! What tells the slip of one operating point: the motion, or the pull that the wheel is to give.

use terramechanics::{Circles, Motion, Pull, Wheel};
use terramechanics_reading::{Field, Group, Number, Reader};

use super::laws::field;
use super::motion::{self, SLIP};

const LONGITUDINAL_FORCE: Field<Number> =
    field(&Pull::FORCE, "Longitudinal force F_x (N) that the wheel is to give, in place of the slip, which is solved.");
const DRAWBAR_COEFFICIENT: Field<Number> = field(
    &Pull::COEFFICIENT,
    "Drawbar coefficient F_x/F_z (–) that the wheel is to give, in place of the slip, which is solved.",
);

pub(crate) const PULL: Group = &[&LONGITUDINAL_FORCE, &DRAWBAR_COEFFICIENT];

/// What tells the slip.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) enum SlipFrom {
    /// It is given, or follows from the velocities.
    Motion(Motion),
    /// It is the one that gives a pull, of a wheel that moves forward.
    Pull(Pull),
}

/// The motion or the pull, of which there is one.
pub(crate) fn read(object: &Reader<'_>, wheel: Option<&Wheel>, circles: Option<Circles>) -> Option<SlipFrom> {
    let fields = [&LONGITUDINAL_FORCE, &DRAWBAR_COEFFICIENT];
    let given: Vec<_> = fields.into_iter().filter(|field| object.has(field)).collect();
    let values = fields.map(|field| object.optional(field).flatten());
    if given.is_empty() && !motion::is_given(object) {
        let [force, coefficient] = fields.map(|field| field.name);
        let place = object.place_of(&SLIP);
        place.fault(format_args!("{}; or `{force}` or `{coefficient}`, for which it is solved", motion::REQUIRED));
        return None;
    }
    if given.is_empty() {
        return motion::read(object, wheel, circles).map(SlipFrom::Motion);
    }
    if given.len() > 1 || motion::is_given(object) {
        let [force, coefficient] = fields.map(|field| field.name);
        for field in given {
            let place = object.place_of(field);
            place.fault(format_args!("only one of `{}`, both velocities, `{force}` and `{coefficient}` may be given", SLIP.name));
        }
        return None;
    }
    let [force, coefficient] = values;
    force.map(Pull::Force).or(coefficient.map(Pull::Coefficient)).map(SlipFrom::Pull)
}
