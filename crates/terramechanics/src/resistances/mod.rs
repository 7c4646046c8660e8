//! Which sinkage, resistances and thrust do a vehicle engineer's estimates give from the load alone? Bekker's resistances and
//! thrust (Bekker 1956, 1960, 1969), to be set beside the integral of the stresses.
//!
//! | model | here |
//! |---|---|
//! | sinkage of a rigid wheel, compaction resistance | `compaction.rs` |
//! | bulldozing resistance of a leading wheel | `bulldozing.rs` |
//! | bearing capacity factors | `bearing.rs` |
//! | thrust | `thrust.rs` |
//!
//! They share one simple contact: the wheel sinks like plates that carry the load, and stands on the arc from the entry to the
//! lowest point. There are no shear stresses, and slip does not deepen the sinkage: the exponent is the one without slip, n0.
//! Every pressure–sinkage law can be used through its modulus K_s; the books have Bekker's only. Units: SI, forces in N.
//!
//! Where a soil lacks what an estimate needs, a [`Lacking`] stands in its place; the other estimates are still computed.

mod bearing;
mod bulldozing;
mod compaction;
mod thrust;

use std::fmt;

use crate::caution::{Caution, SINKAGE_BEYOND_ESTIMATES, SLIP_GAIN_UNUSED};
use crate::contact::angle_at_depth;
use crate::error::Error;
use crate::outcome::{pressure_cautions, system_cautions};
use crate::pressure_sinkage::PressureSinkage;
use crate::rolling::WheelOnSoil;
use crate::slip::Slip;

/// The classical estimates for one wheel.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Resistances {
    /// Sinkage z of a rigid wheel without slip (m).
    pub rigid_wheel_sinkage: Result<f64, Lacking>,
    /// Resistance R_c by compaction of the soil under the wheel (N).
    pub compaction: Result<f64, Lacking>,
    /// Resistance R_b by the soil that a leading wheel pushes ahead (N).
    pub bulldozing: Result<f64, Lacking>,
    /// Thrust H, the forward force of the soil's shear before any resistance (N).
    pub thrust: Result<f64, Lacking>,
}

/// What an estimate needs and does not have.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Lacking {
    /// An exponent below 3: the load on a rigid wheel is found with the factor 3 − n.
    ExponentBelowThree {
        /// The exponent n0 of the soil (–).
        exponent: f64,
    },
    /// The unit weight of the soil.
    UnitWeight,
    /// A slip greater than 0.
    DrivingSlip,
    /// Janosi–Hanamoto's shear law, whose mean the thrust is.
    JanosiHanamoto,
}

impl Lacking {
    /// A name for programs.
    #[must_use]
    pub fn code(&self) -> &'static str {
        match self {
            Self::ExponentBelowThree { .. } => "needs_exponent_below_three",
            Self::UnitWeight => "needs_unit_weight",
            Self::DrivingSlip => "needs_driving_slip",
            Self::JanosiHanamoto => "needs_janosi_hanamoto",
        }
    }
}

impl fmt::Display for Lacking {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::ExponentBelowThree { exponent } => {
                write!(f, "Bekker's rigid wheel needs a sinkage exponent below 3, not {exponent}")
            }
            Self::UnitWeight => write!(f, "the soil has no unit weight"),
            Self::DrivingSlip => write!(f, "a slip greater than 0 is needed"),
            Self::JanosiHanamoto => write!(f, "the thrust is known for Janosi–Hanamoto's shear law only"),
        }
    }
}

impl Resistances {
    /// The estimates for a wheel of `system` under `load` (N), with the thrust at `slip`; the rule of the contact has no part
    /// in them.
    ///
    /// # Errors
    /// [`Error::Invalid`] for a load not greater than 0; [`Error::SinkageOutsideWheel`] where the wheel would sink beyond its
    /// axle; [`Error::NotFinite`] where a result overflows; what [`WheelOnSoil::curve`] refuses at rest.
    pub fn of(system: &WheelOnSoil, load: f64, slip: Option<Slip>) -> Result<Self, Error> {
        WheelOnSoil::NORMAL_LOAD.check(load).map_err(Error::Invalid)?;
        let WheelOnSoil { wheel, soil, .. } = system;
        let at_rest = system.curve(Slip::ROLLING)?;
        let sinkage = match compaction::sinkage(wheel, &at_rest, load) {
            Ok(sinkage) => sinkage,
            Err(lacking) => {
                let none = Err(lacking);
                return Ok(Self { rigid_wheel_sinkage: none, compaction: none, bulldozing: none, thrust: none });
            }
        };
        let radius = wheel.radius();
        if !(sinkage > 0.0 && sinkage <= radius) {
            return Err(Error::SinkageOutsideWheel { sinkage, radius });
        }
        let entry = angle_at_depth(sinkage / radius);
        let estimates = Self {
            rigid_wheel_sinkage: Ok(sinkage),
            compaction: Ok(compaction::resistance(wheel, &at_rest, sinkage)),
            bulldozing: bulldozing::resistance(wheel, soil, sinkage, entry),
            thrust: thrust::thrust(wheel, soil, load, entry, slip),
        };
        if estimates.all().iter().all(|estimate| estimate.is_none_or(f64::is_finite)) {
            Ok(estimates)
        } else {
            Err(Error::NotFinite)
        }
    }

    fn all(&self) -> [Option<f64>; 4] {
        [self.rigid_wheel_sinkage, self.compaction, self.bulldozing, self.thrust].map(Result::ok)
    }

    /// Reasons to take the estimates for `system` at `slip` with care.
    pub fn cautions(&self, system: &WheelOnSoil, slip: Option<Slip>) -> impl Iterator<Item = Caution> {
        let diameter = 2.0 * system.wheel.radius();
        let exponent = system.soil.pressure_sinkage().map(PressureSinkage::exponent);
        let changes = |slip: Slip| exponent.is_some_and(|exponent| exponent.at(slip) != exponent.base);
        let slips = slip.is_some_and(|slip| slip != Slip::ROLLING && changes(slip));
        let sinkage = self.rigid_wheel_sinkage.ok();
        let own = [sinkage.and_then(|sinkage| SINKAGE_BEYOND_ESTIMATES.of(sinkage / diameter)), SLIP_GAIN_UNUSED.when(slips)];
        pressure_cautions(system).chain(system_cautions(system)).chain(own.into_iter().flatten())
    }
}
