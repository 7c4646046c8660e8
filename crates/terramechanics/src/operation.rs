//! One operating point from start to end: slip, sinkage, forces.

use crate::contact::Angles;
use crate::error::Error;
use crate::forces::{ForceModel, Forces};
use crate::rolling::{Rolling, WheelOnSoil};
use crate::slip::Slip;
use crate::slip_sinkage::SlipSinkage;

/// How the sinkage is known.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Sinkage {
    /// Given (m).
    Given(f64),
    /// From the static sinkage and the slip.
    FromStatic {
        /// Static sinkage z0 (m).
        static_sinkage: f64,
        /// Slip–sinkage law.
        law: SlipSinkage,
    },
    /// Such that the normal force carries this load (N).
    CarryingLoad(f64),
}

/// A wheel on a soil, a way to find its forces and a way to find its sinkage: all but the slip.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Operation {
    /// The wheel on its soil.
    pub system: WheelOnSoil,
    /// How the forces are found.
    pub model: ForceModel,
    /// How the sinkage is known.
    pub sinkage: Sinkage,
}

/// What holds at one slip.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct OperatingPoint {
    /// The slip.
    pub slip: Slip,
    /// Sinkage z (m).
    pub sinkage: f64,
    /// Characteristic angles.
    pub angles: Angles,
    /// Sinkage modulus K_s (Pa/m^N).
    pub sinkage_modulus: f64,
    /// Sinkage exponent N (–).
    pub sinkage_exponent: f64,
    /// The forces on a wheel that moves forward.
    pub forces: Forces,
}

impl Operation {
    /// The operating point at `slip`.
    ///
    /// # Errors
    /// What [`WheelOnSoil::rolling`], [`Rolling::curve`], [`Rolling::contact`], [`ForceModel::forces`] and
    /// [`ForceModel::solve_sinkage`] refuse.
    pub fn at(&self, slip: Slip) -> Result<OperatingPoint, Error> {
        let rolling = self.system.rolling(slip)?;
        let curve = rolling.curve()?;
        let (sinkage, solved) = self.sinkage_of(&rolling)?;
        let patch = rolling.contact(sinkage)?;
        let forces = match solved {
            Some(forces) => forces,
            None => self.model.forces(&patch)?,
        };
        Ok(OperatingPoint {
            slip,
            sinkage,
            angles: patch.angles,
            sinkage_modulus: curve.modulus,
            sinkage_exponent: curve.exponent,
            forces,
        })
    }

    /// The sinkage (m) of the wheel as it rolls, and the forces where finding it has found them too.
    ///
    /// # Errors
    /// What [`ForceModel::solve_sinkage`] refuses.
    pub fn sinkage_of(&self, rolling: &Rolling<'_>) -> Result<(f64, Option<Forces>), Error> {
        match self.sinkage {
            Sinkage::Given(sinkage) => Ok((sinkage, None)),
            Sinkage::FromStatic { static_sinkage, law } => Ok((law.sinkage(static_sinkage, rolling.slip), None)),
            Sinkage::CarryingLoad(load) => {
                let carried = self.model.solve_sinkage(rolling, load)?;
                Ok((carried.sinkage, Some(carried.forces)))
            }
        }
    }
}
