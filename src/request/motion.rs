//! The slip of one operating point: given, or by velocities.

use terramechanics::{Motion, Slip, Velocities, Wheel};

use crate::wire::{Entry, Scope};

/// The fields that give the slip of one operating point.
pub(super) struct MotionEntries<'a> {
    pub(super) slip: Entry<'a, f64>,
    pub(super) forward_velocity: Entry<'a, f64>,
    pub(super) angular_velocity: Entry<'a, f64>,
}

impl MotionEntries<'_> {
    /// The motion: from the slip, or from both velocities and the wheel.
    pub(super) fn check(&self, place: &Scope<'_>, wheel: Option<&Wheel>) -> Option<Motion> {
        let slip = self.slip.checked(place);
        let (forward, angular) = (self.forward_velocity.checked(place), self.angular_velocity.checked(place));
        let velocities = [&self.forward_velocity, &self.angular_velocity].map(Entry::is_present);
        match (self.slip.is_present(), velocities) {
            (true, [false, false]) => {
                let slip = Slip::new(slip?).map_err(|error| place.field(self.slip.name).fault(error)).ok()?;
                Some(Motion::forward(slip))
            }
            (false, [true, true]) => {
                let velocities = Velocities { forward: forward?, angular: angular? };
                Motion::of(wheel?, velocities).map_err(|error| place.field(self.angular_velocity.name).fault(error)).ok()
            }
            (true, _) => {
                place.field(self.slip.name).fault("give either `slip` or both velocities, not both");
                None
            }
            (false, [false, false]) => {
                place.field(self.slip.name).fault("is required, or both `forward_velocity_m_s` and `angular_velocity_rad_s`");
                None
            }
            (false, [there, _]) => {
                let missing = if there { &self.angular_velocity } else { &self.forward_velocity };
                place.field(missing.name).fault("is required with the other velocity");
                None
            }
        }
    }
}
