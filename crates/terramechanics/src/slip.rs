//! How much does the wheel slip? The slip ratio (letter, Eq. 2).
//!
//! Convention: −1 (locked) … 0 (rolling) … 1 (spinning on the spot). Driving, rω ≥ v: s = 1 − v/(rω). Braking: s = rω/v − 1.

use crate::error::Error;
use crate::parameter::{Parameter, Presence, Requirement};

/// Slip ratio s from −1 to 1, positive when driving, negative when braking. Eq. (2).
#[derive(Debug, Clone, Copy, PartialEq, PartialOrd)]
pub struct Slip(f64);

impl Slip {
    /// A wheel that is dragged without turning.
    pub const LOCKED: Self = Self(-1.0);
    /// A wheel that rolls without slip.
    pub const ROLLING: Self = Self(0.0);
    /// A wheel that turns on the spot.
    pub const SPINNING: Self = Self(1.0);

    /// s.
    pub const RATIO: Parameter = Parameter {
        name: "slip",
        symbol: "s",
        unit: "1",
        meaning: "Slip ratio: −1 locked, 0 rolling, 1 spinning on the spot.",
        requirement: Requirement::Within { min: -1.0, max: 1.0 },
        least: -1.0,
        most: 1.0,
        presence: Presence::Required,
    };

    /// Checks the ratio.
    ///
    /// # Errors
    /// [`Error::Invalid`] unless −1 ≤ s ≤ 1.
    pub fn new(ratio: f64) -> Result<Self, Error> {
        Self::RATIO.check(ratio).map(Self).map_err(Error::Invalid)
    }

    /// The ratio s.
    #[must_use]
    pub fn ratio(self) -> f64 {
        self.0
    }

    /// Whether the wheel drives or rolls freely (s ≥ 0) rather than brakes.
    #[must_use]
    pub fn is_driving(self) -> bool {
        self.0 >= 0.0
    }

    /// Whether the wheel does not turn (s = −1).
    #[must_use]
    pub fn is_locked(self) -> bool {
        self.0 <= -1.0
    }
}
