//! Where does the rim leave the soil? The exit angle θ2, by one of the published rules.

mod angle_ratio;
mod sinkage_ratio;

pub use angle_ratio::AngleRatio;
pub use sinkage_ratio::SinkageRatio;

use crate::law::family;

family! {
    /// Rule for the exit angle θ2.
    #[derive(Debug, Clone, Copy, PartialEq)]
    pub enum ExitRule {
        /// θ2 = c3 θ1.
        AngleRatio(AngleRatio),
        /// θ2 = −arccos(1 − η z/r): the soil behind the wheel reaches up to η z above its lowest point.
        SinkageRatio(SinkageRatio),
    }

    /// θ2 (rad) of a contact with the entry angle `entry` (rad) and `depth_ratio` = z/r (–).
    #[must_use]
    pub fn exit(&self, entry: f64, depth_ratio: f64) -> f64;

    /// The entry angle (rad) of the contact whose exit lies at `angle` (rad) ahead of the lowest point, if the rule has any exit
    /// there.
    pub(super) fn entry_of(&self, angle: f64) -> Option<f64>;

    /// dθ2/dθ1 (–) in a contact that the rule gave, as the wheel sinks.
    pub(super) fn rate(&self, entry: f64, exit: f64) -> f64;
}

impl ExitRule {
    /// The exit at the lowest point.
    pub const LOWEST_POINT: Self = Self::AngleRatio(AngleRatio { c3: 0.0 });
}
