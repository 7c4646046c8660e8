//! Into how many zones does the soil under a braking wheel part? Which way it is sheared, by one of the published laws.
//!
//! A driving wheel knows one zone only: the laws differ at s < 0. They do not join at s = 0, nor do their papers ask for it:
//! see [`two_zone`].

mod two_zone;

pub(crate) use two_zone::Zones;

use crate::slip::Slip;
use crate::soil::Soil;

/// A law for the shear displacement under a braking wheel.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Braking {
    /// The letter's: the displacement of a driving wheel, continued to negative slip (Eq. 6 with erratum 11).
    OneZone,
    /// Wong & Reece 1967, part II: soil flows forward ahead of an angle θ0 and backward behind it.
    TwoZone,
}

impl Braking {
    /// Angle θ0 (rad) that parts the zones, if the law has two of them at `slip`.
    pub(crate) fn reversal(self, slip: Slip, soil: &Soil) -> Option<f64> {
        match self {
            Self::TwoZone if !slip.is_driving() => Some(two_zone::reversal(slip, soil.tan_friction())),
            Self::OneZone | Self::TwoZone => None,
        }
    }
}
