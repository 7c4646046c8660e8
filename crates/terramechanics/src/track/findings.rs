//! What a run says of its samples.

use super::{CautionTally, CulpritTally, Status, Tally, Tracker};
use crate::events::Event;
use crate::rolling::WheelOnSoil;

impl Tracker {
    /// The events that have ended, and how many more there were than are kept.
    #[must_use]
    pub fn events(&self) -> (&[Event], u64) {
        (&self.events, self.events_left_out)
    }

    /// Samples so far.
    #[must_use]
    pub fn rows(&self) -> u64 {
        self.rows
    }

    /// The samples of a status, if there were any.
    #[must_use]
    pub fn tally(&self, status: Status) -> Option<&Tally> {
        self.tallies[status as usize].as_ref()
    }

    /// What is wrong with the values of the samples that were refused: one of each status and channel.
    #[must_use]
    pub fn culprits(&self) -> &[CulpritTally] {
        &self.culprits
    }

    /// The good samples whose measured torque is missing, so that there is no pull by the coupled form, if there were any.
    #[must_use]
    pub fn missing_torque(&self) -> Option<&Tally> {
        self.missing_torque.as_ref()
    }

    /// The same for the load.
    #[must_use]
    pub fn missing_load(&self) -> Option<&Tally> {
        self.missing_load.as_ref()
    }

    /// The wheel that is followed, on its soil.
    #[must_use]
    pub fn system(&self) -> &WheelOnSoil {
        &self.operation.system
    }

    /// The good samples for which the coupled form has no answer, if there were any.
    #[must_use]
    pub fn not_coupled(&self) -> Option<&Tally> {
        self.not_coupled.as_ref()
    }

    /// What is to be said of the good samples: one of each kind.
    #[must_use]
    pub fn cautions(&self) -> &[CautionTally] {
        &self.cautions
    }

    /// Whether the wheel moved backward at a good sample.
    #[must_use]
    pub fn has_moved_backward(&self) -> bool {
        self.backward
    }
}
