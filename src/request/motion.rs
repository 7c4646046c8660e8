//! The slip of one operating point: given, or by velocities.

use terramechanics::{Circles, Motion, Slip, Velocities, Wheel};
use terramechanics_reading::{Field, Group, Number, Reader};

use super::laws::{field, number};
use crate::quantity::number as shown;

/// A slip ratio.
pub(crate) const RATIO: Number = number(&Slip::RATIO).share().or_meant(by_other_convention);

/// A slip beyond ±1 is often counted over the other velocity: rω/v − 1 of a driving wheel, 1 − v/(rω) of a braking one.
fn by_other_convention(slip: f64) -> String {
    const LARGEST: f64 = 10.0;
    if !(1.0..=LARGEST).contains(&slip.abs()) {
        return String::new();
    }
    let (counted, here) = if slip > 0.0 { ("rω/v − 1", "1 − v/(rω)") } else { ("1 − v/(rω)", "rω/v − 1") };
    format!("; or it is counted as {counted}: as {here} it is {}", shown(slip / (1.0 + slip.abs())))
}

pub(crate) const SLIP: Field<Number> = Field::new(
    Slip::RATIO.name,
    "Slip ratio s [–]: −1 locked, 0 rolling, 1 spinning; driving 1 − v/(rω), braking rω/v − 1.",
    RATIO,
);
const FORWARD_VELOCITY: Field<Number> =
    field(&Velocities::FORWARD, "Forward velocity v of the axle (m/s); with angular_velocity_rad_s instead of slip.");
const ANGULAR_VELOCITY: Field<Number> =
    field(&Velocities::ANGULAR, "Angular velocity ω of the wheel (rad/s), positive when it rolls forward.");

pub(crate) const MOTION: Group = &[&SLIP, &FORWARD_VELOCITY, &ANGULAR_VELOCITY];

/// What is said where there is none.
pub(crate) const REQUIRED: &str = "is required, or both `forward_velocity_m_s` and `angular_velocity_rad_s`";

/// Whether something of a motion was sent, right or wrong.
pub(crate) fn is_given(object: &Reader<'_>) -> bool {
    [&SLIP, &FORWARD_VELOCITY, &ANGULAR_VELOCITY].into_iter().any(|field| object.has(field))
}

/// The motion: from the slip, or from both velocities and the circle of the wheel on which the slip is counted.
pub(crate) fn read(object: &Reader<'_>, wheel: Option<&Wheel>, circles: Option<Circles>) -> Option<Motion> {
    let slip = object.optional(&SLIP);
    let (forward, angular) = (object.optional(&FORWARD_VELOCITY), object.optional(&ANGULAR_VELOCITY));
    match (object.has(&SLIP), [object.has(&FORWARD_VELOCITY), object.has(&ANGULAR_VELOCITY)]) {
        (true, [false, false]) => {
            let slip = Slip::new(slip??).map_err(|error| object.place_of(&SLIP).fault(error)).ok()?;
            Some(Motion::forward(slip))
        }
        (false, [true, true]) => {
            let velocities = Velocities { forward: forward??, angular: angular?? };
            Motion::of(wheel?, circles?.slip, velocities).map_err(|error| object.place_of(&ANGULAR_VELOCITY).fault(error)).ok()
        }
        (true, _) => {
            object.place_of(&SLIP).fault("give either `slip` or both velocities, not both");
            None
        }
        (false, [false, false]) => {
            object.place_of(&SLIP).fault(REQUIRED);
            None
        }
        (false, [there, _]) => {
            let missing = if there { &ANGULAR_VELOCITY } else { &FORWARD_VELOCITY };
            object.place_of(missing).fault("is required with the other velocity");
            None
        }
    }
}
