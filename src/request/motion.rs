//! The slip of one operating point: given, or by velocities.

use terramechanics::{Motion, Slip, Velocities, Wheel};
use terramechanics_reading::{Field, Group, Number, Reader};

/// A slip ratio.
pub(super) const RATIO: Number = Number::new("1", -1.0, 1.0).share();

pub(super) const SLIP: Field<Number> =
    Field::new("slip", "Slip ratio s [–]: −1 locked, 0 rolling, 1 spinning; driving 1 − v/(rω), braking rω/v − 1.", RATIO);
const FORWARD_VELOCITY: Field<Number> = Field::new(
    "forward_velocity_m_s",
    "Forward velocity v of the axle (m/s); with angular_velocity_rad_s instead of slip.",
    Number::new("m/s", -1e3, 1e3),
);
const ANGULAR_VELOCITY: Field<Number> = Field::new(
    "angular_velocity_rad_s",
    "Angular velocity ω of the wheel (rad/s), positive when it rolls forward.",
    Number::new("rad/s", -1e4, 1e4),
);

pub(super) const MOTION: Group = &[&SLIP, &FORWARD_VELOCITY, &ANGULAR_VELOCITY];

/// The motion: from the slip, or from both velocities and the wheel.
pub(super) fn read(object: &Reader<'_>, wheel: Option<&Wheel>) -> Option<Motion> {
    let slip = object.optional(&SLIP);
    let (forward, angular) = (object.optional(&FORWARD_VELOCITY), object.optional(&ANGULAR_VELOCITY));
    match (object.has(&SLIP), [object.has(&FORWARD_VELOCITY), object.has(&ANGULAR_VELOCITY)]) {
        (true, [false, false]) => {
            let slip = Slip::new(slip??).map_err(|error| object.place_of(&SLIP).fault(error)).ok()?;
            Some(Motion::forward(slip))
        }
        (false, [true, true]) => {
            let velocities = Velocities { forward: forward??, angular: angular?? };
            Motion::of(wheel?, velocities).map_err(|error| object.place_of(&ANGULAR_VELOCITY).fault(error)).ok()
        }
        (true, _) => {
            object.place_of(&SLIP).fault("give either `slip` or both velocities, not both");
            None
        }
        (false, [false, false]) => {
            object.place_of(&SLIP).fault("is required, or both `forward_velocity_m_s` and `angular_velocity_rad_s`");
            None
        }
        (false, [there, _]) => {
            let missing = if there { &ANGULAR_VELOCITY } else { &FORWARD_VELOCITY };
            object.place_of(missing).fault("is required with the other velocity");
            None
        }
    }
}
