//! What a tracker reports about the samples so far.

use super::{CautionTally, CulpritTally, Status, Tally, Tracker};
use crate::events::Event;
use crate::rolling::WheelOnSoil;

impl Tracker {
    /// The events that have ended, and the number of further ones that were not kept.
    #[must_use]
    pub fn events(&self) -> (&[Event], u64) {
        (&self.events, self.events_left_out)
    }

    /// Samples so far.
    #[must_use]
    pub fn rows(&self) -> u64 {
        self.rows
    }

    /// Count of the samples with this status, if there were any.
    #[must_use]
    pub fn tally(&self, status: Status) -> Option<&Tally> {
        self.tallies[status as usize].as_ref()
    }

    /// The values for which samples were refused, one entry for each status and channel.
    #[must_use]
    pub fn culprits(&self) -> &[CulpritTally] {
        &self.culprits
    }

    /// Count of the good samples without a pull by the coupled form, because their measured torque is missing.
    #[must_use]
    pub fn missing_torque(&self) -> Option<&Tally> {
        self.missing_torque.as_ref()
    }

    /// Count of the good samples without a pull by the coupled form, because their load is missing.
    #[must_use]
    pub fn missing_load(&self) -> Option<&Tally> {
        self.missing_load.as_ref()
    }

    /// The wheel on its soil.
    #[must_use]
    pub fn system(&self) -> &WheelOnSoil {
        &self.operation.system
    }

    /// Count of the good samples for which the coupled form has no solution, if there were any.
    #[must_use]
    pub fn not_coupled(&self) -> Option<&Tally> {
        self.not_coupled.as_ref()
    }

    /// Cautions about the good samples, one entry for each kind.
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
