//! What are the wheels of a rover told: to turn together, or at a slip or under a torque of their own?

use crate::slip::Slip;

/// How the wheels of a station turn.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Turning {
    /// As the [`Drive`] of the rover says.
    Together,
    /// At a slip of their own, such as −1 of a locked wheel.
    AtSlip(Slip),
    /// Under a torque (N·m) of their own, such as 0 of a wheel that rolls freely.
    UnderTorque(f64),
}

/// What the wheels that turn together have in common.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Drive {
    /// Their slip, as by wheels of one speed on even ground.
    OneSlip,
    /// Their torque, as by motors that share a current or by open differentials.
    EqualTorque,
}
