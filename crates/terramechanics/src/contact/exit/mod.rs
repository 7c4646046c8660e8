//! Where does the rim leave the soil? The exit angle θ2, by one of the published rules.

mod angle_ratio;
mod sinkage_ratio;

pub use angle_ratio::AngleRatio;
pub use sinkage_ratio::SinkageRatio;

use crate::law::family;
use crate::numerics::elementary::Number;

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
}

impl ExitRule {
    /// The same as [`ExitRule::exit`], for one contact or several side by side.
    #[inline(always)]
    pub(super) fn place<F: Number>(&self, entry: F, depth_ratio: F) -> F {
        match self {
            Self::AngleRatio(rule) => rule.exit(entry, depth_ratio),
            Self::SinkageRatio(rule) => rule.exit(entry, depth_ratio),
        }
    }

    /// dθ2/dθ1 (–) as the wheel sinks, at z/r.
    #[inline(always)]
    pub(super) fn rate<F: Number>(&self, depth_ratio: F) -> F {
        match self {
            Self::AngleRatio(rule) => depth_ratio.like(rule.c3),
            Self::SinkageRatio(rule) => rule.rate(depth_ratio),
        }
    }

    /// The exit at the lowest point.
    pub const LOWEST_POINT: Self = Self::AngleRatio(AngleRatio { c3: 0.0 });
}
