//! In which direction is the soil sheared under a braking wheel: in one zone, or in two? One of the published laws.
//!
//! A driving wheel always has one zone, so the laws differ at s < 0 only. They do not meet at s = 0, and their papers do not
//! ask for that: see `two_zone`.

mod one_zone;
mod two_zone;

pub use one_zone::OneZone;
pub use two_zone::TwoZone;

use crate::law::family;

family! {
    /// A law for the shear displacement under a braking wheel.
    #[derive(Debug, Clone, Copy, PartialEq, Eq)]
    pub enum Braking {
        /// The letter's: the displacement of a driving wheel, continued to negative slip (Eq. 6 with erratum 11).
        OneZone,
        /// Wong & Reece 1967, part II: soil flows forward ahead of an angle θ0 and backward behind it.
        TwoZone,
    }

    /// Angle θ0 (rad) that parts the zones on a soil with this tan φ (–), if the law has two of them where the circle of the
    /// displacement has this `skid` 1 − 1/κ (–), which is −s of a braking wheel whose slip is counted on it.
    pub(crate) fn reversal(&self, skid: f64, tan_friction: f64) -> Option<f64>;
}
